// A formatter that moves items must carry comments along and lose none. So the
// file is cut first: each item becomes a Part with the run of comments that
// belongs to it, the runs follow each other in file order, and what is left
// behind the last item is the tail. Every comment is thus in exactly one place,
// and writing all parts writes every comment once, in whatever order the parts
// come. Writing then keeps an index of the next comment and moves it only
// forward.
//
// Parts are sorted stably by section, kind and (rules) head. Stably, because
// the order of rules of one head is their order when they are joined, and the
// order of environments is that of tables: it means something and must stay.
//
// Formatting what was formatted changes nothing; tests and the fuzzer hold it
// to that. Whoever adds a blank line or a break here must make sure that it is
// seen as the same one when read again. Linear but for the sort.

#include "compiler/layout.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "compiler/item_text.h"

namespace plsc {

namespace {

// An item, or the version line, with the comments that belong to it.
struct Part {
  const ast::Item* item = nullptr;  // null: the version line
  Span span;
  std::size_t section = 0;        // genotypes that began before it or with it
  std::size_t first_comment = 0;  // of File::comments
  std::size_t end_comment = 0;
  bool is_blank_before = false;  // an empty line stands before it
};

class Writer {
 public:
  Writer(const ast::File& file, std::span<const AlphabetPtr> alphabets,
         bool is_compact)
      : file_(file), alphabets_(alphabets), is_compact_(is_compact) {}

  std::string Write() {
    std::vector<Part> parts = SplitIntoParts();
    std::stable_sort(
        parts.begin(), parts.end(),
        [&](const Part& a, const Part& b) { return RankOf(a) < RankOf(b); });
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (i > 0 && WantsBlank(parts[i - 1], parts[i])) text_ += '\n';
      WritePart(parts[i]);
    }
    WriteTail();
    return std::move(text_);
  }

 private:
  bool HasComment(std::size_t index, std::uint32_t before) const {
    return index < file_.comments.size() &&
           file_.comments[index].begin < before;
  }

  std::string_view CommentText(std::size_t index) const {
    std::string_view text = file_.Text(file_.comments[index]);
    const std::size_t last = text.find_last_not_of(" \t\r");
    return text.substr(0, last + 1);
  }

  std::size_t CountLines(std::uint32_t from, std::uint32_t to) const {
    if (to <= from) return 0;
    const std::string_view between = file_.Text({from, to});
    return static_cast<std::size_t>(
        std::count(between.begin(), between.end(), '\n'));
  }
  bool IsBlankBetween(std::uint32_t from, std::uint32_t to) const {
    return CountLines(from, to) > 1;
  }

  std::vector<Part> SplitIntoParts() {
    std::vector<Part> parts;
    parts.reserve(file_.items.size() + 1);
    parts.push_back({nullptr, file_.version, 0, 0, 0, false});
    // A genotype's name may stand anywhere in a file of one.
    const bool has_sections = file_.genotypes.size() > 1;
    std::size_t section = 0;
    for (const ast::Item& item : file_.items) {
      if (has_sections && item.kind == ast::ItemKind::kGenotype) ++section;
      parts.push_back({&item, item.span, section, 0, 0, false});
    }
    std::size_t next = 0;
    std::uint32_t last_end = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Part& part = parts[i];
      part.first_comment = next;
      const std::uint32_t begin = HasComment(next, part.span.begin)
                                      ? file_.comments[next].begin
                                      : part.span.begin;
      // What follows the version line is set apart anyway.
      part.is_blank_before = i > 1 && IsBlankBetween(last_end, begin);
      // All that begin before its end are its own, before it or inside it; and
      // one more behind it, if it is on the same line.
      while (HasComment(next, part.span.end)) ++next;
      last_end = part.span.end;
      const auto limit = i + 1 < parts.size()
                             ? parts[i + 1].span.begin
                             : static_cast<std::uint32_t>(file_.text.size());
      if (HasComment(next, limit) &&
          CountLines(last_end, file_.comments[next].begin) == 0)
        last_end = file_.comments[next++].end;
      part.end_comment = next;
    }
    tail_comment_ = next;
    tail_begin_ = last_end;
    return parts;
  }

  // Place in the file: sections stay where they are, and in each Print's
  // order, `let` before what may use it.
  using Rank = std::tuple<std::size_t, int, int>;
  Rank RankOf(const Part& part) const {
    const auto [kind, place] = RankInSection(part);
    return {part.section, kind, place};
  }

