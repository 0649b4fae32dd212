// Colours go by experiment, references are grey. Panels are in the order of
// measures and seasons, so that two seasons of two measures make a row.

#include "runtime/report/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/pictures/svg_panels.h"
#include "runtime/report/chart_panel.h"
#include "runtime/report/comparison.h"

namespace plsc {

namespace {

constexpr int kWidth = 320;  // px, of a panel
constexpr int kHeight = 240;
constexpr double kLeft = 52;  // px, for labels
constexpr double kBottom = 30;
constexpr double kTop = 6;

constexpr const char* kStyle =
    ".grid{stroke:#ddd;fill:none} .tick{font-size:12px;text-anchor:end} "
    ".label{font-size:12px} .middle{stroke:#000;stroke-width:2;fill:none} "
    ".whisker{stroke:#444;fill:none} .run{fill:#000;fill-opacity:0.45} "
    ".mean{fill:#fff;stroke:#000}";

/// Okabe and Ito's that can be seen as lines on white.
std::string ColourOf(const StudyReport& report, std::size_t experiment) {
  static constexpr const char* kColours[] = {"#0072b2", "#d55e00", "#009e73",
                                             "#cc79a7", "#e69f00", "#56b4e9"};
  if (report.experiments[experiment].is_static) return "#888888";
  std::size_t number = 0;
  for (std::size_t i = 0; i < experiment; ++i)
    if (!report.experiments[i].is_static) ++number;
  return kColours[number % std::size(kColours)];
}

std::string Dashes(const StudyReport& report, std::size_t experiment) {
  return report.experiments[experiment].is_static ? R"( stroke-dasharray="6 4")"
                                                  : "";
}

std::vector<LegendEntry> LegendOf(const StudyReport& report) {
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < report.experiments.size(); ++i)
    legend.push_back(
        {fmt::format(R"(<path d="M-14 0H14" stroke="{}" stroke-width="5"{}/>)",
                     ColourOf(report, i), Dashes(report, i)),
         report.experiments[i].name});
  return legend;
}

Panel PanelOf(const StudyReport& report, std::size_t measure,
              std::size_t season, std::string svg) {
  const ReportMeasure& one = report.measures[measure];
  return {one.title,
          report.seasons[season] + (one.unit.empty() ? "" : ", " + one.unit),
          std::move(svg),
          0,
          0,
          kWidth,
          kHeight};
}

/// A panel of each measure and season in which `items` has any.
template <typename Item, typename Draw>
std::vector<Panel> PanelsOf(const StudyReport& report,
                            const std::vector<Item>& items, const Draw& draw) {
  std::vector<Panel> panels;
  for (std::size_t measure = 0; measure < report.measures.size(); ++measure)
    for (std::size_t season = 0; season < report.seasons.size(); ++season) {
      std::vector<const Item*> here;
      for (const Item& item : items)
        if (item.measure == measure && item.season == season)
          here.push_back(&item);
      if (!here.empty())
        panels.push_back(PanelOf(report, measure, season, draw(here)));
    }
  return panels;
}

std::string Box(const Finals& finals, const ChartScale& y, double x,
                double half, const std::string& colour) {
  const BoxPlot& box = finals.box;
  std::string svg = fmt::format(
      R"(<path d="M{0:.1f} {1:.1f}V{2:.1f}M{0:.1f} {3:.1f}V{4:.1f}" )"
      R"(class="whisker"/><rect x="{5:.1f}" y="{2:.1f}" width="{6:.1f}" )"
      R"(height="{7:.1f}" fill="{8}" fill-opacity="0.6" stroke="{8}"/>)"
      R"(<path d="M{5:.1f} {9:.1f}h{6:.1f}" class="middle"/>)"
      "\n",
      x, y(box.high_whisker), y(box.quartiles.high), y(box.quartiles.low),
      y(box.low_whisker), x - half, 2 * half,
      y(box.quartiles.low) - y(box.quartiles.high), colour,
      y(box.quartiles.median));
  // Side by side in turn, so that equal ones are seen.
  constexpr int kPlaces = 5;
  for (std::size_t i = 0; i < finals.values.size(); ++i)
    svg += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="2" class="run"/>)",
                       x + half * (static_cast<double>(i % kPlaces) - 2) / 4,
                       y(finals.values[i].value));
  return svg + fmt::format(
                   R"(<path d="M{:.1f} {:.1f}l4 4l-4 4l-4 -4z" class="mean"/>)"
                   "\n",
                   x, y(box.mean) - 4);
}

