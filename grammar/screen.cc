// Cheap questions about bytes before the parser sees them, in the order in
// which their answers help: a file of another encoding also has bytes that are
// no UTF-8, one with merge markers also has syntax errors, and one message that
// names the cause is better than a hundred of its effects. Each is one pass;
// UTF-8 is checked eight bytes at a time where they are ASCII, as nearly all
// are.

#include "grammar/screen.h"

#include <fmt/format.h>

#include <array>
#include <cstring>

#include "grammar/foreign_file.h"
#include "grammar/utf8.h"

namespace plsc {

namespace {

Diagnostic At(Code code, std::size_t offset, std::string message) {
  const auto begin = static_cast<std::uint32_t>(offset);
  return {code, {begin, begin}, std::move(message)};
}

bool HasHighBit(const char* bytes) {
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof word);
  return (word & 0x8080808080808080U) != 0;
}

// Bytes of the UTF-8 character at `i`, 0 if there is none. Refuses overlong
// forms, surrogates and what lies beyond U+10FFFF (RFC 3629, section 4).
std::size_t Utf8Length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) -> unsigned {
    return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0;
  };
  const auto continues = [&](std::size_t k) {
    return i + k < text.size() && GoesOn(text[i + k]);
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return continues(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    if (lead == 0xE0 && byte(1) < 0xA0) return 0;
    if (lead == 0xED && byte(1) > 0x9F) return 0;
    return continues(1) && continues(2) ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    if (lead == 0xF0 && byte(1) < 0x90) return 0;
    if (lead == 0xF4 && byte(1) > 0x8F) return 0;
    return continues(1) && continues(2) && continues(3) ? 4 : 0;
  }
  return 0;
}

std::optional<std::size_t> FirstBadByte(std::string_view text) {
  std::size_t i = 0;
  while (i < text.size()) {
    if (i + 8 <= text.size() && !HasHighBit(text.data() + i)) {
      i += 8;
      continue;
    }
    const std::size_t length = Utf8Length(text, i);
    if (length == 0) return i;
    i += length;
  }
  return std::nullopt;
}

std::optional<Diagnostic> ScreenEncoding(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return At(Code::kNotUtf8, 0, "this file is UTF-16, not UTF-8")
        .WithHelp("save it as UTF-8");
  }
  const std::size_t nul = text.find('\0');
  if (nul != std::string_view::npos)
    return At(Code::kNotText, nul,
              fmt::format("this is not a text: byte 0x00 at offset {}", nul));
  if (const auto bad = FirstBadByte(text))
    return At(Code::kNotUtf8, *bad,
              fmt::format("not UTF-8 text: byte 0x{:02X} at offset {}",
                          static_cast<unsigned char>(text[*bad]), *bad));
  return std::nullopt;
}

// Git's markers: seven of one character at the start of a line.
std::optional<Diagnostic> ScreenMerge(std::string_view text) {
  static constexpr std::array<std::string_view, 2> kMarkers = {"<<<<<<<",
                                                               ">>>>>>>"};
  for (const std::string_view marker : kMarkers) {
    std::size_t at = text.find(marker);
    while (at != std::string_view::npos) {
      if (at == 0 || text[at - 1] == '\n') {
        Diagnostic diagnostic =
            At(Code::kMergeConflict, at, "unresolved merge conflict marker");
        diagnostic.span.end += static_cast<std::uint32_t>(marker.size());
        return diagnostic.WithLabel(
            "resolve the conflict and remove the markers");
      }
      at = text.find(marker, at + 1);
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Diagnostic> Screen(const Source& source) {
  std::string_view text = source.text();
  if (text.size() > kMaxSourceBytes)
    return At(Code::kTooLargeFile, 0,
              fmt::format("file is {} MiB; the limit is {} MiB",
                          (text.size() + (1U << 20) - 1) >> 20,
                          kMaxSourceBytes >> 20));
  text.remove_prefix(TextBegin(text));
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return At(Code::kEmptyFile, 0, "file is empty")
        .WithHelp("a genotype file starts with 'plsc 1'");
  }
  if (auto encoding = ScreenEncoding(source.text())) return encoding;
  if (auto merge = ScreenMerge(source.text())) return merge;
  return DescribeForeignFile(source.text());
}

}  // namespace plsc