  std::pair<int, int> RankInSection(const Part& part) const {
    if (part.item == nullptr) return {0, 0};
    switch (part.item->kind) {
      case ast::ItemKind::kGenotype:
        return {1, 0};
      case ast::ItemKind::kAlphabet:
        return {2, 0};
      case ast::ItemKind::kSense:
        return {3, 0};
      case ast::ItemKind::kLet:
        return {4, 0};
      case ast::ItemKind::kAxiom:
        return {5, 0};
      case ast::ItemKind::kSetting:
        return {6, static_cast<int>(file_.settings[part.item->index].key)};
      case ast::ItemKind::kRule:
        return {7, HeadOf(part)};
      case ast::ItemKind::kEnvironment:
        return {8, 0};
      case ast::ItemKind::kTest:
        break;
    }
    return {9, 0};
  }

  // What stands before the first genotype belongs to all of them.
  const Alphabet& AlphabetOf(const Part& part) const {
    return *alphabets_[part.section == 0 ? 0 : part.section - 1];
  }

  int HeadOf(const Part& part) const {
    const Span head = file_.rules[part.item->index].head;
    return static_cast<int>(AlphabetOf(part).Find(file_.Text(head)).value());
  }

  // Rules, environments and tests are set apart from what is before them, and
  // each rule and test from the next unless it is compact; elsewhere the
  // writer's blank lines stay.
  bool WantsBlank(const Part& last, const Part& part) const {
    const int kind = RankInSection(part).first;
    const int last_kind = RankInSection(last).first;
    const bool is_first_of_kind =
        last_kind == 0 || (kind >= 7 && last_kind != kind);
    if (is_first_of_kind || part.section != last.section) return true;
    if (kind == 9) return !is_compact_ || part.is_blank_before;
    if (kind != 7) return part.is_blank_before;
    if (!is_compact_) return true;
    return HeadOf(part) != HeadOf(last) ||
           HasComment(part.first_comment, BracesOf(file_, *part.item).begin);
  }

  // `indent` blanks, the comment, a line's end.
  void WriteComment(std::size_t index, std::size_t indent) {
    text_.append(indent, ' ');
    text_ += CommentText(index);
    text_ += '\n';
  }

  // Between braces: an empty line where one stands before `begin`, but for the
  // first that stands there.
  void WriteParagraph(std::uint32_t begin) {
    if (last_end_ > 0 && IsBlankBetween(last_end_, begin)) text_ += '\n';
  }

  // Comments before `until`, each on a line; returns the next one. What stands
  // in the middle of an element, which begins at `begin`, moves before it.
  std::size_t WriteInner(std::size_t next, std::uint32_t begin,
                         std::uint32_t until) {
    for (; HasComment(next, until); ++next) {
      const Span comment = file_.comments[next];
      WriteParagraph(std::min(comment.begin, begin));
      WriteComment(next, 2);
      last_end_ = comment.end;
    }
    return next;
  }

  // A comment behind what ends at `end`, on the same line and before `until`.
  std::size_t WriteTrailing(std::size_t next, std::uint32_t end,
                            std::uint32_t until) {
    if (!HasComment(next, until) ||
        CountLines(end, file_.comments[next].begin) > 0)
      return next;
    text_ += "  ";
    text_ += CommentText(next);
    if (last_end_ > 0) last_end_ = file_.comments[next].end;
    return next + 1;
  }

  void WritePart(const Part& part) {
    const Span braces =
        part.item == nullptr ? Span{} : BracesOf(file_, *part.item);
    const bool has_inner =
        braces.end > 0 && HasCommentBetween(part, braces.begin, braces.end);
    ItemText item;
    if (part.item == nullptr)
      item.open = "plsc 1";
    else
      item = TextOf(file_, *part.item, has_inner);

    std::size_t next = part.first_comment;
    const std::uint32_t head_end =
        braces.end > 0 ? braces.begin : part.span.end;
    for (; next < part.end_comment && HasComment(next, head_end); ++next) {
      WriteComment(next, 0);
      const std::uint32_t following =
          next + 1 < part.end_comment && HasComment(next + 1, part.span.begin)
              ? file_.comments[next + 1].begin
              : part.span.begin;
      if (IsBlankBetween(file_.comments[next].end, following)) text_ += '\n';
    }
    text_ += item.open;
    if (item.has_braces) next = WriteElements(part, item, next, has_inner);
    if (next < part.end_comment)
      WriteTrailing(next, part.span.end, file_.comments[next].end);
    text_ += '\n';
  }

  bool HasCommentBetween(const Part& part, std::uint32_t begin,
                         std::uint32_t end) const {
    for (std::size_t i = part.first_comment; i < part.end_comment; ++i)
      if (file_.comments[i].begin > begin && file_.comments[i].begin < end)
        return true;
    return false;
  }

