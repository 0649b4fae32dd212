// Pictures in rows with titles and a legend, laid out without asking any font:
// nobody knows which one the viewer has, so widths are estimated for a wide one
// (kLetter) and what is too long is cut. Too much space is the error that is
// left. Whole pixels everywhere, so that the bytes do not depend on rounding.

#include "runtime/pictures/svg_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "grammar/utf8.h"
#include "runtime/text/xml.h"

namespace plsc {

namespace {

constexpr int kMargin = 20;            // px, around everything
constexpr int kGap = 30;               // px, between panels
constexpr int kTitleHeight = 44;       // px, the picture's title
constexpr int kHeading = 56;           // px, a panel's title and subtitle
constexpr int kLegendLine = 36;        // px
constexpr int kLegendSpace = 24;       // px, between entries
constexpr std::size_t kMostInRow = 4;  // wider pictures do not fit pages
constexpr int kMostTitleWidth = 420;   // px; longer ones are cut
constexpr int kMostLegendWidth = 560;  // px; longer texts are cut
constexpr int kLeastWidth = 360;       // px, of the picture: a legend fits in
// px per letter and px of size. Wide fonts, such as DejaVu Sans, have means of
// 0.55 to 0.6; too much only leaves space.
constexpr double kLetter = 0.6;
constexpr int kTitleSize = 20;
constexpr int kHeadingSize = 18;
constexpr int kSubtitleSize = 14;
constexpr int kLegendSize = 15;

int TextWidth(const std::string& text, int size) {
  return static_cast<int>(std::ceil(static_cast<double>(CountCharacters(text)) *
                                    kLetter * size)) +
         1;
}

std::string Fitted(const std::string& text, int width, int size) {
  return EscapeXml(
      Shortened(text, static_cast<std::size_t>(width / (kLetter * size))));
}

int WidthOf(const Panel& panel) {
  const int titles = std::max(TextWidth(panel.title, kHeadingSize),
                              TextWidth(panel.subtitle, kSubtitleSize));
  return std::max(panel.width, std::min(titles, kMostTitleWidth));
}

struct Row {
  std::size_t begin = 0;
  std::size_t end = 0;
  int width = 0;
  int height = 0;
};

std::vector<Row> RowsOf(const std::vector<Panel>& panels) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (i % kMostInRow == 0) rows.push_back({i, i, -kGap, 0});
    Row& row = rows.back();
    row.end = i + 1;
    row.width += kGap + WidthOf(panels[i]);
    row.height = std::max(row.height, panels[i].height);
  }
  return rows;
}

std::string PanelShapes(const Panel& panel, int x, int y) {
  const int width = WidthOf(panel);
  const int middle = x + width / 2;
  std::string svg =
      fmt::format(R"(<text x="{}" y="{}" class="heading">{}</text>)"
                  "\n",
                  middle, y + 20, Fitted(panel.title, width, kHeadingSize));
  if (!panel.subtitle.empty())
    fmt::format_to(std::back_inserter(svg),
                   R"(<text x="{}" y="{}" class="subtitle">{}</text>)"
                   "\n",
                   middle, y + 41,
                   Fitted(panel.subtitle, width, kSubtitleSize));
  fmt::format_to(std::back_inserter(svg),
                 R"x(<g class="panel" transform="translate({} {})">)x"
                 "\n{}</g>\n",
                 x + (width - panel.width) / 2 - panel.left,
                 y + kHeading - panel.top, panel.svg);
  return svg;
}

struct Legend {
  std::string svg;
  int height = 0;
};

// Entries follow each other like words.
Legend LegendShapes(const std::vector<LegendEntry>& entries, int width,
                    int top) {
  Legend legend;
  int x = kMargin;
  int y = top;
  for (const LegendEntry& entry : entries) {
    const int before = entry.icon.empty() ? 0 : kLegendIcon + 8;
    const int most = width - 2 * kMargin - before;
    const int length = std::min(TextWidth(entry.text, kLegendSize), most);
    const int taken = before + length;
    if (x > kMargin && x + taken > width - kMargin) {
      x = kMargin;
      y += kLegendLine;
    }
    fmt::format_to(std::back_inserter(legend.svg),
                   R"x(<g transform="translate({} {})">{}</g>)x"
                   R"(<text x="{}" y="{}" class="legend">{}</text>)"
                   "\n",
                   x + kLegendIcon / 2, y + kLegendLine / 2, entry.icon,
                   x + before, y + kLegendLine / 2 + 5,
                   Fitted(entry.text, length, kLegendSize));
    x += taken + kLegendSpace;
  }
  if (!entries.empty()) legend.height = y + kLegendLine - top;
  return legend;
}

}  // namespace

std::string PanelsSvg(const std::string& title,
                      const std::vector<Panel>& panels,
                      const std::vector<LegendEntry>& legend,
                      const std::string& style) {
  const std::vector<Row> rows = RowsOf(panels);
  int width = kLeastWidth;
  for (const Row& row : rows) width = std::max(width, row.width + 2 * kMargin);
  width = std::max(width,
                   std::min(TextWidth(title, kTitleSize), 2 * kMostTitleWidth) +
                       2 * kMargin);
  for (const LegendEntry& entry : legend)
    width = std::max(
        width, std::min(TextWidth(entry.text, kLegendSize), kMostLegendWidth) +
                   kLegendIcon + 8 + 2 * kMargin);
  std::string shapes;
  int y = kTitleHeight;
  for (const Row& row : rows) {
    int x = (width - row.width) / 2;
    for (std::size_t i = row.begin; i < row.end; ++i) {
      shapes += PanelShapes(panels[i], x, y);
      x += WidthOf(panels[i]) + kGap;
    }
    y += kHeading + row.height + kMargin;
  }
  const Legend below = LegendShapes(legend, width, y);
  return fmt::format(
             R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" )"
             R"(height="{1}" viewBox="0 0 {0} {1}" )"
             R"(font-family="sans-serif" text-anchor="middle">)"
             "\n<title>{2}</title>\n"
             R"(<style>.title{{font-size:{3}px;font-weight:bold}} )"
             R"(.heading{{font-size:{4}px}} )"
             R"(.subtitle{{font-size:{5}px;fill:#444}} )"
             R"(.legend{{font-size:{6}px;text-anchor:start}} {7}</style>)"
             "\n"
             R"(<rect width="{0}" height="{1}" fill="#fff"/>)"
             "\n"
             R"(<text x="{8}" y="30" class="title">{9}</text>)"
             "\n",
             width, y + below.height + kMargin / 2, EscapeXml(title),
             kTitleSize, kHeadingSize, kSubtitleSize, kLegendSize, style,
             width / 2, Fitted(title, width - 2 * kMargin, kTitleSize)) +
         shapes + below.svg + "</svg>\n";
}

}  // namespace plsc
