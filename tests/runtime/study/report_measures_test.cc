#include "runtime/study/report_measures.h"

#include <catch2/catch.hpp>
#include <set>

#include "runtime/store/schema.h"

namespace plsc {

TEST_CASE("The paper's measures have its names and units",
          "[report_measures]") {
  const auto measures = *ChooseMeasures("paper");
  REQUIRE(measures.size() == 6);
  CHECK(measures[0].title == "Speed");
  CHECK(measures[0].unit == "cm/s");
  CHECK(measures[0].scale == 100);
  CHECK(measures[1].title == "Balance");
  CHECK(measures[2].id == "absolute_size");
  CHECK(measures[3].title == "Sensors");
  CHECK(measures[4].title == "Sensors Reach");
  CHECK(measures[5].title == "Recurrence");
}

TEST_CASE("All measures are every descriptor of a store, and the fitness",
          "[report_measures]") {
  std::set<std::string> ids;
  const auto all = *ChooseMeasures("all");
  for (const ReportMeasure& measure : all) CHECK(ids.insert(measure.id).second);
  std::size_t columns = 1;
  for (const auto& names : {BodyColumns(), BrainColumns(), BehaviourColumns()})
    for (const std::string& name : names) {
      CHECK(ids.count(name) == 1);
      ++columns;
    }
  CHECK(ids.size() == columns);
  CHECK(ids.count("fitness") == 1);
}

TEST_CASE("What a formula comes to has no unit, all else has",
          "[report_measures]") {
  auto measures = *ChooseMeasures("speed,fitness,energy,heading");
  CHECK(measures[1].unit == "cm/s");
  CHECK(measures[2].unit == "J");
  CHECK(measures[3].unit == "rad");
  UseOwnFitness(measures);
  CHECK(measures[0].unit == "cm/s");
  CHECK(measures[0].scale == 100);
  CHECK(measures[1].unit.empty());
  CHECK(measures[1].scale == 1);
}

TEST_CASE("Measures are chosen by column or title", "[report_measures]") {
  const auto chosen =
      *ChooseMeasures("speed, hinge_count,Sensors Reach,SPEED,limbs");
  REQUIRE(chosen.size() == 4);
  CHECK(chosen[0].id == "displacement_velocity_hill");
  CHECK(chosen[1].title == "Hinge count");
  CHECK(chosen[2].id == "sensors_reach");
  CHECK(chosen[3].id == "limbs");

  for (const char* wrong : {"", "sped", "speed,,size", "speed,"}) {
    CAPTURE(wrong);
    const auto failed = ChooseMeasures(wrong);
    REQUIRE_FALSE(failed);
    CHECK(failed.error().text.find("hinge_count") != std::string::npos);
  }
}

TEST_CASE("Each measure has a name of its own, by which it is found",
          "[report_measures]") {
  std::set<std::string> names;
  for (const ReportMeasure& measure : AllMeasures()) {
    const std::string name = MeasureName(measure);
    CHECK(names.insert(name).second);
    CHECK(FindMeasure(name) == measure);
    CHECK(FindMeasure(measure.id) == measure);
    CHECK(FindMeasure(measure.title) == measure);
  }
  CHECK(names.count("sensors_reach") == 1);
  CHECK_FALSE(FindMeasure("sped"));
}

}  // namespace plsc
