#include "runtime/exports/export_format.h"

#include <catch2/catch.hpp>
#include <set>

#include "tests/runtime/exports/read_robot.h"
#include "tests/sim/bodies.h"

namespace plsc {
namespace {

TEST_CASE("Every format has a name, an ending and its own text",
          "[export_format]") {
  struct Row {
    ExportFormat format;
    const char* name;
    const char* holds;
  };
  const Row rows[] = {
      {ExportFormat::kMjcf, "mjcf", "<mujoco "},
      {ExportFormat::kUrdf, "urdf", "<robot "},
      {ExportFormat::kSdf, "sdf", "<sdf "},
      {ExportFormat::kYaml, "yaml", "neural-network"},
      {ExportFormat::kJson, "json", "\"plsc_robot\""},
      {ExportFormat::kControllerJson, "controller-json", "\"plsc_controller\""},
      {ExportFormat::kControllerC, "controller-c", "#include <math.h>"},
  };
  CHECK(std::size(rows) == kExportFormats.size());
  const RobotModel model = test::ModelOfBody(Cross(), "cross");
  std::set<std::string_view> endings;
  for (std::size_t i = 0; i < kExportFormats.size(); ++i) {
    INFO(rows[i].name);
    CHECK(kExportFormats[i].format == rows[i].format);
    CHECK(kExportFormats[i].name == rows[i].name);
    CHECK(EndingOf(rows[i].format) == kExportFormats[i].ending);
    endings.insert(kExportFormats[i].ending);
    const std::string text =
        ExportText(rows[i].format, model, Surroundings::kFloor);
    CHECK(text.find(rows[i].holds) != std::string::npos);
    CHECK(text.ends_with('\n'));
    CHECK(text == ExportText(rows[i].format, model, Surroundings::kFloor));
  }
  // Several formats may share a folder.
  CHECK(endings.size() == kExportFormats.size());
}

TEST_CASE("Surroundings matter where a file can have a floor",
          "[export_format]") {
  const RobotModel model = test::ModelOfBody(Cross(), "cross");
  for (const FormatNames& one : kExportFormats) {
    INFO(one.name);
    const bool differs = ExportText(one.format, model, Surroundings::kFloor) !=
                         ExportText(one.format, model, Surroundings::kNone);
    CHECK(differs == (one.format == ExportFormat::kMjcf ||
                      one.format == ExportFormat::kSdf));
  }
}

}  // namespace
}  // namespace plsc