  // An element goes on the line of the one before it in compact rules only, and
  // as long as no comment, paragraph, group or width asks for a new line.
  std::size_t WriteElements(const Part& part, const ItemText& item,
                            std::size_t next, bool has_inner) {
    const bool is_rule = part.item->kind == ast::ItemKind::kRule;
    const bool is_string = part.item->kind == ast::ItemKind::kTest &&
                           file_.tests[part.item->index].nodes.count == 0;
    if (((is_compact_ && is_rule) || is_string) && !has_inner &&
        !HasParagraphs(item) && WriteOnOneLine(item))
      return next;
    last_end_ = 0;
    const std::uint32_t close = item.braces.end - 1;
    const std::uint32_t first =
        item.elements.empty() ? close : item.elements.front().span.begin;
    next = WriteTrailing(next, item.braces.begin + 1, first);
    text_ += '\n';
    bool is_line_begun = false;
    std::size_t line_begin = text_.size();
    const auto end_line = [&] {
      if (is_line_begun) text_ += '\n';
      is_line_begun = false;
    };
    for (std::size_t i = 0; i < item.elements.size(); ++i) {
      const ItemElement& element = item.elements[i];
      const bool begins_paragraph =
          last_end_ > 0 && IsBlankBetween(last_end_, element.span.begin);
      if (begins_paragraph || HasComment(next, element.span.end)) end_line();
      next = WriteInner(next, element.span.begin, element.span.end);
      WriteParagraph(element.span.begin);
      const std::size_t width =
          text_.size() - line_begin + 1 + element.text.size();
      if (is_line_begun && width > kLineWidth) end_line();
      if (!is_line_begun) line_begin = text_.size();
      text_ += is_line_begun ? " " : "  ";
      text_ += element.text;
      is_line_begun = true;
      last_end_ = element.span.end;
      const bool is_last = i + 1 == item.elements.size();
      const std::size_t before = next;
      next = WriteTrailing(next, element.span.end,
                           is_last ? close : item.elements[i + 1].span.begin);
      // Behind a comment nothing can go on; it ends with its line.
      const bool may_go_on =
          is_compact_ && is_rule && next == before && !EndsGroup(part, i);
      if (!may_go_on) end_line();
    }
    end_line();
    next = WriteInner(next, close, close);
    last_end_ = 0;
    text_ += '}';
    return next;
  }

  bool HasParagraphs(const ItemText& item) const {
    for (std::size_t i = 1; i < item.elements.size(); ++i)
      if (IsBlankBetween(item.elements[i - 1].span.end,
                         item.elements[i].span.begin))
        return true;
    return false;
  }

  // `rule X -> { X Y }`, if that fits.
  bool WriteOnOneLine(const ItemText& item) {
    std::string line = item.open;
    for (const ItemElement& element : item.elements) line += " " + element.text;
    line += " }";
    if (line.size() > kLineWidth) return false;
    text_ += line.substr(item.open.size());
    return true;
  }

  // In the paper's genotypes a group is a controller-moving, a controller-
  // changing and a mounting command, a module and a moving command.
  bool EndsGroup(const Part& part, std::size_t index) const {
    const ast::Rule& rule = file_.rules[part.item->index];
    const ast::Symbol& symbol = ast::Slice(file_.symbols, rule.symbols)[index];
    const Alphabet& alphabet = AlphabetOf(part);
    const auto id = alphabet.Find(file_.Text(symbol.name));
    const SymbolInfo& info = alphabet[id.value()];
    if (!alphabet.is_built_in()) return false;
    return info.category == Category::kMoving || id == plasticoding::kC;
  }

  // Comments behind the last item stay at the end.
  void WriteTail() {
    if (tail_comment_ == file_.comments.size()) return;
    if (IsBlankBetween(tail_begin_, file_.comments[tail_comment_].begin))
      text_ += '\n';
    for (std::size_t i = tail_comment_; i < file_.comments.size(); ++i) {
      WriteComment(i, 0);
      if (i + 1 < file_.comments.size() &&
          IsBlankBetween(file_.comments[i].end, file_.comments[i + 1].begin))
        text_ += '\n';
    }
  }

  const ast::File& file_;
  const std::span<const AlphabetPtr> alphabets_;  // of the genotypes
  const bool is_compact_;
  std::string text_;
  // Between braces: where what was written last ends; 0 at the first.
  std::uint32_t last_end_ = 0;
  std::size_t tail_comment_ = 0;
  std::uint32_t tail_begin_ = 0;
};

}  // namespace

std::string Layout(const ast::File& file,
                   std::span<const AlphabetPtr> alphabets, bool is_compact) {
  return Writer(file, alphabets, is_compact).Write();
}

}  // namespace plsc
