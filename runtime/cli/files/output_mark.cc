#include "runtime/cli/files/output_mark.h"

#include <array>
#include <cassert>

#include "runtime/report/claims_text.h"
#include "runtime/report/digest.h"
#include "runtime/report/tables.h"

namespace plsc::cli {

namespace {

using std::string_view_literals::operator""sv;

struct Mark {
  OutputKind kind;
  std::string_view name;
  std::string_view begins;
  std::string_view contains;  ///< near the beginning
};

// The formats' own opening: files of earlier versions have it, too. Of pictures
// it is what no drawing program leaves as it was.
constexpr std::array kMarks{
    Mark{OutputKind::kPage, "page", "<!DOCTYPE html>",
         R"(<meta name="generator" content="plsc">)"},
    Mark{OutputKind::kSvg, "picture",
         R"(<svg xmlns="http://www.w3.org/2000/svg" width=")",
         "</title>\n<style>."},
    Mark{OutputKind::kPng, "picture", "\x89PNG\r\n", "tEXtSoftware\0plsc"sv},
    Mark{OutputKind::kRecording, "recording", R"({"plsc_recording":)", ""},
    Mark{OutputKind::kTrajectory, "trajectory", "time,x,y,z,mass_x,", ""},
    Mark{OutputKind::kScenario, "scenario of trajectories", kScenarioMark, ""},
    Mark{OutputKind::kReport, "report", R"({"plsc_report":)", ""},
    Mark{OutputKind::kClaims, "list of claims", kClaimsMark, ""},
    Mark{OutputKind::kReportTable, "table", kTableMark, ""},
    Mark{OutputKind::kReportTables, "list of tables", kTablesMark, ""},
    Mark{OutputKind::kDigest, "digest", kDigestMark, ""},
    Mark{OutputKind::kChildren, "list of children", R"({"seed":)",
         R"(,"text":"plsc 1)"},
    Mark{OutputKind::kRunLines, "list of a run", R"({"run":{)", ""},
    Mark{OutputKind::kTestText, "report of tests", "", ""},
    Mark{OutputKind::kTestJson, "report of tests", R"({"file":)",
         R"("verdict":)"},
    Mark{OutputKind::kTestJunit, "report of tests", "<?xml",
         R"(<testsuites name="plsc test")"},
    Mark{OutputKind::kManual, "manual page", R"(.\" Made by `plsc man`;)", ""},
};

const Mark* MarkOf(OutputKind kind) {
  for (const Mark& mark : kMarks)
    if (mark.kind == kind) return &mark;
  return nullptr;
}

// "2 tests of 1 file: 2 as expected", the last line but for an advice.
bool EndsAsTests(std::string_view end) {
  const std::size_t words = end.rfind(" as expected");
  if (words == std::string_view::npos) return false;
  const std::size_t before = end.rfind('\n', words);
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  const std::string_view line = end.substr(begin, words - begin);
  return !line.empty() && line[0] >= '0' && line[0] <= '9' &&
         line.find(" test") != std::string_view::npos &&
         line.find(" file") != std::string_view::npos;
}

// PNG 1.2, annex D: CRC-32 as of ISO 3309, of the chunk's type and data.
std::uint32_t Crc(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit)
      crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320 : 0);
  }
  return ~crc;
}

std::string BigEndian(std::uint32_t number) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0})
    bytes += static_cast<char>(number >> shift & 0xFF);
  return bytes;
}

}  // namespace

std::string_view KindName(OutputKind kind) {
  const Mark* mark = MarkOf(kind);
  assert(mark != nullptr);
  return mark->name;
}

bool IsReplaced(OutputKind kind) {
  return MarkOf(kind) != nullptr;
}

bool HasMark(OutputKind kind, std::string_view beginning,
             std::string_view end) {
  const Mark* mark = MarkOf(kind);
  if (mark == nullptr) return false;
  if (kind == OutputKind::kTestText) return EndsAsTests(end);
  return beginning.starts_with(mark->begins) &&
         beginning.find(mark->contains) != std::string_view::npos;
}

std::string MarkedPng(std::string_view png) {
  // Eight bytes of signature, then the header's chunk of 13 and 12 bytes, which
  // must be first.
  constexpr std::size_t kHeader = 8 + 13 + 12;
  if (png.size() < kHeader) return std::string(png);
  const std::string chunk("tEXtSoftware\0plsc"sv);
  return std::string(png.substr(0, kHeader)) +
         BigEndian(static_cast<std::uint32_t>(chunk.size() - 4)) + chunk +
         BigEndian(Crc(chunk)) + std::string(png.substr(kHeader));
}

}  // namespace plsc::cli
