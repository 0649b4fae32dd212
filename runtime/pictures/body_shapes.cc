// Squares first, then outlines, dots and sensors, as what comes later lies
// above: dots stand on borders and sensors inside cells. What differs is marked
// by lines and not by colours alone, so that it is seen in print and by those
// who do not see colours; a missing part is dotted in its old place unless
// something else is there.

#include "runtime/pictures/body_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include "runtime/pictures/svg_style.h"
#include "runtime/text/xml.h"

namespace plsc {

namespace {

constexpr int kHalf = kCellSide / 2;
constexpr int kDot = 8;   // px, radius of the mark towards the parent
constexpr int kBar = 10;  // px, thickness of a sensor

struct Point {
  int x = 0;
  int y = 0;
};

Point CentreOf(const Module& module) {
  return {module.x * kCellSide, -module.y * kCellSide};
}

// Unit step in picture axes of an absolute direction.
Point Ahead(Facing facing) {
  constexpr std::array<Point, 4> kSteps{{{0, -1}, {-1, 0}, {0, 1}, {1, 0}}};
  return kSteps[static_cast<std::size_t>(facing)];
}

std::string SquareShape(const Module& module, const ModulePaint& paint) {
  const Point centre = CentreOf(module);
  std::string svg;
  auto out = std::back_inserter(svg);
  fmt::format_to(out,
                 R"(<rect x="{}" y="{}" width="{}" height="{}" fill="{}" )"
                 R"(stroke="#000" stroke-width="2"/>)"
                 "\n",
                 centre.x - kHalf, centre.y - kHalf, kCellSide, kCellSide,
                 paint.fill);
  fmt::format_to(out,
                 R"(<text x="{0}" y="{1}" class="name" fill="{5}">{3}</text>)"
                 R"(<text x="{0}" y="{2}" class="id" fill="{5}">{4}</text>)"
                 "\n",
                 centre.x, centre.y + 8, centre.y + 32, ModuleName(module.type),
                 module.number, paint.ink);
  if (!paint.note.empty())
    fmt::format_to(out,
                   R"(<text x="{}" y="{}" class="note" fill="{}">{}</text>)"
                   "\n",
                   centre.x, centre.y - 22, paint.ink, EscapeXml(paint.note));
  return svg;
}

// Ringed in white, it is seen on an outline.
std::string DotShape(const Module& module, bool is_ringed) {
  if (module.parent == kNoModule) return "";
  const Point centre = CentreOf(module);
  const Point back = Ahead(Opposite(module.facing));
  return fmt::format(R"(<circle cx="{}" cy="{}" r="{}"{}/>)"
                     "\n",
                     centre.x + back.x * kHalf, centre.y + back.y * kHalf, kDot,
                     is_ringed ? R"( stroke="#fff" stroke-width="2")" : "");
}

struct Bar {
  Point corner;
  int width = 0;
  int height = 0;
};

// A sensor is a bar inside the edge of the parent's cell that it sits on.
Bar BarOf(const Body& body, const Module& sensor) {
  const Module& parent = body.modules[static_cast<std::size_t>(sensor.parent)];
  const Point step = Ahead(FacingOf(parent.facing, sensor.slot));
  const int offset = kHalf - kBar;
  Point centre = CentreOf(parent);
  centre.x += step.x * offset;
  centre.y += step.y * offset;
  const int width = step.x != 0 ? kBar : kHalf;
  const int height = step.x != 0 ? kHalf : kBar;
  return {{centre.x - width / 2, centre.y - height / 2}, width, height};
}

std::string BarShape(const Bar& bar, const std::string& style) {
  return fmt::format(R"(<rect x="{}" y="{}" width="{}" height="{}" {}/>)"
                     "\n",
                     bar.corner.x, bar.corner.y, bar.width, bar.height, style);
}

// Dashed lines lie on a white one, so that they are seen on any colour.
std::string OutlineShape(const Bar& bar, ModuleMark mark) {
  std::string black = BarShape(
      bar,
      std::string(R"(fill="none" stroke="#000" )"
                  R"(stroke-width="6" class="mark")") +
          (mark == ModuleMark::kOther ? R"( stroke-dasharray="12 9")" : ""));
  if (mark == ModuleMark::kNew) return black;
  return BarShape(bar, R"(fill="none" stroke="#fff" stroke-width="6")") + black;
}

std::string DottedShape(const Bar& bar) {
  return BarShape(bar, R"(fill="none" stroke="#777" stroke-width="3" )"
                       R"(stroke-dasharray="3 7" stroke-linecap="round" )"
                       R"(class="missing")");
}

Bar Square(int x, int y, int half) {
  return {{x - half, y - half}, 2 * half, 2 * half};
}

}  // namespace

bool IsSensor(const Module& module) {
  return module.type == ModuleType::kTouchSensor;
}

void CellExtent::Include(const Body& body) {
  for (const Module& module : body.modules) {
    if (IsSensor(module)) continue;
    left = std::min(left, module.x);
    right = std::max(right, module.x);
    back = std::min(back, module.y);
    front = std::max(front, module.y);
  }
}

std::vector<ModulePaint> PaintByType(const Body& body) {
  std::vector<ModulePaint> paints;
  for (const Module& module : body.modules) {
    ModulePaint paint;
    paint.fill = ModuleColour(module.type);
    paints.push_back(std::move(paint));
  }
  return paints;
}

std::string BodyShapes(const Body& body, const std::vector<ModulePaint>& paints,
                       const std::string& outlines) {
  std::string svg;
  for (std::size_t i = 0; i < body.modules.size(); ++i)
    if (!IsSensor(body.modules[i]))
      svg += SquareShape(body.modules[i], paints[i]);
  svg += outlines;
  // Dots lie on borders and sensors inside cells, so squares come first.
  for (const Module& module : body.modules)
    if (!IsSensor(module)) svg += DotShape(module, !outlines.empty());
  for (std::size_t i = 0; i < body.modules.size(); ++i)
    if (IsSensor(body.modules[i]))
      svg +=
          BarShape(BarOf(body, body.modules[i]),
                   fmt::format(R"(fill="{}" stroke="#000")", paints[i].fill));
  return svg;
}

std::string DifferenceShapes(const Body& reference, const Body& body,
                             const BodyDifference& difference) {
  // Inside the square, so that neighbours do not share a line.
  constexpr int kInset = kHalf - 5;
  std::string svg;
  std::set<std::pair<int, int>> taken;
  for (std::size_t i = 0; i < body.modules.size(); ++i) {
    const Module& module = body.modules[i];
    if (!IsSensor(module)) taken.emplace(module.x, module.y);
    if (difference.marks[i] == ModuleMark::kShared) continue;
    const Point centre = CentreOf(module);
    svg += IsSensor(module)
               ? BarShape(BarOf(body, module),
                          R"(fill="none" stroke="#000" stroke-width="5" )"
                          R"(class="mark")")
               : OutlineShape(Square(centre.x, centre.y, kInset),
                              difference.marks[i]);
  }
  for (const int index : difference.missing) {
    const Module& module = reference.modules[static_cast<std::size_t>(index)];
    const Point centre = CentreOf(module);
    if (IsSensor(module))
      svg += DottedShape(BarOf(reference, module));
    else if (!taken.contains({module.x, module.y}))
      svg += DottedShape(Square(centre.x, centre.y, kInset));
  }
  return svg;
}

std::string MarkShape(int x, int y, int half, ModuleMark mark) {
  return OutlineShape(Square(x, y, half), mark);
}

std::string MissingShape(int x, int y, int half) {
  return DottedShape(Square(x, y, half));
}

}  // namespace plsc
