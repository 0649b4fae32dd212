#include "runtime/lsp/formatting.h"

#include "compiler/format.h"
#include "runtime/lsp/text_edits.h"

namespace plsc::lsp {

Json FormattingEdits(const Analysis& analysis) {
  const Result<std::string> formatted = Format(analysis.source());
  if (!formatted) return nullptr;
  return EditsTo(analysis, *formatted);
}

}  // namespace plsc::lsp
