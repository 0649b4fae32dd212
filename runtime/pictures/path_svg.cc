// Seasons side by side at one scale, so that ways can be compared by eye,
// unless that would make one a speck: then each has its own, as its bar says. A
// path is drawn as pieces of one tone each from light to dark, which shows its
// direction without arrows and in print; points closer than a pixel are left
// out, so that a robot that trembles for an hour is not a megabyte.

#include "runtime/pictures/path_svg.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include "grammar/utf8.h"
#include "runtime/pictures/map_view.h"
#include "runtime/pictures/svg_style.h"
#include "runtime/pictures/top_view.h"
#include "runtime/recording/recording.h"
#include "runtime/text/quantity.h"
#include "runtime/text/xml.h"

namespace plsc {

namespace {

constexpr double kPlot = 380;        // px, side of a season's square
constexpr double kPathGap = 20;      // px, around it
constexpr double kTitle = 34;        // px, the genotype's name
constexpr double kPathHeading = 44;  // px, two lines above a square
constexpr double kFooting = 26;      // px, the line below it
constexpr int kPathsInRow = 4;       // wider pictures do not fit screens
constexpr double kFilled = 0.86;     // of a square that the widest season takes
// px per m: 25 cm fill a square; a robot that rests is not made a monster.
constexpr double kMaxScale = 1520;
// Between the widest season and one that shares its scale.
constexpr double kMostRatio = 4;
constexpr double kFinest = 1;             // px, the shortest piece of a path
constexpr int kTones = 24;                // of the path's colour
constexpr int kMostDots = 30;             // on a path
constexpr std::size_t kMostLetters = 49;  // of a heading of 400 px at 13 px

Eigen::AlignedBox2d ExtentOf(const RecordedSeason& season) {
  Eigen::AlignedBox2d extent;
  const Eigen::Matrix3Xd path = MassCentres(season);
  for (Eigen::Index i = 0; i < path.cols(); ++i)
    extent.extend(Eigen::Vector2d(path.col(i).head<2>()));
  const Eigen::Index last = std::max<Eigen::Index>(path.cols() - 1, 0);
  for (const Eigen::Index sample : {Eigen::Index{0}, last})
    for (const Outline& outline : TopView(season, sample))
      for (const Eigen::Vector2d& corner : outline.corners)
        extent.extend(corner);
  if (extent.isEmpty()) extent.extend(Eigen::Vector2d(0, 0));
  return extent;
}

// px per m, by season: one scale for all, so that ways can be compared; but
// where that would make one a speck beside another, to each its own.
std::vector<double> ScalesFor(const Recording& recording) {
  std::vector<double> scales;
  for (const RecordedSeason& season : recording.seasons)
    scales.push_back(std::min(
        kMaxScale,
        kFilled * kPlot / std::max(ExtentOf(season).sizes().maxCoeff(), 1e-9)));
  if (scales.empty()) return scales;
  const auto [least, most] = std::minmax_element(scales.begin(), scales.end());
  if (*most <= kMostRatio * *least)
    scales.assign(scales.size(), double{*least});
  return scales;
}

// One hue from light to dark: the order can be seen without colours, too.
std::string Tone(double share) {
  const auto part = [&](int light, int dark) {
    return static_cast<int>(std::lround(light + share * (dark - light)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", part(0x8e, 0x08), part(0xc0, 0x1d),
                     part(0xe4, 0x58));
}

std::string PolygonSvg(const Outline& outline, const MapView& view,
                       std::string_view style) {
  std::string points;
  for (const Eigen::Vector2d& corner : outline.corners) {
    const Eigen::Vector2d at = view(corner);
    fmt::format_to(std::back_inserter(points), "{}{:.1f},{:.1f}",
                   points.empty() ? "" : " ", at.x(), at.y());
  }
  return fmt::format("<polygon points=\"{}\" {}/>\n", points, style);
}

std::string BodySvgOf(const RecordedSeason& season, Eigen::Index sample,
                      const MapView& view, bool is_start) {
  std::string svg;
  for (const Outline& outline : TopView(season, sample))
    svg += PolygonSvg(outline, view,
                      is_start ? std::string("class=\"start\"")
                               : fmt::format("class=\"end\" fill=\"{}\"",
                                             ModuleColour(outline.type)));
  return svg;
}

// Samples at which the path is at least a pixel further on.
std::vector<Eigen::Index> Waypoints(const Eigen::Matrix3Xd& path,
                                    double scale) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < path.cols(); ++i)
    if (kept.empty() || i + 1 == path.cols() ||
        (path.col(i) - path.col(kept.back())).head<2>().norm() * scale >=
            kFinest)
      kept.push_back(i);
  return kept;
}

std::string PathLineSvg(const Eigen::Matrix3Xd& path, const MapView& view) {
  const std::vector<Eigen::Index> kept = Waypoints(path, view.scale);
  std::string svg;
  std::string points;
  int tone = -1;
  const auto finish = [&] {
    if (!points.empty())
      fmt::format_to(std::back_inserter(svg),
                     "<polyline points=\"{}\" class=\"path\" stroke=\"{}\"/>\n",
                     points, Tone(tone / (kTones - 1.0)));
    points.clear();
  };
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const Eigen::Index i = kept[k];
    const Eigen::Vector2d at = view(path.col(i).head<2>());
    const std::string point = fmt::format("{:.1f},{:.1f}", at.x(), at.y());
    const int now = static_cast<int>(kTones * static_cast<double>(i) /
                                     static_cast<double>(path.cols()));
    points += (points.empty() ? "" : " ") + point;
    if (now == tone) continue;
    if (tone >= 0) finish();
    tone = now;
    points = point;
  }
  finish();
  return svg;
}

// s, between dots: so that they are few enough to be counted.
double DotInterval(double duration) {
  for (double power = 1;; power *= 10)
    for (const double factor : {1, 2, 5})
      if (duration / (factor * power) <= kMostDots) return factor * power;
}

std::string DotsSvg(const Motion& motion, const Eigen::Matrix3Xd& path,
                    const MapView& view) {
  const double duration = motion.TimeOf(path.cols() - 1) - motion.begin;
  const double interval = DotInterval(duration);
  std::string svg;
  double due = 0;
  for (Eigen::Index i = 0; i < path.cols(); ++i) {
    // Half a sample early is near enough, and no rounding can miss one.
    if (motion.TimeOf(i) - motion.begin < due - 0.5 * motion.step) continue;
    due += interval;
    const Eigen::Vector2d at = view(path.col(i).head<2>());
    fmt::format_to(
        std::back_inserter(svg),
        R"(<circle cx="{:.1f}" cy="{:.1f}" r="3" class="dot" fill="{}"/>)"
        "\n",
        at.x(), at.y(),
        Tone(static_cast<double>(i) / static_cast<double>(path.cols())));
  }
  return svg;
}

// Lines as far apart as the scale bar is long, through the origin.
std::string GridSvg(const MapView& view, double spacing) {
  std::string svg;
  const double half = view.side / view.scale / 2;
  for (const int axis : {0, 1}) {
    const double low = view.centre(axis) - half;
    const double high = view.centre(axis) + half;
    for (double k = std::ceil(low / spacing); k * spacing <= high; ++k) {
      Eigen::Vector2d from = view.centre - Eigen::Vector2d::Constant(half);
      Eigen::Vector2d to = view.centre + Eigen::Vector2d::Constant(half);
      from(axis) = to(axis) = k * spacing;
      const Eigen::Vector2d a = view(from);
      const Eigen::Vector2d b = view(to);
      fmt::format_to(std::back_inserter(svg),
                     R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" )"
                     R"(y2="{:.1f}" class="grid"/>)"
                     "\n",
                     a.x(), a.y(), b.x(), b.y());
    }
  }
  return svg;
}

std::string ArrowSvg(const Terrain& terrain, const MapView& view) {
  const double x = view.corner.x() + view.side - 16;
  const double y = view.corner.y() + 12;
  const std::string label =
      terrain.type == TerrainType::kTilted
          ? fmt::format("uphill {:.3g}\u00b0",
                        terrain.tilt * 180 / std::numbers::pi)
      : terrain.type == TerrainType::kSteps ? "stairs up"
                                            : "front (+y)";
  // Only where it goes up is the arrow filled: seen before it is read.
  const bool is_up = terrain.type == TerrainType::kTilted ||
                     terrain.type == TerrainType::kSteps;
  return fmt::format(
      R"(<path d="M{0} {1} l7 14 h-4 v24 h-6 v-24 h-4 z" fill="{2}" )"
      R"(stroke="#333"/>)"
      R"(<text x="{3}" y="{4}" class="small" text-anchor="end">{5}</text>)"
      "\n",
      x, y, is_up ? "#333" : "#fff", x - 12, y + 14, label);
}

std::string HeadingSvg(const RecordedSeason& season, const MapView& view) {
  std::string fate =
      season.speed
          ? fmt::format("{}, speed {:.2f} cm/s", OutcomeName(season.outcome),
                        kCentimetres * *season.speed)
          : fmt::format("{}: {}", OutcomeName(season.outcome), season.reason);
  return fmt::format(
      R"(<text x="{0}" y="{1}" class="name">{2}</text>)"
      R"(<text x="{0}" y="{3}" class="small"><title>{4}</title>{5}</text>)"
      "\n",
      view.corner.x(), view.corner.y() - 26,
      EscapeXml(Shortened(season.name, kMostLetters)), view.corner.y() - 8,
      EscapeXml(fate), EscapeXml(Shortened(fate, kMostLetters)));
}

std::string FootingSvg(const RecordedSeason& season, const MapView& view,
                       double bar) {
  const double y = view.corner.y() + view.side + 14;
  const Eigen::Index samples = season.motion.samples();
  std::string legend = samples == 0 ? "not simulated" : "";
  if (samples > 0) {
    const double lived =
        season.motion.TimeOf(samples - 1) - season.motion.begin;
    legend =
        fmt::format("{:.6g} s, dot every {:g} s", lived, DotInterval(lived));
    if (season.terrain.type == TerrainType::kRough) legend += ", dark is low";
  }
  return fmt::format(
      R"(<path d="M{0:.1f} {1:.1f} v8 m0 -4 h{2:.1f} m0 -4 v8" class="bar"/>)"
      R"(<text x="{3:.1f}" y="{4:.1f}" class="small">{5:g} cm</text>)"
      R"(<text x="{6:.1f}" y="{4:.1f}" class="small" )"
      R"(text-anchor="end">{7}</text>)"
      "\n",
      view.corner.x(), y - 4, bar * view.scale,
      view.corner.x() + bar * view.scale + 8, y + 4, bar * 100,
      view.corner.x() + view.side, legend);
}

std::string SeasonSvg(const RecordedSeason& season, const MapView& view,
                      std::size_t number) {
  // As long as a quarter of the square at most.
  const double bar = RoundLength(view.side / 4, view.scale);
  std::string svg = HeadingSvg(season, view);
  const std::string square =
      fmt::format(R"(x="{:.1f}" y="{:.1f}" width="{}" height="{}")",
                  view.corner.x(), view.corner.y(), view.side, view.side);
  svg += fmt::format(
      "<clipPath id=\"season{0}\"><rect {1}/></clipPath>\n"
      "<g clip-path=\"url(#season{0})\">\n<rect {1} fill=\"#fff\"/>\n",
      number, square);
  svg += GroundSvg(season.terrain, view) + GridSvg(view, bar);
  const Eigen::Matrix3Xd path = MassCentres(season);
  const Eigen::Index last = path.cols() - 1;
  svg += BodySvgOf(season, 0, view, true);
  if (last >= 0) {
    svg += BodySvgOf(season, last, view, false);
    // Twice, the first broad and white, so that it is seen on any colour.
    svg += "<g class=\"halo\">\n" + PathLineSvg(path, view) + "</g>\n" +
           PathLineSvg(path, view) + DotsSvg(season.motion, path, view);
  }
  svg += ArrowSvg(season.terrain, view);
  svg += fmt::format("</g>\n<rect {} class=\"frame\"/>\n", square);
  return svg + FootingSvg(season, view, bar);
}

}  // namespace

