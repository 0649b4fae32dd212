#include "runtime/store/packing.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/store/database.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

TEST_CASE("Packed bodies and brains come back, in C++ and in SQL",
          "[packing]") {
  const test::Recorder run = test::RecordRun(test::StoredExperiment());
  Database database;
  REQUIRE(database.Open("", Database::Mode::kMemory) == std::nullopt);
  Statement sql(database, "SELECT " + UnpackSql("?1"));
  std::size_t packed_size = 0, size = 0;
  for (const auto& evidence : run.evidence)
    for (const SeasonEvidence& season : evidence)
      for (const std::string& json : {season.body, season.brain}) {
        const std::string packed = Pack(json);
        REQUIRE(Unpack(packed) == json);
        REQUIRE(sql.With(packed).Next());
        CHECK(sql.TakeText() == json);
        CHECK(nlohmann::json::accept(json));
        packed_size += packed.size();
        size += json.size();
      }
  CHECK(database.TakeFailure() == std::nullopt);
  // What it is for.
  CHECK(packed_size * 2 < size);
}

TEST_CASE("Any text is unpacked", "[packing]") {
  CHECK(Unpack("").empty());
  CHECK(Unpack("\x01\xff!") == "\x01\xff,\"y\":");
}

}  // namespace plsc
