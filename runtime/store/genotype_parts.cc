// A printed genotype falls into its header, its name in the middle of that, and
// its rules, by what Print writes between them and nowhere else. Joined they
// are the text again, so a store can keep each rule and each header once.

#include "runtime/store/genotype_parts.h"

#include <cassert>

namespace plsc {

GenotypeParts SplitGenotype(std::string_view text, std::string_view name) {
  constexpr std::string_view kName = "genotype ";
  // Print writes this and nothing else before a rule.
  constexpr std::string_view kRule = "\n\nrule ";
  GenotypeParts parts;
  const std::size_t name_at = text.find(kName) + kName.size();
  assert(text.substr(name_at, name.size()) == name);
  parts.before_name = text.substr(0, name_at);
  text.remove_prefix(name_at + name.size());
  std::size_t end = text.find(kRule);
  // The first of the two newlines ends what is before.
  const auto end_of = [&] {
    return end == std::string_view::npos ? text.size() : end + 1;
  };
  parts.after_name = text.substr(0, end_of());
  while (end != std::string_view::npos) {
    text.remove_prefix(end + 2);
    end = text.find(kRule);
    parts.rules.emplace_back(text.substr(0, end_of()));
  }
  return parts;
}

}  // namespace plsc