std::string Boxes(const StudyReport& report,
                  const std::vector<const Finals*>& here) {
  std::vector<double> values;
  for (const Finals* one : here)
    for (const RunValue& value : one->values) values.push_back(value.value);
  const ChartScale y = ScaleOf(values, kHeight - kBottom, kTop);
  std::string svg = ChartGrid(y, kLeft, kWidth);
  // A place each, and one between relived and recorded.
  const bool has_both = here.front()->told != here.back()->told;
  const auto places = static_cast<double>(here.size() + (has_both ? 1 : 0));
  const double step = (kWidth - kLeft) / places;
  constexpr double kWidest = 22;  // px
  const double half = std::min(kWidest, 0.35 * step);
  double x = kLeft + step / 2;
  double begin = x;
  for (std::size_t i = 0; i < here.size(); ++i) {
    svg += Box(*here[i], y, x, half, ColourOf(report, here[i]->experiment));
    const bool is_last =
        i + 1 == here.size() || here[i + 1]->told != here[i]->told;
    if (is_last) {
      svg += fmt::format(R"(<text x="{:.1f}" y="{}" class="label">{}</text>)"
                         "\n",
                         (begin + x) / 2, kHeight - 8,
                         NameIn(kToldNames, here[i]->told));
      x += step;
      begin = x + step;
    }
    x += step;
  }
  return svg;
}

/// The part of a path through all points that are numbers.
std::string Through(const std::vector<std::pair<double, double>>& points) {
  std::string path;
  for (const auto& [x, y] : points)
    if (std::isfinite(y))
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, y);
  return path;
}

std::string Lines(const StudyReport& report, const Curve& curve,
                  const ChartScale& x, const ChartScale& y) {
  std::vector<std::pair<double, double>> middle;
  std::vector<std::pair<double, double>> band;
  for (std::size_t i = 0; i < curve.quartiles.size(); ++i) {
    const double at = x(static_cast<double>(i));
    middle.emplace_back(at, y(curve.quartiles[i].median));
    band.emplace_back(at, y(curve.quartiles[i].high));
  }
  for (std::size_t i = curve.quartiles.size(); i-- > 0;)
    band.emplace_back(x(static_cast<double>(i)), y(curve.quartiles[i].low));
  const std::string colour = ColourOf(report, curve.experiment);
  std::string svg;
  // References are a line, as the paper's are.
  if (!report.experiments[curve.experiment].is_static)
    svg = fmt::format(R"(<path d="{}Z" fill="{}" fill-opacity="0.2"/>)",
                      Through(band), colour);
  return svg + fmt::format(R"(<path d="{}" fill="none" stroke="{}" )"
                           R"(stroke-width="2"{}/>)"
                           "\n",
                           Through(middle), colour,
                           Dashes(report, curve.experiment));
}

std::string Curves(const StudyReport& report,
                   const std::vector<const Curve*>& here) {
  std::vector<double> values;
  std::size_t generations = 2;
  for (const Curve* curve : here) {
    generations = std::max(generations, curve->quartiles.size());
    for (const Quartiles& one : curve->quartiles) {
      values.push_back(one.median);
      if (report.experiments[curve->experiment].is_static) continue;
      values.push_back(one.low);
      values.push_back(one.high);
    }
  }
  const ChartScale y = ScaleOf(values, kHeight - kBottom, kTop);
  const ChartScale x{0, static_cast<double>(generations - 1), kLeft,
                     kWidth - 8.0};
  std::string svg = ChartGrid(y, kLeft, kWidth);
  for (const double tick : RoundTicks(x.low, x.high, 4))
    if (tick == std::floor(tick))
      svg +=
          fmt::format(R"(<text x="{:.1f}" y="{}" class="label">{:.0f}</text>)"
                      "\n",
                      x(tick), kHeight - 8, tick);
  for (const Curve* curve : here) svg += Lines(report, *curve, x, y);
  return svg;
}

}  // namespace

std::string BoxesFigure(const StudyReport& report) {
  std::vector<Finals> finals = FinalsOf(report, Counted::kMean, Told::kRelived);
  for (Finals& one : FinalsOf(report, Counted::kMean, Told::kRecorded))
    finals.push_back(std::move(one));
  return PanelsSvg(
      fmt::format("{}, generation {}", report.title, report.generation),
      PanelsOf(report, finals,
               [&](const std::vector<const Finals*>& here) {
                 return Boxes(report, here);
               }),
      LegendOf(report), kStyle);
}

std::string CurvesFigure(const StudyReport& report) {
  return PanelsSvg(report.title + ", by generation",
                   PanelsOf(report, CurvesOf(report),
                            [&](const std::vector<const Curve*>& here) {
                              return Curves(report, here);
                            }),
                   LegendOf(report), kStyle);
}

}  // namespace plsc
