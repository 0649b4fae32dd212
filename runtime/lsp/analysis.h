#pragma once

// All that is known of one version of a document, each part made when somebody
// asks and then kept: a keystroke wants the diagnostics only. Also of broken
// texts: what could be read of them has sections and mentions.

#include <optional>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "compiler/resolve.h"
#include "compiler/scope.h"
#include "grammar/parse.h"
#include "runtime/lsp/line_table.h"
#include "runtime/lsp/mentions.h"
#include "runtime/lsp/section.h"

namespace plsc::lsp {

/// Parts refer to the text, so that it can be neither copied nor moved.
class Analysis {
 public:
  Analysis(const std::string& uri, std::string text);
  Analysis(const Analysis&) = delete;
  Analysis& operator=(const Analysis&) = delete;
  ~Analysis() = default;

  const std::string& uri() const { return source_.name(); }
  const Source& source() const { return source_; }
  std::string_view text() const { return source_.text(); }
  const LineTable& lines() const { return lines_; }

  /// What Compile says; see CompileAllWithMap.
  const Result<std::vector<MappedProgram>>& compiled();
  const ast::File& file();
  const std::vector<Section>& sections();
  /// The one that holds `offset`; of what all share, the first.
  const Section& SectionAt(std::uint32_t offset);
  /// By position; no two overlap.
  const std::vector<Mention>& mentions();
  /// The name at `offset`, or that ends there; nullptr when there is none.
  const Mention* MentionAt(std::uint32_t offset);

 private:
  Source source_;
  LineTable lines_;
  std::optional<Result<std::vector<MappedProgram>>> compiled_;
  std::optional<ParseResult> parsed_;
  std::optional<std::vector<Section>> sections_;
  std::optional<std::vector<Mention>> mentions_;
};

}  // namespace plsc::lsp
