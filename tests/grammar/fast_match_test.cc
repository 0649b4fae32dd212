#include "grammar/fast_match.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "grammar/actions.h"
#include "grammar/header_actions.h"
#include "grammar/messages.h"
#include "grammar/recover.h"

namespace plsc::grammar {
namespace {

// Controls that differ in the scanners only.
template <typename Rule, template <typename> class Base>
struct Raising : Base<Rule> {
  template <typename Input>
  [[noreturn]] static void raise(const Input& in, Builder& b) {
    b.Fail(kError<Rule>, static_cast<std::uint32_t>(in.current() - b.base));
  }
};
template <typename Rule>
struct ByRules : Raising<Rule, tao::pegtl::normal> {};
template <typename Rule>
struct ByScanners : Raising<Rule, FastMatch> {};

template <template <typename...> class Control>
Builder Build(std::string_view text) {
  Builder b;
  b.file.text = text;
  b.base = text.data();
  tao::pegtl::memory_input<tao::pegtl::tracking_mode::lazy> in(
      text.data(), text.data() + text.size(), "");
  REQUIRE(tao::pegtl::parse<file, Action, Control>(in, b));
  return b;
}

std::ostream& operator<<(std::ostream& out, const Span& span) {
  return out << span.begin << '-' << span.end << ' ';
}
std::ostream& operator<<(std::ostream& out, const ast::Range& range) {
  return out << range.first << '+' << range.count << ' ';
}
std::ostream& operator<<(std::ostream& out, const ast::Value& value) {
  return out << value.span << static_cast<int>(value.kind) << value.is_integer
             << ' ' << value.number << ' ';
}

void DumpPools(const ast::File& file, std::ostream& out) {
  for (const ast::Symbol& s : file.symbols)
    out << s.span << s.name << s.arguments << s.has_parens << '\n';
  for (const ast::Value& value : file.arguments) out << value << '\n';
  for (const ast::Term& t : file.terms)
    out << t.span << static_cast<int>(t.connective) << t.state
        << t.comparison_span << static_cast<int>(t.comparison) << t.value
        << '\n';
  for (const ast::Declaration& d : file.declarations)
    out << d.span << d.name << d.is_replaceable << d.parameters << '\n';
  for (const ast::Parameter& p : file.parameters)
    out << p.name << p.is_integer << p.bounds.low << p.bounds.high << '\n';
  for (const ast::Entry& e : file.entries)
    out << e.span << e.state << e.value << '\n';
  for (const Span name : file.names) out << name;
  for (const Span comment : file.comments) out << comment;
}

// Everything that parsing made of a text.
std::string Dump(const Builder& b) {
  const ast::File& file = b.file;
  std::ostringstream out;
  out.precision(17);
  out << file.version << file.version_number << file.is_incomplete << '\n';
  for (const ast::Item& item : file.items)
    out << static_cast<int>(item.kind) << ' ' << item.span << item.keyword
        << item.index << '\n';
  for (const ast::Rule& r : file.rules)
    out << r.head << r.clause << r.terms << r.open << r.close << r.symbols
        << '\n';
  for (const ast::Naming& naming : file.genotypes) out << naming.name;
  for (const ast::Naming& naming : file.axioms) out << naming.name;
  for (const ast::Setting& setting : file.settings) out << setting.value;
  for (const ast::Let& let : file.lets) out << let.name << let.value;
  for (const ast::Sense& s : file.senses)
    out << s.name << s.bounds.low << s.bounds.high << s.values << '\n';
  for (const ast::Environment& e : file.environments)
    out << e.name << e.open << e.close << e.entries << '\n';
  DumpPools(file, out);
  for (const Diagnostic& d : b.reporter.diagnostics())
    out << '\n' << d.span << NumberOf(d.code) << d.message << d.label << d.help;
  return out.str();
}

bool IsSame(const std::string& text) {
  return Dump(Build<ByRules>(text)) == Dump(Build<ByScanners>(text));
}

std::vector<std::string> Programs() {
  std::vector<std::string> programs;
  const auto folder = std::filesystem::path(PLSC_SOURCE_DIR) / "tests/programs";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    programs.push_back(text.str());
  }
  return programs;
}

TEST_CASE("Scanners find the plain tokens whole", "[fast_match]") {
  struct Row {
    const char* text;
    int gap, identifier, number;  // bytes; -1 where the rule has to look
  };
  const std::vector<Row> rows = {
      {"", 0, -1, -1},     {" \t\r\n x", 5, -1, -1},   {"  # c", -1, -1, -1},
      {"#", -1, -1, -1},   {"move_ref_I(", 0, 10, -1}, {"_9-", 0, 2, -1},
      {"9x", 0, -1, -1},   {"\xC3\xA9", 0, -1, -1},    {"-", 0, -1, -1},
      {"-12)", 0, -1, 3},  {"0.5e-3,", 0, -1, 6},      {"1E+2", 0, -1, 4},
      {"1.", 0, -1, -1},   {"1..2", 0, -1, -1},        {"1.5.2", 0, -1, -1},
      {"1.5_", 0, -1, -1}, {"1e", 0, -1, -1},          {"1e+", 0, -1, -1},
      {".5", 0, -1, -1},   {"-x", 0, -1, -1}};
  for (const Row& row : rows) {
    CAPTURE(row.text);
    const std::string_view text = row.text;
    const char* const begin = text.data();
    const char* const end = begin + text.size();
    const auto bytes = [&](const char* to) {
      return to == nullptr ? -1 : static_cast<int>(to - begin);
    };
    CHECK(bytes(ScanGap(begin, end)) == row.gap);
    CHECK(bytes(ScanIdentifier(begin, end)) == row.identifier);
    CHECK(bytes(ScanNumber(begin, end)) == row.number);
  }
}

TEST_CASE("The same tree with and without scanners", "[fast_match]") {
  const std::vector<std::string> programs = Programs();
  REQUIRE(programs.size() >= 120);
  for (const std::string& program : programs) {
    CAPTURE(program);
    CHECK(IsSame(program));
    CHECK(IsSame(program.substr(0, program.size() / 2)));
  }
}

TEST_CASE("The same tree of a text with any byte changed", "[fast_match]") {
  const std::string program =
      "plsc 1 sense t: real in -40..60 alphabet m { replaceable X(a: int); }\n"
      "let w = 0.5e1 # c\nrule A1 -> if t >= -2.5 or hot = True then {\n"
      "  A1(1, -0.25, w)\n}\nenvironment e { t = 1e3 }\n";
  REQUIRE(IsSame(program));
  for (std::size_t i = 0; i < program.size(); ++i)
    for (const char c : std::string(" \n#.-+eEx_09,(){}=<\xC3") + '\0') {
      std::string changed = program;
      changed[i] = c;
      CAPTURE(i, c);
      REQUIRE(IsSame(changed));
    }
}

}  // namespace
}  // namespace plsc::grammar
