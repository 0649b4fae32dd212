#include "runtime/pictures/svg_panels.h"

#include <catch2/catch.hpp>

#include "tests/runtime/pictures/count.h"

namespace plsc {
namespace {

using test::Count;

int Attribute(const std::string& svg, const std::string& name) {
  return std::stoi(svg.substr(svg.find(name + "=\"") + name.size() + 2));
}

std::vector<Panel> Panels(int count) {
  return std::vector<Panel>(
      static_cast<std::size_t>(count),
      {"flat", "hot=True", "<rect/>", -50, -50, 300, 200});
}

TEST_CASE("panels stand side by side, at most four a row", "[svg_panels]") {
  const std::string one = PanelsSvg("robot", Panels(1), {}, "");
  const std::string four = PanelsSvg("robot", Panels(4), {}, "");
  const std::string five = PanelsSvg("robot", Panels(5), {}, "");
  CHECK(Count(four, R"(class="panel")") == 4);
  CHECK(Attribute(four, "width") >= 4 * 300);
  CHECK(Attribute(four, "height") == Attribute(one, "height"));
  CHECK(Attribute(five, "width") == Attribute(four, "width"));
  CHECK(Attribute(five, "height") >= Attribute(four, "height") + 200);
}

TEST_CASE("whatever a name holds is text, and is cut where it is too long",
          "[svg_panels]") {
  std::vector<Panel> panels = Panels(1);
  panels[0].title = "<script>alert(1)</script>";
  panels[0].subtitle = std::string(500, 'x');
  const std::string svg =
      PanelsSvg("a & b", panels, {{"<circle/>", "<b>"}, {"", "no icon"}}, "");
  CHECK(Count(svg, "<script") == 0);
  CHECK(Count(svg, ">&lt;script&gt;alert(1)&lt;/script&gt;<") == 1);
  CHECK(Count(svg, ">a &amp; b<") == 2);
  CHECK(Count(svg, "xxx...<") == 1);
  CHECK(Count(svg, ">&lt;b&gt;<") == 1);
  CHECK(Attribute(svg, "width") < 600);
}

TEST_CASE("a legend makes the picture higher, not wider", "[svg_panels]") {
  const std::vector<LegendEntry> legend(12,
                                        {"<circle/>", "a horizontal joint"});
  const std::string without = PanelsSvg("robot", Panels(1), {}, "");
  const std::string with = PanelsSvg("robot", Panels(1), legend, "");
  CHECK(Attribute(with, "width") == Attribute(without, "width"));
  CHECK(Attribute(with, "height") > Attribute(without, "height") + 100);
  CHECK(Count(with, ">a horizontal joint<") == 12);
}

}  // namespace
}  // namespace plsc
