#include "runtime/pictures/body_svg.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/pictures/body_shapes.h"
#include "runtime/text/xml.h"

namespace plsc {

namespace {

constexpr int kBodyMargin = 20;       // px around the body
constexpr int kBodyTitleHeight = 40;  // px
// Widest title line; a lone core must still show its genotype's name.
constexpr int kMinWidth = 240;  // px

}  // namespace

std::string BodySvg(const Body& body, const std::string& title) {
  CellExtent extent;
  extent.Include(body);
  const int columns = extent.columns() * kCellSide;
  const int width = std::max(columns + 2 * kBodyMargin, kMinWidth);
  const int height =
      extent.rows() * kCellSide + 2 * kBodyMargin + kBodyTitleHeight;
  const int core_x =
      (width - columns) / 2 - extent.left * kCellSide + kCellSide / 2;
  const int core_y =
      kBodyTitleHeight + kBodyMargin + extent.front * kCellSide + kCellSide / 2;
  return fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" )"
                     R"(height="{1}" viewBox="0 0 {0} {1}" )"
                     R"(font-family="sans-serif" text-anchor="middle">)"
                     "\n<title>{2}</title>\n"
                     R"(<style>.name{{font-size:28px}} .id{{font-size:16px}} )"
                     R"(.title{{font-size:18px}}</style>)"
                     "\n"
                     R"(<rect width="{0}" height="{1}" fill="#fff"/>)"
                     "\n"
                     R"(<text x="{3}" y="28" class="title">{2}</text>)"
                     "\n"
                     R"x(<g transform="translate({4} {5})">)x"
                     "\n",
                     width, height, EscapeXml(title), width / 2, core_x,
                     core_y) +
         BodyShapes(body, PaintByType(body)) + "</g>\n</svg>\n";
}

}  // namespace plsc