std::string PathSvg(const Recording& recording) {
  const std::vector<double> scales = ScalesFor(recording);
  const auto seasons = static_cast<int>(recording.seasons.size());
  const int columns = std::clamp(seasons, 1, kPathsInRow);
  const int rows = (seasons + columns - 1) / columns;
  const double panel = kPathHeading + kPlot + kFooting;
  std::string svg = fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" )"
      R"(viewBox="0 0 {0} {1}" font-family="sans-serif">)"
      "\n<title>{2}</title>\n"
      "<style>.title{{font-size:18px}} .name{{font-size:15px;"
      "font-weight:bold}} .small{{font-size:13px}} "
      ".grid{{stroke:#000;stroke-opacity:0.1}} .frame{{fill:none;stroke:#999}} "
      ".box{{stroke:#888}} "
      ".bar{{fill:none;stroke:#000;stroke-width:2}} "
      ".start{{fill:#fff;fill-opacity:0.7;stroke:#666;"
      "stroke-dasharray:3 2}} "
      ".end{{stroke:#000;fill-opacity:0.75}} "
      ".path{{fill:none;stroke-width:2.5;stroke-linejoin:round;"
      "stroke-linecap:round}} "
      ".halo .path{{stroke:#fff;stroke-width:5.5}} "
      ".dot{{stroke:#fff}}</style>\n"
      R"(<rect width="{0}" height="{1}" fill="#fff"/>)"
      "\n"
      R"(<text x="{3}" y="26" class="title">{4}</text>)"
      "\n",
      kPathGap + columns * (kPlot + kPathGap),
      kTitle + rows * panel + kPathGap / 2, EscapeXml(recording.name), kPathGap,
      EscapeXml(Shortened(recording.name, kMostLetters)));
  for (int i = 0; i < seasons; ++i) {
    const RecordedSeason& season =
        recording.seasons[static_cast<std::size_t>(i)];
    MapView view;
    view.centre = ExtentOf(season).center();
    view.scale = scales[static_cast<std::size_t>(i)];
    const int row = i / columns;
    view.corner = {kPathGap + i % columns * (kPlot + kPathGap),
                   kTitle + row * panel + kPathHeading};
    view.side = kPlot;
    svg += SeasonSvg(season, view, static_cast<std::size_t>(i));
  }
  return svg + "</svg>\n";
}

}  // namespace plsc
