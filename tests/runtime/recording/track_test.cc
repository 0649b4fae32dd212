#include "runtime/recording/track.h"

#include <catch2/catch.hpp>
#include <random>

namespace plsc {
namespace {

Eigen::MatrixXd Row(std::initializer_list<double> numbers) {
  Eigen::MatrixXd row(1, static_cast<Eigen::Index>(numbers.size()));
  Eigen::Index i = 0;
  for (const double number : numbers) row(0, i++) = number;
  return row;
}

TEST_CASE("tracks are written as documented", "[track_text]") {
  struct Row_ {
    const char* why;
    Eigen::MatrixXd numbers;
    double unit;
    const char* text;
  };
  const std::vector<Row_> rows = {
      {"nothing", Eigen::MatrixXd(0, 5), 1, ""},
      {"0, -1, 1: 0, -1, +2 are the bytes 0, 1, 4", Row({0, -1, 1}), 1, "AAEE"},
      {"100 is 200, bytes 0xC8 0x01", Row({100}), 1, "yAE="},
      {"units", Row({0.001}), 1e-5, "yAE="},
      {"one byte", Row({-64}), 1, "fw=="},
  };
  for (const Row_& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(EncodeTrack(row.numbers, row.unit) == row.text);
      const auto back = DecodeTrack(row.text, row.numbers.rows(),
                                    row.numbers.cols(), row.unit);
      REQUIRE(back);
      CHECK(back->isApprox(row.numbers));
    }
  }
}

TEST_CASE("any whole units come back", "[track_text]") {
  std::mt19937_64 random(20);
  std::uniform_int_distribution<std::int64_t> bits(0, 53);
  Eigen::MatrixXd numbers(7, 50);
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    const auto size = std::int64_t{1} << bits(random);
    numbers(i) = static_cast<double>(
        std::uniform_int_distribution<std::int64_t>(-size, size)(random));
  }
  const auto back = DecodeTrack(EncodeTrack(numbers, 1), 7, 50, 1);
  REQUIRE(back);
  CHECK(*back == numbers);
}

TEST_CASE("numbers are off by half a unit at most", "[track_text]") {
  Eigen::MatrixXd numbers = Eigen::MatrixXd::Random(3, 1000);
  const auto back = DecodeTrack(EncodeTrack(numbers, 1e-3), 3, 1000, 1e-3);
  REQUIRE(back);
  CHECK((*back - numbers).cwiseAbs().maxCoeff() <= 0.5e-3 * (1 + 1e-12));
}

TEST_CASE("a broken track is nothing", "[track_text]") {
  struct Bad {
    const char* why;
    std::string text;
    Eigen::Index rows, columns;
  };
  const std::vector<Bad> rows = {
      {"too few numbers", "AAEE", 1, 4},
      {"too many numbers", "AAEE", 1, 2},
      {"another table of as many numbers is one", "AAEE", 2, 2},
      {"no base64", "AA?E", 1, 3},
      {"base64 cut off", "AAE", 1, 2},
      {"padding inside", "A=EE", 1, 3},
      {"a number cut off", "gIA=", 1, 1},
      {"a number without end", std::string(16, '/'), 1, 1},
      {"a number beyond 2^53", "/////////38=", 1, 1},
      {"more rows than memory", "AAEE", Eigen::Index{1} << 40,
       Eigen::Index{1} << 40},
      {"rows but no data", "", 3, 3},
  };
  for (const Bad& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(!DecodeTrack(row.text, row.rows, row.columns, 1));
    }
  }
}

}  // namespace
}  // namespace plsc
