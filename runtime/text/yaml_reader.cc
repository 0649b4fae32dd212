// yaml-cpp reads what YAML allows, and that is more than a file of ours may
// say: keys twice, words for truth that change from version to version, numbers
// in octal, several documents. So only scalars, maps and lists are taken from
// it, as texts with places, and what they mean is read here and in quantity and
// yaml_words, strictly.
//
// A map knows the keys that it was asked for; when it is closed, what it has
// and nobody asked for is unknown, and the nearest key that is asked for and
// not given is what was meant. That is why every key is asked for, also those
// whose value is not needed, and why Close comes last.
//
// All errors of a file are found in one go: an error gives the default and
// reading goes on. Values are shared pointers into one document, so that a
// value may outlive its map. A hostile file can nest references until they fill
// memory when they are walked; who walks all of a value counts first
// (CountValues).

#include "runtime/text/yaml_reader.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>
#include <unordered_set>

#include "grammar/number.h"
#include "grammar/reporter.h"
#include "grammar/screen.h"
#include "grammar/suggest.h"
#include "runtime/text/scalar_place.h"
#include "runtime/text/yaml_words.h"

namespace plsc {

struct YamlDocument {
  const Source& source;
  YAML::Node root;
  Reporter reporter;
};

struct YamlNode {
  YAML::Node node;
};

namespace {

std::uint32_t OffsetOf(const Source& source, const YAML::Mark& mark) {
  const auto size = static_cast<std::uint32_t>(source.text().size());
  // A null mark (-1) and one past the end both point at the end.
  if (mark.line < 0 || mark.line >= source.line_count()) return size;
  std::uint32_t begin = source.LineBegin(mark.line + 1);
  // yaml-cpp does not count the byte order mark.
  if (mark.line == 0) begin += TextBegin(source.text());
  return std::min(begin + static_cast<std::uint32_t>(mark.column), size);
}

// yaml-cpp tags quoted scalars with "!", plain ones with "?".
bool IsQuoted(const YAML::Node& node) {
  return node.Tag() == "!";
}

Span SpanOf(const Source& source, const YAML::Node& node) {
  const std::uint32_t begin = OffsetOf(source, node.Mark());
  std::uint32_t end = begin + 1;
  if (node.IsScalar()) {
    const auto length = static_cast<std::uint32_t>(node.Scalar().size());
    end = begin + std::max(length + (IsQuoted(node) ? 2 : 0), 1u);
  }
  return {begin, std::min<std::uint32_t>(
                     end, static_cast<std::uint32_t>(source.text().size()))};
}

std::string Found(const YAML::Node& node) {
  if (node.IsMap()) return "a map";
  if (node.IsSequence()) return "a list";
  if (!node.IsScalar()) return "nothing";
  return fmt::format("'{}'", node.Scalar());
}

Diagnostic NotYaml(const Source& source, const YAML::Exception& error) {
  const std::uint32_t at = OffsetOf(source, error.mark);
  Diagnostic problem(Code::kNotYamlOrJson, {at, at},
                     fmt::format("this is not YAML: {}", error.msg));
  if (error.msg == YAML::ErrorMsg::MAP_VALUE)
    problem.WithHelp(
        "a text with ': ' in it, as a formula's choice, stands in "
        "quotes");
  return problem;
}

// Where documents begin; nothing else of them.
class DocumentCounter : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override {
    begins_.push_back(mark);
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

  const std::vector<YAML::Mark>& begins() const { return begins_; }

