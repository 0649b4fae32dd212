// A file is cut so that writing the pieces one after the other gives the file
// again, byte for byte: each byte between two cuts belongs to the blanks before
// the next piece, but that a comment on the line of a piece goes with that
// piece. A merge then chooses pieces and cannot lose a comment on the way.
// Beside its bytes each piece has its content, spelled in one way, by which
// versions are compared: layout is no difference.

#include "compiler/changes/written_items.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/item_text.h"
#include "grammar/number.h"
#include "grammar/parse.h"

namespace plsc {

namespace {

std::string ValueContent(const ast::File& file, const ast::Value& value) {
  if (value.kind == ast::Value::Kind::kNumber) return PrintNumber(value.number);
  return std::string(file.Text(value.span));
}

// The comment that begins on the line where the text begins, with the blanks
// before it; empty if there is none.
std::string_view CommentOfLine(std::string_view text) {
  const std::size_t mark = text.find_first_not_of(" \t");
  if (mark == std::string_view::npos || text[mark] != '#') return {};
  return text.substr(0, text.find_first_of("\r\n", mark));
}

// Where the parts begin: behind '{' and a comment on its line.
std::uint32_t BehindBrace(const ast::File& file, Span braces) {
  const std::uint32_t behind = braces.begin + 1;
  return behind + static_cast<std::uint32_t>(
                      CommentOfLine(file.Text({behind, braces.end})).size());
}

// Cuts bytes [begin, end) of the file into parts at the given places.
class PartCutter {
 public:
  PartCutter(const ast::File& file, std::uint32_t begin)
      : file_(file), at_(begin) {}

  void Add(Span span, PartContent content) {
    WrittenPart part;
    part.content = std::move(content);
    part.before = Take(span.begin);
    part.text = Take(span.end);
    parts_.push_back(std::move(part));
  }
  /// What is left until `end`, after the last part's comment was taken.
  std::string Rest(std::uint32_t end) { return Take(end); }
  std::vector<WrittenPart> Parts() { return std::move(parts_); }

 private:
  std::string Take(std::uint32_t end) {
    std::string_view text = file_.Text({at_, end});
    if (!parts_.empty() && parts_.back().after.empty()) {
      parts_.back().after = CommentOfLine(text);
      text.remove_prefix(parts_.back().after.size());
    }
    at_ = end;
    return std::string(text);
  }

