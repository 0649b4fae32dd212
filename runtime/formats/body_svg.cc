#include "runtime/formats/body_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "runtime/formats/svg_style.h"

namespace plsc {

namespace {

constexpr int kCell = 100;        // px, as in the authors' drawings
constexpr int kMargin = 20;       // px around the body
constexpr int kTitleHeight = 40;  // px
constexpr int kDot = 8;           // px, radius of the mark towards the parent
constexpr int kBar = 10;          // px, thickness of a sensor
// Widest title line; a lone core must still show its genotype's name.
constexpr int kMinWidth = 240;  // px

struct Extent {
  int left = 0;
  int right = 0;
  int back = 0;
  int front = 0;
};

Extent ExtentOf(const Body& body) {
  Extent extent;
  for (const Module& module : body.modules) {
    if (module.type == ModuleType::kTouchSensor) continue;
    extent.left = std::min(extent.left, module.x);
    extent.right = std::max(extent.right, module.x);
    extent.back = std::min(extent.back, module.y);
    extent.front = std::max(extent.front, module.y);
  }
  return extent;
}

struct Point {
  int x = 0;
  int y = 0;
};

// Unit step in picture axes (y down) of an absolute direction.
Point Ahead(Facing facing) {
  switch (facing) {
    case Facing::kFront:
      return {0, -1};
    case Facing::kLeft:
      return {-1, 0};
    case Facing::kBack:
      return {0, 1};
    case Facing::kRight:
      return {1, 0};
  }
  return {};
}

void DrawModule(const Module& module, Point centre, std::string& svg) {
  auto out = std::back_inserter(svg);
  fmt::format_to(out,
                 R"(<rect x="{}" y="{}" width="{}" height="{}" fill="{}" )"
                 R"(stroke="#000" stroke-width="2"/>)"
                 "\n",
                 centre.x - kCell / 2, centre.y - kCell / 2, kCell, kCell,
                 ModuleColour(module.type));
  fmt::format_to(out,
                 R"(<text x="{}" y="{}" class="name">{}</text>)"
                 R"(<text x="{}" y="{}" class="id">{}</text>)"
                 "\n",
                 centre.x, centre.y + 8, ModuleName(module.type), centre.x,
                 centre.y + 32, module.number);
  if (module.parent == kNoModule) return;
  const Point back = Ahead(Opposite(module.facing));
  fmt::format_to(out,
                 R"(<circle cx="{}" cy="{}" r="{}"/>)"
                 "\n",
                 centre.x + back.x * kCell / 2, centre.y + back.y * kCell / 2,
                 kDot);
}

// A sensor is a bar inside the edge of the parent's cell that it sits on.
void DrawSensor(Point parent, Facing side, std::string& svg) {
  const Point step = Ahead(side);
  const int long_side = kCell / 2;
  const int offset = kCell / 2 - kBar;
  const Point centre{parent.x + step.x * offset, parent.y + step.y * offset};
  const int width = step.x != 0 ? kBar : long_side;
  const int height = step.x != 0 ? long_side : kBar;
  fmt::format_to(std::back_inserter(svg),
                 R"(<rect x="{}" y="{}" width="{}" height="{}" fill="{}" )"
                 R"(stroke="#000"/>)"
                 "\n",
                 centre.x - width / 2, centre.y - height / 2, width, height,
                 ModuleColour(ModuleType::kTouchSensor));
}

}  // namespace

std::string BodySvg(const Body& body, const std::string& title) {
  const Extent extent = ExtentOf(body);
  const int columns = extent.right - extent.left + 1;
  const int rows = extent.front - extent.back + 1;
  const int width = std::max(columns * kCell + 2 * kMargin, kMinWidth);
  const int height = rows * kCell + 2 * kMargin + kTitleHeight;
  const int left = (width - columns * kCell) / 2;
  const auto centre = [&](const Module& module) {
    return Point{
        left + (module.x - extent.left) * kCell + kCell / 2,
        kTitleHeight + kMargin + (extent.front - module.y) * kCell + kCell / 2};
  };

  std::string svg = fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" )"
      R"(viewBox="0 0 {0} {1}" font-family="sans-serif" )"
      R"(text-anchor="middle">)"
      "\n<title>{2}</title>\n"
      R"(<style>.name{{font-size:28px}} .id{{font-size:16px}} )"
      R"(.title{{font-size:18px}}</style>)"
      "\n"
      R"(<rect width="{0}" height="{1}" fill="#fff"/>)"
      "\n"
      R"(<text x="{3}" y="28" class="title">{2}</text>)"
      "\n",
      width, height, EscapeXml(title), width / 2);
  // Dots lie on borders and sensors inside cells, so squares come first.
  for (const Module& module : body.modules)
    if (module.type != ModuleType::kTouchSensor)
      DrawModule(module, centre(module), svg);
  for (const Module& module : body.modules) {
    if (module.type != ModuleType::kTouchSensor) continue;
    const Module& parent =
        body.modules[static_cast<std::size_t>(module.parent)];
    DrawSensor(centre(parent), FacingOf(parent.facing, module.slot), svg);
  }
  return svg + "</svg>\n";
}

}  // namespace plsc
