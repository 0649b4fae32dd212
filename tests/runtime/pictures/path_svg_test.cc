#include "runtime/pictures/path_svg.h"

#include <catch2/catch.hpp>

#include "tests/runtime/pictures/count.h"
#include "tests/runtime/recording/recorded.h"

namespace plsc {
namespace {

TEST_CASE("a picture has a square a season with both bodies", "[path_svg]") {
  const std::string svg = PathSvg(test::SmallRecording());
  CHECK(test::Count(svg, "<clipPath") == 2);
  // 6 boxes, in 2 seasons.
  CHECK(test::Count(svg, "class=\"start\"") == 12);
  CHECK(test::Count(svg, "class=\"end\"") == 12);
  CHECK(test::Count(svg, "<polyline") > 0);
  CHECK(test::Count(svg, "class=\"dot\"") == 3);  // 0 and 1 s; 0 s
  CHECK(svg.find(">slope</text>") != std::string::npos);
  CHECK(svg.find("completed, speed ") != std::string::npos);
  CHECK(svg.find("uphill 5\u00b0") != std::string::npos);
  CHECK(svg.find(" cm</text>") != std::string::npos);
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
}

TEST_CASE("seasons share a scale unless one would be a speck", "[path_svg]") {
  Recording recording = test::SmallRecording();
  // The robot takes 0.2 m; a way of 0.4 m shares its scale, 4 m do not.
  Eigen::MatrixXd& position = recording.seasons[1].motion.position;
  const auto move = [&](double way) {
    for (const Eigen::Index y : {1, 4})
      for (Eigen::Index i = 1; i < position.cols(); ++i) position(y, i) += way;
  };
  move(0.4);
  CHECK(test::Count(PathSvg(recording), ">10 cm<") == 2);
  move(3.6);
  const std::string svg = PathSvg(recording);
  CHECK(test::Count(svg, ">100 cm<") == 1);
  CHECK(test::Count(svg, ">5 cm<") == 1);
}

TEST_CASE("names and reasons cannot break a picture", "[path_svg]") {
  Recording recording = test::SmallRecording();
  recording.name = "<&\">";
  recording.seasons[0].name = "</svg>";
  recording.seasons[1].speed.reset();
  recording.seasons[1].outcome = Outcome::kUnstable;
  recording.seasons[1].reason = std::string(100, '<');
  const std::string svg = PathSvg(recording);
  CHECK(test::Count(svg, "</svg>") == 1);
  CHECK(svg.find("&lt;&amp;&quot;&gt;") != std::string::npos);
  CHECK(svg.find("unstable: &lt;") != std::string::npos);
  CHECK(svg.find("&lt;...") != std::string::npos);  // shown shortened
}

TEST_CASE("what was not simulated is shown at rest", "[path_svg]") {
  Recording recording;
  recording.name = "still";
  recording.seasons.resize(6);
  for (RecordedSeason& season : recording.seasons)
    season.outcome = Outcome::kNotReached;
  recording.seasons[0].body = RecordBody(test::SmallRobot().body);
  const std::string svg = PathSvg(recording);
  CHECK(test::Count(svg, "not simulated") == 6);
  CHECK(test::Count(svg, "class=\"start\"") == 6);
  CHECK(test::Count(svg, "class=\"end\"") == 0);
  // Two rows: four seasons, then two.
  CHECK(svg.find("width=\"1620\"") != std::string::npos);
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(PathSvg({}).find("</svg>") != std::string::npos);
}

}  // namespace
}  // namespace plsc
