#include "runtime/lsp/advice.h"

#include <iterator>
#include <utility>

#include "compiler/suppress.h"
#include "runtime/advice/lint.h"

namespace plsc::lsp {

void GiveMoreAdvice(Analysis& analysis, Advice* advice) {
  if (advice->is_whole) return;
  const auto& compiled = analysis.compiled();
  if (compiled && advice->linted < compiled->size()) {
    std::vector<Diagnostic> more = LintGenotype((*compiled)[advice->linted++]);
    std::move(more.begin(), more.end(), std::back_inserter(advice->found));
  }
  if (compiled && advice->linted < compiled->size()) return;
  advice->found = Suppressions(analysis.file()).Keep(std::move(advice->found));
  SortAndDropRepeated(&advice->found);
  advice->is_whole = true;
}

}  // namespace plsc::lsp