 private:
  std::vector<YAML::Mark> begins_;
};

// Of the first two documents. LoadAll would look for all of them, and finds
// them without end where a ',' stands outside of all brackets (yaml-cpp 0.7
// takes it for a document and does not go on).
std::vector<YAML::Mark> DocumentBegins(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DocumentCounter counter;
  while (counter.begins().size() < 2 && parser.HandleNextDocument(counter)) {
  }
  return counter.begins();
}

YAML::Node ParseOne(const Source& source, Reporter& reporter) {
  const bool is_blank =
      source.text().find_first_not_of(" \t\r\n") == std::string_view::npos;
  // Other encodings, binary and far too large files. (An empty one gets a
  // message about genotypes there.)
  if (std::optional<Diagnostic> no_text = Screen(source);
      no_text && !is_blank) {
    reporter.Add(std::move(*no_text));
    return {};
  }
  try {
    const std::string text(source.text());
    const std::vector<YAML::Mark> begins = DocumentBegins(text);
    if (begins.size() == 1) return YAML::Load(text);
    const std::uint32_t at = begins.empty() ? 0 : OffsetOf(source, begins[1]);
    const bool is_comma = !begins.empty() && text.substr(at, 1) == ",";
    reporter.Report(Code::kNotYamlOrJson, {at, at},
                    is_comma
                        ? "this is not YAML: a ',' outside of all brackets"
                        : fmt::format("expected one YAML document, found {}",
                                      begins.size()));
  } catch (const YAML::Exception& exception) {
    reporter.Add(NotYaml(source, exception));
  }
  return {};
}

template <typename IsRight>
std::string WholeNumberText(const std::string& written,
                            const IsRight& is_right) {
  const auto meant = WholeNumberMeant(written);
  return meant && is_right(*meant) ? std::to_string(*meant) : "";
}

}  // namespace

bool YamlValue::is_scalar() const {
  return node_->node.IsScalar();
}
bool YamlValue::is_map() const {
  return node_->node.IsMap();
}
bool YamlValue::is_quoted() const {
  return IsQuoted(node_->node);
}
std::string YamlValue::text() const {
  return node_->node.Scalar();
}
Span YamlValue::span() const {
  return SpanOf(document_->source, node_->node);
}

std::size_t YamlValue::CountEntries() const {
  return node_->node.size();
}

std::size_t YamlValue::CountValues(std::size_t most) const {
  std::size_t count = 0;
  std::vector<YAML::Node> open{node_->node};
  while (!open.empty() && count < most) {
    const YAML::Node node = open.back();
    open.pop_back();
    ++count;
    for (const auto& item : node) {
      if (open.size() > most) break;
      if (node.IsMap())
        open.push_back(item.second);
      else
        open.push_back(item);
    }
  }
  return count;
}

bool YamlValue::is_full() const {
  return document_->reporter.is_full();
}

void YamlValue::Report(Code code, std::string message, std::string help,
                       std::string replacement) const {
  if (is_full()) return;
  Diagnostic& diagnostic =
      document_->reporter.Report(code, span(), std::move(message))
          .WithHelp(std::move(help));
  if (!replacement.empty()) diagnostic.WithFix(span(), std::move(replacement));
}

void YamlValue::ReportPart(Diagnostic problem) const {
  if (is_full()) return;
  const Span all = span();
  const auto place = [&](Span part) {
    return PlaceInScalar(document_->source.text(), all.begin, text(), part);
  };
  problem.span = place(problem.span).value_or(all);
  std::vector<Fix> fixes;
  for (const Fix& fix : problem.fixes)
    if (const auto at = place(fix.span))
      fixes.push_back({*at, fix.replacement});
  problem.fixes = std::move(fixes);
  document_->reporter.Add(std::move(problem));
}

std::size_t YamlValue::error_count() const {
  return document_->reporter.diagnostics().size();
}

std::optional<double> YamlValue::Number(const Quantity& quantity) const {
  const std::string_view expected = DimensionName(quantity.dimension);
  if (!is_scalar()) {
    Report(Code::kWrongKind,
           fmt::format("expected {}, found {}", expected, Found(node_->node)),
           fmt::format("write it as in '{}'", ExampleOf(quantity)));
    return std::nullopt;
  }
  ParsedQuantity parsed = ParseQuantity(text(), quantity);
  if (is_quoted()) {
    const std::string meant = parsed.error ? parsed.error->replacement : text();
    ReportQuoted(expected, meant, ExampleOf(quantity));
    return std::nullopt;
  }
  if (!parsed.error) return parsed.value;
  using Kind = QuantityError::Kind;
  const Code code = parsed.error->kind == Kind::kNotANumber ? Code::kWrongKind
                    : parsed.error->kind == Kind::kRange    ? Code::kOutOfRange
                                                            : Code::kWrongUnit;
  Report(code, std::move(parsed.error->message), std::move(parsed.error->help),
         std::move(parsed.error->replacement));
  return std::nullopt;
}

std::optional<std::int64_t> YamlValue::Integer(
    std::int64_t low, std::int64_t high,
    std::optional<std::int64_t> usual) const {
  constexpr std::string_view kExpected = "a whole number";
  const std::string written = is_scalar() ? text() : "";
  using Read = LeadingNumber<std::int64_t>;
  const Read read = ReadNumber<std::int64_t>(written);
  const auto is_right = [&](std::int64_t value) {
    return value >= low && value <= high;
  };
  const std::string example =
      std::to_string(std::clamp(usual.value_or(low), low, high));
  if (is_quoted()) {
    ReportQuoted(kExpected, WholeNumberText(written, is_right), example);
    return std::nullopt;
  }
  if (read.length != written.size() || read.kind == Read::Kind::kNone) {
    const std::string meant = WholeNumberText(written, is_right);
    Report(Code::kWrongKind,
           fmt::format("expected {}, found {}", kExpected, Found(node_->node)),
           meant.empty() ? fmt::format("write it as in '{}'", example)
                         : fmt::format("write '{}'", meant),
           meant);
    return std::nullopt;
  }
  if (read.kind == Read::Kind::kFits && is_right(read.value)) return read.value;
  Report(Code::kOutOfRange,
         low == high
             ? fmt::format("expected {}, found {}", low, written)
             : fmt::format("expected a whole number of {} to {}, found {}", low,
                           high, written));
  return std::nullopt;
}

std::optional<std::uint64_t> YamlValue::Unsigned() const {
  const std::string written = is_scalar() ? text() : "";
  const auto number = ParseNumber<std::uint64_t>(written);
  if (number && !is_quoted()) return number;
  const std::string expected = fmt::format(
      "a whole number of 0 to {}", std::numeric_limits<std::uint64_t>::max());
  const auto is_right = [](std::int64_t value) { return value >= 0; };
  const std::string meant =
      number ? written : WholeNumberText(written, is_right);
  if (is_quoted())
    ReportQuoted(expected, meant, "1");
  else
    Report(
        Code::kWrongKind,
        fmt::format("expected {}, found {}", expected, Found(node_->node)),
        meant.empty() ? "write it as in '1'" : fmt::format("write '{}'", meant),
        meant);
  return std::nullopt;
}

std::optional<bool> YamlValue::Bool() const {
  const std::string written = is_scalar() ? text() : "";
  const std::string meant = TruthMeant(written);
  if (is_quoted()) {
    ReportQuoted("True or False", meant, "True");
    return std::nullopt;
  }
  if (written == "true" || written == "True") return true;
  if (written == "false" || written == "False") return false;
  Report(Code::kWrongKind,
         fmt::format("expected True or False, found {}", Found(node_->node)),
         meant.empty() ? "write 'True' or 'False'"
                       : fmt::format("write '{}'", meant),
         meant);
  return std::nullopt;
}

void YamlValue::ReportQuoted(std::string_view expected,
                             const std::string& meant,
                             const std::string& example) const {
  Report(Code::kWrongKind,
         fmt::format("expected {}, found a text in quotes", expected),
         meant.empty() ? fmt::format("write it as in '{}'", example)
                       : fmt::format("write '{}', without quotes", meant),
         meant);
}

std::optional<std::string> YamlValue::Text(std::string_view what) const {
  if (is_scalar() && !text().empty()) return text();
  Report(Code::kWrongKind,
         fmt::format("expected {}, found {}", what,
                     is_scalar() ? "an empty text" : Found(node_->node)));
  return std::nullopt;
}

std::optional<std::size_t> YamlValue::IndexIn(
    const std::vector<std::string_view>& names) const {
  const std::string written = is_scalar() ? text() : "";
  const auto found = std::find(names.begin(), names.end(), written);
  if (found != names.end())
    return static_cast<std::size_t>(found - names.begin());
  const auto nearest = Suggest(written, names);
  Report(is_scalar() ? Code::kUnknownWord : Code::kWrongKind,
         fmt::format("expected {}, found {}", fmt::join(names, " or "),
                     Found(node_->node)),
         nearest ? fmt::format("did you mean '{}'?", *nearest) : "",
         nearest.value_or(""));
  return std::nullopt;
}

std::optional<std::vector<YamlValue>> YamlValue::List(
    std::string_view what) const {
  if (!node_->node.IsSequence()) {
    Report(Code::kWrongKind, fmt::format("expected a list of {}, found {}",
                                         what, Found(node_->node)));
    return std::nullopt;
  }
  std::vector<YamlValue> values;
  for (const YAML::Node& item : node_->node)
    values.emplace_back(document_,
                        std::make_shared<const YamlNode>(YamlNode{item}));
  return values;
}

std::optional<YamlMap> YamlValue::Map(std::string_view what) const {
  if (!node_->node.IsMap()) {
    Report(Code::kWrongKind,
           fmt::format("expected {}, found {}", what, Found(node_->node)));
    return std::nullopt;
  }
  std::vector<YamlMap::Entry> entries;
  std::unordered_set<std::string> names;
  const auto wrap = [&](const YAML::Node& node) {
    return YamlValue(document_,
                     std::make_shared<const YamlNode>(YamlNode{node}));
  };
  for (const auto& pair : node_->node) {
    const YAML::Node& key = pair.first;
    const YamlValue at = wrap(key);
    if (!at.is_scalar()) {
      at.Report(Code::kWrongKind,
                fmt::format("expected a key, found {}", Found(key)));
      continue;
    }
    const std::string name = at.text();
    if (!names.insert(name).second)
      at.Report(Code::kRepeatedKey, fmt::format("'{}' is given twice", name),
                "keep one of them");
    else
      entries.push_back({name, at, wrap(pair.second)});
  }
  return YamlMap(*this, std::move(entries));
}

const std::vector<YamlMap::Entry>& YamlMap::TakeAll() {
  for (const Entry& entry : entries_) known_.push_back(entry.key);
  return entries_;
}

std::optional<YamlValue> YamlMap::Find(std::string_view key) {
  known_.emplace_back(key);
  for (const Entry& entry : entries_)
    if (entry.key == key) return entry.value;
  return std::nullopt;
}

std::optional<YamlValue> YamlMap::Need(std::string_view key,
                                       std::string_view help) {
  std::optional<YamlValue> value = Find(key);
  if (!value) missing_.emplace_back(key, help);
  return value;
}

double YamlMap::Number(std::string_view key, double otherwise,
                       const Quantity& quantity) {
  const std::optional<YamlValue> value = Find(key);
  if (!value) return otherwise;
  Quantity with_default = quantity;
  with_default.usual = otherwise;
  return value->Number(with_default).value_or(otherwise);
}

int YamlMap::Int(std::string_view key, int otherwise, int low, int high) {
  const std::optional<YamlValue> value = Find(key);
  if (!value) return otherwise;
  return static_cast<int>(
      value->Integer(low, high, otherwise).value_or(otherwise));
}

bool YamlMap::Bool(std::string_view key, bool otherwise) {
  const std::optional<YamlValue> value = Find(key);
  return value ? value->Bool().value_or(otherwise) : otherwise;
}

std::string YamlMap::Text(std::string_view key, const std::string& otherwise) {
  const std::optional<YamlValue> value = Find(key);
  return value ? value->Text("a name").value_or(otherwise) : otherwise;
}

void YamlMap::Close() const {
  const std::unordered_set<std::string_view> all(known_.begin(), known_.end());
  std::unordered_set<std::string_view> given;
  for (const Entry& entry : entries_) given.insert(entry.key);
  // In the order of asking, each once: some keys are asked for several times.
  std::vector<std::string_view> known;
  std::vector<std::string_view> free;
  std::unordered_set<std::string_view> listed;
  for (const std::string& key : known_) {
    if (!listed.insert(key).second) continue;
    known.push_back(key);
    if (!given.contains(key)) free.push_back(key);
  }
  std::unordered_set<std::string> meant;
  for (const Entry& entry : entries_) {
    if (all.contains(entry.key)) continue;
    if (place_.is_full()) return;
    // One that is there already cannot be meant.
    const auto nearest = Suggest(entry.key, free);
    entry.at.Report(
        Code::kUnknownKey, fmt::format("unknown key '{}'", entry.key),
        nearest ? fmt::format("did you mean '{}'?", *nearest)
                : fmt::format("known here: {}", fmt::join(known, ", ")),
        nearest.value_or(""));
    if (nearest) meant.insert(*nearest);
  }
  for (const auto& [key, help] : missing_)
    if (!meant.contains(key))
      place_.Report(Code::kMissingKey,
                    fmt::format("expected the key '{}' here", key), help);
}

YamlFile::YamlFile(const Source& source)
    : document_(std::make_shared<YamlDocument>(
          YamlDocument{source, {}, Reporter()})) {
  document_->root = ParseOne(source, document_->reporter);
}

std::optional<YamlMap> YamlFile::Root(std::string_view what) const {
  if (!document_->reporter.diagnostics().empty()) return std::nullopt;
  const YamlValue root(
      document_, std::make_shared<const YamlNode>(YamlNode{document_->root}));
  return root.Map(what);
}

const std::vector<Diagnostic>& YamlFile::diagnostics() const {
  return document_->reporter.diagnostics();
}

}  // namespace plsc
