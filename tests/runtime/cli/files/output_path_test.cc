#include "runtime/cli/files/output_path.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <sstream>

#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

TEST_CASE("What must not be lost is not written over", "[output_path]") {
  const test::TemporaryFolder folder;
  const std::string input = folder.Write("robot.pls", "plsc 1\n");
  const std::string zoo = folder.Write("zoo.pls", "plsc 1\n");
  const std::string other = folder.Write(
      "old.html",
      "<!DOCTYPE html>\n<head>\n<meta name=\"generator\" content=\"plsc\">\n");
  const std::string foreign = folder.Write("foreign.html", "<p>old</p>");
  const std::string store = folder / "store.anything";
  std::filesystem::copy_file(test::FinishedRun().path(), store);
  std::filesystem::create_symlink(input, folder / "link.pls");
  std::filesystem::create_symlink(folder / "none.html", folder / "loose.html");

  struct Row {
    const char* why;
    std::string path;
    const char* told;  ///< empty: fine
  };
  const std::vector<Row> rows = {
      {"no file at all", "", ""},
      {"a new file", folder / "new.html", ""},
      {"an older page", other, ""},
      {"an empty file", folder.Write("empty.html", ""), ""},
      {"somebody's page", foreign, "it is no page that plsc made"},
      {"a link to nothing", folder / "loose.html", "leads nowhere"},
      {"standard output", "-", ""},
      {"no such folder", folder / "none/new.html", "its folder does not exist"},
      {"a folder", folder.path().string(), "it is a folder"},
      {"a device", "/dev/null", ""},
      {"an input", input, "the command reads it"},
      {"an input by another name", folder / "link.pls", "the command reads it"},
      {"a file of which one genotype is read", folder / "zoo.pls",
       "the command reads it"},
      {"a run, whatever its name", store, "it is a database"},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    std::istringstream in;
    std::ostringstream out;
    std::ostringstream err;
    cli::Io io{in, out, err};
    const cli::Output output{row.path,
                             cli::OutputKind::kPage,
                             false,
                             {input, zoo + "#gecko", "-", "best"}};
    CHECK(cli::CanWrite(output, io) == std::string(row.told).empty());
    CHECK(err.str().find(row.told) != std::string::npos);
    CHECK(err.str().empty() == std::string(row.told).empty());
  }
}

TEST_CASE("No command writes over the store of a run", "[output_path]") {
  const test::TemporaryFolder folder;
  const std::string store = folder / "run.sqlite";
  std::filesystem::copy_file(test::FinishedRun().path(), store);
  const auto size = std::filesystem::file_size(store);
  const std::string robot = folder.Write("robot.pls", test::kPlasticText);
  const std::string picture = folder.Write("robot.svg", test::kPlasticText);
  const std::vector<std::vector<std::string>> commands = {
      {"report", store, "-o", store},
      {"report", folder.path().string(), "-o", store},
      {"report", store, "--format", "json", "-o", store},
      {"view", robot, "-o", store},
      {"view", store, "-o", store},
      {"view", "--explain", robot, "-o", store},
      {"simulate", robot, "--record", store},
      {"simulate", robot, "--svg", store},
      {"simulate", robot, "--record", robot},
      {"simulate", robot + "#climber", "--record", robot},
      {"view", robot + "#climber", "-o", robot},
      {"draw", picture + "#climber", "-o", picture},
  };
  for (const auto& arguments : commands) {
    INFO(arguments.front() << ' ' << arguments[1]);
    const test::Ran ran = test::RunPlsc(arguments);
    CHECK(ran.exit == 1);
    CHECK(std::filesystem::file_size(store) == size);
    for (const std::string& text : {robot, picture})
      CHECK(std::filesystem::file_size(text) ==
            std::string_view(test::kPlasticText).size());
  }
}

}  // namespace
}  // namespace plsc
