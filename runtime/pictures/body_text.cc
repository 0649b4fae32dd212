#include "runtime/pictures/body_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "runtime/compare/body_difference.h"
#include "runtime/pictures/body_shapes.h"

namespace plsc {

namespace {

constexpr int kBoxWidth = 7;   // characters: "│A2 12│"
constexpr int kBoxHeight = 3;  // lines

// Characters of the drawing; each is one column wide.
class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width), cells_(static_cast<std::size_t>(width * height), " ") {}

  void Set(int x, int y, std::string_view character) {
    cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x)] = character;
  }
  void Write(int x, int y, std::string_view ascii) {
    for (std::size_t i = 0; i < ascii.size(); ++i)
      Set(x + static_cast<int>(i), y, ascii.substr(i, 1));
  }
  std::string Text() const {
    std::string text;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      text += cells_[i];
      if ((i + 1) % static_cast<std::size_t>(width_) != 0) continue;
      text.erase(text.find_last_not_of(' ') + 1);
      text += '\n';
    }
    return text;
  }

 private:
  int width_;
  std::vector<std::string> cells_;
};

struct Place {
  int x = 0;
  int y = 0;
};

// The lines of a box: across, down, and the corners from the top left on, row
// by row.
struct BoxStyle {
  std::string_view across, down, corners[4];
};
constexpr BoxStyle kLight{"─", "│", {"┌", "┐", "└", "┘"}};
constexpr BoxStyle kThick{"━", "┃", {"┏", "┓", "┗", "┛"}};
constexpr BoxStyle kDouble{"═", "║", {"╔", "╗", "╚", "╝"}};
constexpr BoxStyle kDashed{"╌", "╎", {"┌", "┐", "└", "┘"}};

const BoxStyle& StyleOf(ModuleMark mark) {
  return mark == ModuleMark::kShared ? kLight
         : mark == ModuleMark::kNew  ? kThick
                                     : kDouble;
}

void DrawBox(Canvas& canvas, Place corner, const std::string& label,
             const BoxStyle& style) {
  const int right = corner.x + kBoxWidth - 1;
  const int bottom = corner.y + kBoxHeight - 1;
  for (int x = corner.x + 1; x < right; ++x) {
    canvas.Set(x, corner.y, style.across);
    canvas.Set(x, bottom, style.across);
  }
  canvas.Set(corner.x, corner.y + 1, style.down);
  canvas.Set(right, corner.y + 1, style.down);
  canvas.Set(corner.x, corner.y, style.corners[0]);
  canvas.Set(right, corner.y, style.corners[1]);
  canvas.Set(corner.x, bottom, style.corners[2]);
  canvas.Set(right, bottom, style.corners[3]);
  canvas.Write(corner.x + 1, corner.y + 1,
               fmt::format("{:^{}}", label, kBoxWidth - 2));
}

// The middle of the border on one side of a box.
Place Border(Place corner, Facing side) {
  switch (side) {
    case Facing::kFront:
      return {corner.x + kBoxWidth / 2, corner.y};
    case Facing::kBack:
      return {corner.x + kBoxWidth / 2, corner.y + kBoxHeight - 1};
    case Facing::kLeft:
      return {corner.x, corner.y + 1};
    case Facing::kRight:
      return {corner.x + kBoxWidth - 1, corner.y + 1};
  }
  return corner;
}

// "A2 12"; numbers beyond two digits push the blank out.
std::string LabelOf(const Module& module) {
  const std::string_view name = ModuleName(module.type);
  std::string label = fmt::format("{} {}", name, module.number);
  if (label.size() > kBoxWidth - 2)
    label = fmt::format("{}{}", name, module.number).substr(0, kBoxWidth - 2);
  return label;
}

// A canvas that cells are drawn on.
class Plan {
 public:
  explicit Plan(const CellExtent& extent)
      : extent_(extent),
        canvas_(extent.columns() * kBoxWidth, extent.rows() * kBoxHeight) {}

  void Add(const Module& module, const BoxStyle& style) {
    DrawBox(canvas_, CornerOf(module), LabelOf(module), style);
  }
  void AddMissing(const Module& module) {
    DrawBox(canvas_, CornerOf(module), "", kDashed);
  }
  void AddDot(const Module& module) {
    const Place dot = Border(CornerOf(module), Opposite(module.facing));
    canvas_.Set(dot.x, dot.y, "•");
  }
  void AddSensor(const Body& body, const Module& sensor,
                 std::string_view letter) {
    const Module& parent =
        body.modules[static_cast<std::size_t>(sensor.parent)];
    const Place place =
        Border(CornerOf(parent), FacingOf(parent.facing, sensor.slot));
    canvas_.Set(place.x, place.y, letter);
  }
  std::string Text() const { return canvas_.Text(); }

 private:
  Place CornerOf(const Module& module) const {
    return {(module.x - extent_.left) * kBoxWidth,
            (extent_.front - module.y) * kBoxHeight};
  }

  CellExtent extent_;
  Canvas canvas_;
};

}  // namespace

std::string BodyText(const Body& body) {
  CellExtent extent;
  extent.Include(body);
  return BodyText(body, body, extent);
}

std::string BodyText(const Body& body, const Body& reference,
                     const CellExtent& rows) {
  const BodyDifference difference = CompareBodies(reference, body);
  CellExtent extent;
  extent.Include(body);
  extent.Include(reference);
  extent.back = rows.back;
  extent.front = rows.front;
  Plan plan(extent);
  // What is there is drawn over what is not.
  for (const int index : difference.missing) {
    const Module& module = reference.modules[static_cast<std::size_t>(index)];
    if (!IsSensor(module)) plan.AddMissing(module);
  }
  for (std::size_t i = 0; i < body.modules.size(); ++i)
    if (!IsSensor(body.modules[i]))
      plan.Add(body.modules[i], StyleOf(difference.marks[i]));
  for (const Module& module : body.modules)
    if (!IsSensor(module) && module.parent != kNoModule) plan.AddDot(module);
  for (const int index : difference.missing) {
    const Module& module = reference.modules[static_cast<std::size_t>(index)];
    if (IsSensor(module)) plan.AddSensor(reference, module, "t");
  }
  for (const Module& module : body.modules)
    if (IsSensor(module)) plan.AddSensor(body, module, "T");
  return plan.Text();
}

}  // namespace plsc