  const ast::File& file_;
  std::uint32_t at_;
  std::vector<WrittenPart> parts_;
};

void CutSymbols(const ast::File& file, ast::Range range, Span braces,
                WrittenItem* item) {
  PartCutter cutter(file, BehindBrace(file, braces));
  for (const ast::Symbol& symbol : ast::Slice(file.symbols, range)) {
    PartContent content{std::string(file.Text(symbol.name)), {}};
    for (const ast::Value& value : ast::Slice(file.arguments, symbol.arguments))
      content.values.push_back(ValueContent(file, value));
    cutter.Add(symbol.span, std::move(content));
  }
  item->close = cutter.Rest(braces.end);
  item->parts = cutter.Parts();
}

void CutEntries(const ast::File& file, const ast::Environment& environment,
                Span braces, WrittenItem* item) {
  PartCutter cutter(file, BehindBrace(file, braces));
  for (const ast::Entry& entry :
       ast::Slice(file.entries, environment.entries)) {
    // With its comma, which may stand after blanks but hardly after comments.
    Span span = entry.span;
    const std::size_t next = file.text.find_first_not_of(" \t", span.end);
    if (next != std::string_view::npos && file.text[next] == ',')
      span.end = static_cast<std::uint32_t>(next) + 1;
    cutter.Add(span, {std::string(file.Text(entry.state)),
                      {ValueContent(file, entry.value)}});
  }
  item->close = cutter.Rest(braces.end);
  item->parts = cutter.Parts();
}

std::vector<WrittenPart> TermsOf(const ast::File& file, const ast::Rule& rule) {
  std::vector<WrittenPart> terms;
  for (const ast::Term& term : ast::Slice(file.terms, rule.terms)) {
    WrittenPart part;
    std::string connective;
    if (term.connective == ast::Connective::kAnd) connective = "and";
    if (term.connective == ast::Connective::kOr) connective = "or";
    part.content = {std::string(file.Text(term.state)),
                    {connective, std::string(file.Text(term.comparison_span)),
                     std::string(file.Text(term.value.span))}};
    terms.push_back(std::move(part));
  }
  return terms;
}

std::string WholeContent(const ItemText& text) {
  std::string content = text.open;
  for (const ItemElement& element : text.elements)
    content += '\n' + element.text;
  return content;
}

std::string KeyOf(const ast::File& file, const ast::Item& item) {
  std::string keyword(file.Text(item.keyword));
  const auto named = [&](Span name) {
    return keyword + ' ' + std::string(file.Text(name));
  };
  switch (item.kind) {
    case ast::ItemKind::kSense:
      return named(file.senses[item.index].name);
    case ast::ItemKind::kLet:
      return named(file.lets[item.index].name);
    case ast::ItemKind::kRule:
      return named(file.rules[item.index].head);
    case ast::ItemKind::kEnvironment:
      return named(file.environments[item.index].name);
    case ast::ItemKind::kTest:
      return named(file.tests[item.index].name);
    case ast::ItemKind::kGenotype:
    case ast::ItemKind::kAlphabet:
    case ast::ItemKind::kAxiom:
    case ast::ItemKind::kSetting:
      break;
  }
  return keyword;
}

// Without `before` and `after`.
WrittenItem CutItem(const ast::File& file, const ast::Item& item) {
  WrittenItem cut;
  cut.kind = item.kind;
  cut.key = KeyOf(file, item);
  cut.span = item.span;
  const ItemText text = TextOf(file, item, true);
  const Span braces = BracesOf(file, item);
  cut.content = text.open;
  if (item.kind == ast::ItemKind::kRule) {
    const ast::Rule& rule = file.rules[item.index];
    cut.terms = TermsOf(file, rule);
    CutSymbols(file, rule.symbols, braces, &cut);
  } else if (item.kind == ast::ItemKind::kEnvironment) {
    CutEntries(file, file.environments[item.index], braces, &cut);
  } else if (item.kind == ast::ItemKind::kTest &&
             file.tests[item.index].nodes.count == 0) {
    CutSymbols(file, file.tests[item.index].symbols, braces, &cut);
  } else {
    cut.content = WholeContent(text);
    cut.open = file.Text(item.span);
    return cut;
  }
  cut.open = file.Text({item.span.begin, BehindBrace(file, braces)});
  return cut;
}

WrittenItem Version(const ast::File& file) {
  WrittenItem version;
  version.key = "plsc";
  version.kind = ast::ItemKind::kSetting;
  version.span = file.version;
  version.open = file.Text(file.version);
  version.content = "plsc " + std::string(file.Text(file.version_number.span));
  return version;
}

}  // namespace

std::string PartText(const PartContent& content) {
  if (content.values.empty()) return content.name;
  return fmt::format("{}({})", content.name, fmt::join(content.values, ", "));
}

WrittenFile CutIntoItems(const ast::File& file) {
  WrittenFile written;
  std::uint32_t at = 0;
  const auto add = [&](WrittenItem item) {
    std::string_view gap = file.Text({at, item.span.begin});
    if (!written.items.empty()) {
      written.items.back().after = CommentOfLine(gap);
      gap.remove_prefix(written.items.back().after.size());
    }
    item.before = gap;
    at = item.span.end;
    written.items.push_back(std::move(item));
  };
  if (file.version.end > 0) add(Version(file));
  for (const ast::Item& item : file.items) add(CutItem(file, item));
  std::string_view rest = file.text.substr(at);
  if (!written.items.empty()) {
    written.items.back().after = CommentOfLine(rest);
    rest.remove_prefix(written.items.back().after.size());
  }
  written.end = rest;
  return written;
}

WrittenFile ReadItems(const Source& source) {
  if (source.text().find_first_not_of(" \t\r\n") == std::string_view::npos)
    return {};
  return CutIntoItems(Parse(source).file);
}

std::size_t CountGenotypes(const WrittenFile& file) {
  return static_cast<std::size_t>(std::count_if(
      file.items.begin(), file.items.end(), [](const WrittenItem& item) {
        return item.kind == ast::ItemKind::kGenotype;
      }));
}

std::string CoreText(const WrittenItem& item) {
  std::string text = item.open;
  for (const WrittenPart& part : item.parts)
    text += part.before + part.text + part.after;
  return text + item.close;
}

std::vector<std::string> CommentsIn(std::string_view text) {
  std::vector<std::string> comments;
  for (std::size_t mark = text.find('#'); mark != std::string_view::npos;
       mark = text.find('#', mark)) {
    const std::size_t end = std::min(text.find('\n', mark), text.size());
    std::string_view comment = text.substr(mark, end - mark);
    comment = comment.substr(0, comment.find_last_not_of(" \t\r") + 1);
    comments.emplace_back(comment);
    mark = end;
  }
  return comments;
}

}  // namespace plsc
