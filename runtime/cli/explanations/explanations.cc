#include "runtime/cli/explanations/explanations.h"

#include <algorithm>

namespace plsc::cli {

std::vector<Explanation> Explanations() {
  std::vector<Explanation> all;
  for (const auto table :
       {SyntaxExplanations(), NameExplanations(), RegulationExplanations(),
        FileExplanations(), YamlExplanations(), HouseholdExplanations()})
    all.insert(all.end(), table.begin(), table.end());
  std::sort(all.begin(), all.end(),
            [](const Explanation& a, const Explanation& b) {
              return a.code < b.code;
            });
  return all;
}

const Explanation* FindExplanation(Code code) {
  static const std::vector<Explanation> all = Explanations();
  const auto found =
      std::find_if(all.begin(), all.end(),
                   [&](const Explanation& row) { return row.code == code; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace plsc::cli
