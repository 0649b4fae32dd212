#include "runtime/cli/files/output_mark.h"

#include <catch2/catch.hpp>
#include <string>

namespace plsc {
namespace {

using cli::OutputKind;

// What each command writes carries its mark: outputs_test.cc.
TEST_CASE("A mark is at the place of its kind, or there is none",
          "[output_mark]") {
  const std::string page =
      "<!DOCTYPE html>\n<meta name=\"generator\" content=\"plsc\">";
  CHECK(cli::HasMark(OutputKind::kPage, page, page));
  CHECK_FALSE(cli::HasMark(OutputKind::kSvg, page, page));
  CHECK_FALSE(cli::HasMark(OutputKind::kPage, "# " + page, page));
  CHECK_FALSE(cli::HasMark(OutputKind::kGenotype, "plsc 1\n", "plsc 1\n"));
  CHECK_FALSE(cli::IsReplaced(OutputKind::kRobot));

  const auto is_text = [](const std::string& end) {
    return cli::HasMark(OutputKind::kTestText, "", end);
  };
  CHECK(is_text("2 tests of 1 file: 2 as expected\n"));
  CHECK(is_text("...\n1 test of 2 files: 0 as expected, 1 differs\nmore\n"));
  CHECK_FALSE(is_text("The tests of my file went as expected\n"));
  CHECK_FALSE(is_text("2 of them as expected\n"));
}

TEST_CASE("A picture's mark is a chunk of text behind its header",
          "[output_mark]") {
  // 1 x 1, of the specification's order of chunks; only the header matters.
  const std::string header(
      "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\10\2"
      "\0\0\0\x90wS\xde",
      33);
  const std::string png = header + "the rest";
  const std::string marked = cli::MarkedPng(png);
  CHECK(marked.starts_with(header));
  CHECK(marked.ends_with("the rest"));
  // The check sum as zlib.crc32(b"tEXtSoftware\0plsc") has it.
  CHECK(marked.substr(header.size(), marked.size() - png.size()) ==
        std::string("\0\0\0\rtEXtSoftware\0plsc", 21) + std::string("\xc0"
                                                                    "\xf4"
                                                                    "\x2f"
                                                                    "\x84",
                                                                    4));
  CHECK(cli::HasMark(OutputKind::kPng, marked, marked));
  CHECK_FALSE(cli::HasMark(OutputKind::kPng, png, png));
  CHECK(cli::MarkedPng("short") == "short");
}

}  // namespace
}  // namespace plsc
