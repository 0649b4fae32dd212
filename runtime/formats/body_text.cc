#include "runtime/formats/body_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

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

struct Point {
  int x = 0;
  int y = 0;
};

void DrawBox(Canvas& canvas, Point corner, const std::string& label) {
  const int right = corner.x + kBoxWidth - 1;
  const int bottom = corner.y + kBoxHeight - 1;
  for (int x = corner.x + 1; x < right; ++x) {
    canvas.Set(x, corner.y, "─");
    canvas.Set(x, bottom, "─");
  }
  canvas.Set(corner.x, corner.y + 1, "│");
  canvas.Set(right, corner.y + 1, "│");
  canvas.Set(corner.x, corner.y, "┌");
  canvas.Set(right, corner.y, "┐");
  canvas.Set(corner.x, bottom, "└");
  canvas.Set(right, bottom, "┘");
  canvas.Write(corner.x + 1, corner.y + 1,
               fmt::format("{:^{}}", label, kBoxWidth - 2));
}

// The middle of the border on one side of a box.
Point Border(Point corner, Facing side) {
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

}  // namespace

std::string BodyText(const Body& body) {
  int left = 0;
  int right = 0;
  int back = 0;
  int front = 0;
  for (const Module& module : body.modules) {
    if (module.type == ModuleType::kTouchSensor) continue;
    left = std::min(left, module.x);
    right = std::max(right, module.x);
    back = std::min(back, module.y);
    front = std::max(front, module.y);
  }
  Canvas canvas((right - left + 1) * kBoxWidth,
                (front - back + 1) * kBoxHeight);
  const auto corner = [&](const Module& module) {
    return Point{(module.x - left) * kBoxWidth,
                 (front - module.y) * kBoxHeight};
  };
  for (const Module& module : body.modules) {
    if (module.type == ModuleType::kTouchSensor) continue;
    DrawBox(canvas, corner(module), LabelOf(module));
    if (module.parent == kNoModule) continue;
    const Point dot = Border(corner(module), Opposite(module.facing));
    canvas.Set(dot.x, dot.y, "•");
  }
  for (const Module& module : body.modules) {
    if (module.type != ModuleType::kTouchSensor) continue;
    const Module& parent =
        body.modules[static_cast<std::size_t>(module.parent)];
    const Facing side = FacingOf(parent.facing, module.slot);
    const Point place = Border(corner(parent), side);
    canvas.Set(place.x, place.y, "T");
  }
  return canvas.Text();
}

}  // namespace plsc
