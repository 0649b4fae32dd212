#include "compiler/changes/merge_message.h"

#include <fmt/format.h>

namespace plsc {

namespace {

std::string SideText(const std::string& text, const std::string& label) {
  return text.empty() ? "deleted in " + label
                      : fmt::format("'{}' in {}", text, label);
}

std::string Sentence(const ItemClash& clash, const MergeLabels& labels) {
  const std::string& inserter =
      clash.ours.empty() ? labels.theirs : labels.ours;
  const std::string& deleter = clash.ours.empty() ? labels.ours : labels.theirs;
  const std::string& inserted = clash.ours.empty() ? clash.theirs : clash.ours;
  switch (clash.kind) {
    case ClashKind::kBothInserted:
      if (!clash.ours.empty() && !clash.theirs.empty())
        return fmt::format("'{}' is added in {} and '{}' in {}, at one place",
                           clash.ours, labels.ours, clash.theirs,
                           labels.theirs);
      return fmt::format("'{}' is added in {}, where {} adds something else",
                         inserted, inserter, deleter);
    case ClashKind::kInsertedIntoDeleted:
      return fmt::format("'{}' is added in {} between what {} deletes",
                         inserted, inserter, deleter);
    case ClashKind::kAmbiguous:
      return "equal neighbours were changed, and the order of the merge cannot "
             "be told";
    case ClashKind::kBothMoved:
      return fmt::format(
          "'{}' changes places with one symbol in {} and with "
          "another in {}",
          clash.base, labels.ours, labels.theirs);
    case ClashKind::kBothChanged:
    case ClashKind::kDeletedAndChanged:
      break;
  }
  if (clash.base.empty() && clash.ours.empty() && clash.theirs.empty())
    return "changed by both";
  const std::string was =
      clash.base.empty() ? "" : fmt::format("'{}' is ", clash.base);
  return was + SideText(clash.ours, labels.ours) + " and " +
         SideText(clash.theirs, labels.theirs);
}

}  // namespace

std::string DescribeClash(const ItemClash& clash, const MergeLabels& labels) {
  const std::string sentence = Sentence(clash, labels);
  return clash.what.empty() ? sentence : clash.what + ": " + sentence;
}

}  // namespace plsc
