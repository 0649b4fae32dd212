#include "runtime/lsp/folding.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace plsc::lsp {

namespace {

struct Region {
  std::uint32_t first = 0;  // lines, both folded but for the first's text
  std::uint32_t last = 0;
  bool is_comment = false;
};

bool IsBlank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

class Folder {
 public:
  explicit Folder(Analysis& analysis)
      : lines_(analysis.lines()),
        text_(analysis.text()),
        file_(analysis.file()) {}

  Json Fold() {
    AddGenotypes();
    for (const ast::Item& item : file_.items) AddItem(item);
    AddComments();
    std::stable_sort(
        folds_.begin(), folds_.end(),
        [](const auto& a, const auto& b) { return a.first < b.first; });
    Json json = Json::array();
    for (const auto& fold : folds_) {
      Json one = {{"startLine", fold.first}, {"endLine", fold.last}};
      if (fold.is_comment) one["kind"] = "comment";
      json.push_back(std::move(one));
    }
    return json;
  }

 private:
  std::uint32_t LineOf(std::uint32_t offset) const {
    return lines_.PlaceAt(offset).line;
  }

  void Add(std::uint32_t first, std::uint32_t last, bool is_comment) {
    if (last > first) folds_.push_back({first, last, is_comment});
  }

  // Of several, each has what follows it.
  void AddGenotypes() {
    if (file_.genotypes.size() < 2) return;
    const ast::Item* genotype = nullptr;
    std::uint32_t end = 0;
    for (const ast::Item& item : file_.items) {
      if (item.kind == ast::ItemKind::kGenotype) {
        if (genotype != nullptr)
          Add(LineOf(genotype->span.begin), LineOf(end), false);
        genotype = &item;
      }
      end = item.span.end;
    }
    Add(LineOf(genotype->span.begin), LineOf(end), false);
  }

  void AddItem(const ast::Item& item) {
    const std::uint32_t first = LineOf(item.span.begin);
    std::uint32_t last = LineOf(item.span.end);
    if (last == first) return;
    const std::uint32_t begin = lines_.OffsetAt({last, 0});
    const std::string_view before = text_.substr(begin, item.span.end - begin);
    if (before.ends_with('}') && IsBlank(before.substr(0, before.size() - 1)))
      --last;
    Add(first, last, false);
  }

  // Comments alone on lines that follow each other.
  void AddComments() {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    bool is_open = false;
    for (const Span comment : file_.comments) {
      const std::uint32_t line = LineOf(comment.begin);
      const std::uint32_t begin = lines_.OffsetAt({line, 0});
      if (!IsBlank(text_.substr(begin, comment.begin - begin))) continue;
      if (!is_open || line != last + 1) {
        if (is_open) Add(first, last, true);
        first = line;
        is_open = true;
      }
      last = line;
    }
    if (is_open) Add(first, last, true);
  }

  const LineTable& lines_;
  const std::string_view text_;
  const ast::File& file_;
  std::vector<Region> folds_;
};

}  // namespace

Json FoldingRanges(Analysis& analysis) {
  return Folder(analysis).Fold();
}

}  // namespace plsc::lsp
