#include "runtime/report/figures.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/runtime/report/claimed_study.h"

namespace plsc {

namespace {

std::size_t Count(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + part.size()))
    ++count;
  return count;
}

}  // namespace

TEST_CASE("A figure of boxes has a panel a measure and season, a dot a run",
          "[figures]") {
  StudyReport report = test::RelivedClaims();
  report.title = "<b>";
  const std::string svg = BoxesFigure(report);
  CHECK(svg.find("<title>&lt;b&gt;, generation 1</title>") !=
        std::string::npos);
  CHECK(Count(svg, "class=\"panel\"") == 4);
  // Sizes recorded, speeds relived and recorded, of ten runs in two seasons.
  CHECK(Count(svg, "class=\"run\"") == (10 + 2 * 10) * 2);
  CHECK(Count(svg, "class=\"middle\"") == (2 + 2 * 2) * 2);
  CHECK(Count(svg, ">relived<") == 2);
  CHECK(Count(svg, ">recorded<") == 4);
  CHECK(svg.find("nan") == std::string::npos);
}

TEST_CASE("Curves go through generations that were kept", "[figures]") {
  StudyReport report = test::ClaimedStudy({});
  for (ReportRun& run : report.runs) {
    run.reading.population.generations = 3;
    run.reading.population.series[0].means = {3, NAN, 5};
    run.reading.population.series[1].means = {3, 4, 5};
  }
  report.experiments[1].is_static = true;
  const std::string svg = CurvesFigure(report);
  CHECK(Count(svg, "class=\"panel\"") == 2);
  CHECK(Count(svg, "fill-opacity=\"0.2\"") == 2);
  CHECK(Count(svg, "stroke-width=\"2\" stroke-dasharray") == 2);
  CHECK(svg.find("nan") == std::string::npos);
}

TEST_CASE("A figure without runs is an empty picture", "[figures]") {
  for (const std::string& svg : {BoxesFigure({}), CurvesFigure({})}) {
    CHECK(svg.starts_with("<svg xmlns="));
    CHECK(svg.ends_with("</svg>\n"));
    CHECK(Count(svg, "class=\"panel\"") == 0);
  }
}

}  // namespace plsc
