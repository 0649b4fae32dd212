// What a file expects of itself, compared in the order in which it is written,
// so that the first difference can point at its symbol or module. A body is a
// tree whose faces may be written in any order; both trees are put into one
// order of faces and compared as walks. Where two walks part first, the deeper
// of the two modules, or the one on the earlier face, is the one that the other
// does not have.

#include "runtime/advice/expectations.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "compiler/print.h"
#include "runtime/develop/derive.h"
#include "runtime/develop/develop.h"
#include "runtime/develop/part_names.h"

namespace plsc {

namespace {

// Symbols of a developed string that a note shows: some lines' worth.
constexpr std::size_t kExcerptSymbols = 60;

// Slots in the order of Face.
constexpr std::array<Slot, kFaces> kSlotOf = {Slot::kBack, Slot::kFront,
                                              Slot::kLeft, Slot::kRight};

SymbolId SymbolOf(ModuleType type) {
  switch (type) {
    case ModuleType::kCore:
      return plasticoding::kC;
    case ModuleType::kBrick:
      return plasticoding::kB;
    case ModuleType::kVerticalJoint:
      return plasticoding::kA1;
    case ModuleType::kHorizontalJoint:
      return plasticoding::kA2;
    case ModuleType::kTouchSensor:
      break;
  }
  return plasticoding::kT;
}

void AppendModule(const Body& body, int index, ExpectedModule place,
                  std::vector<ExpectedModule>* modules) {
  const Module& module = body.modules[static_cast<std::size_t>(index)];
  place.symbol = SymbolOf(module.type);
  modules->push_back(place);
  for (int f = 0; f < kFaces; ++f) {
    const int child = module.child(kSlotOf[static_cast<std::size_t>(f)]);
    if (child == kNoModule) continue;
    AppendModule(body, child, {{}, place.depth + 1, static_cast<Face>(f)},
                 modules);
  }
}

// An expected module and where it was written.
struct WrittenModule {
  ExpectedModule module;
  Span span;
};

// The expected modules in the order of AsExpected, whatever the order in which
// the faces were written.
void AppendSorted(const std::vector<WrittenModule>& written, std::size_t at,
                  std::vector<WrittenModule>* sorted) {
  sorted->push_back(written[at]);
  const int depth = written[at].module.depth;
  for (int f = 0; f < kFaces; ++f)
    for (std::size_t i = at + 1;
         i < written.size() && written[i].module.depth > depth; ++i)
      if (written[i].module.depth == depth + 1 &&
          written[i].module.face == static_cast<Face>(f))
        AppendSorted(written, i, sorted);
}

class InlineTestRun {
 public:
  InlineTestRun(const MappedProgram& mapped, std::size_t index)
      : test_(mapped.program.tests[index]),
        spans_(mapped.map.tests[index]),
        genotype_(mapped.program.genotype) {
    if (test_.after) genotype_.development.iterations = *test_.after;
  }

  std::optional<Diagnostic> Run() {
    const ActiveRules active = Regulate(genotype_, test_.environment);
    const auto string = Derive(genotype_, active);
    if (!string)
      return Fail(spans_.name, Code::kTooLongString)
          .WithLabel(
              fmt::format("development would produce more than {} symbols",
                          kMaxStringLength));
    if (test_.body.empty()) return CompareString(*string);
    return CompareBody(Develop(genotype_, *string).body);
  }

 private:
  Diagnostic Fail(Span where, Code code = Code::kFailedTest) const {
    return {code, where,
            fmt::format("test '{}' fails{}{}", test_.name,
                        test_.place.empty() ? "" : " in ", test_.place)};
  }

  bool IsExpected(const ExpectedSymbol& expected,
                  const Occurrence& found) const {
    if (!expected.has_arguments) return expected.symbol.id == found.symbol;
    return expected.symbol == SymbolAt(genotype_, found);
  }

  std::optional<Diagnostic> CompareString(const SymbolString& found) const {
    const std::vector<ExpectedSymbol>& expected = test_.string;
    const std::size_t common = std::min(expected.size(), found.size());
    std::size_t at = 0;
    while (at < common && IsExpected(expected[at], found[at])) ++at;
    if (at == expected.size() && at == found.size()) return std::nullopt;
    Diagnostic diagnostic =
        Fail(at < expected.size() ? spans_.symbols[at] : spans_.close);
    if (at == expected.size())
      diagnostic.label = fmt::format("the string goes on with {}",
                                     SymbolText(genotype_, found[at]));
    else if (at == found.size())
      diagnostic.label = fmt::format("the string ends before this, after {}",
                                     Count(found.size(), "symbol"));
    else
      diagnostic.label = fmt::format("symbol {} of the string is {}", at + 1,
                                     SymbolText(genotype_, found[at]));
    diagnostic.notes.push_back("developed: " + Excerpt(found));
    return diagnostic;
  }

  static std::string Count(std::size_t number, const char* what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
  }

  std::string Excerpt(const SymbolString& string) const {
    std::string text;
    for (std::size_t i = 0; i < string.size() && i < kExcerptSymbols; ++i)
      text += (i > 0 ? " " : "") + SymbolText(genotype_, string[i]);
    if (string.size() > kExcerptSymbols)
      text += fmt::format(" ... ({} symbols)", string.size());
    return text;
  }

  std::vector<WrittenModule> SortedBody() const {
    std::vector<WrittenModule> written;
    for (std::size_t i = 0; i < test_.body.size(); ++i)
      written.push_back({test_.body[i], spans_.modules[i]});
    std::vector<WrittenModule> sorted;
    AppendSorted(written, 0, &sorted);
    return sorted;
  }

  // Both lists are in the order of a walk through the tree, so where they
  // part first, one has a module that the other does not have there.
  std::optional<Diagnostic> CompareBody(const Body& body) const {
    const std::vector<WrittenModule> expected = SortedBody();
    const std::vector<ExpectedModule> found = AsExpected(body);
    std::size_t at = 0;
    while (at < expected.size() && at < found.size() &&
           expected[at].module == found[at])
      ++at;
    if (at == expected.size() && at == found.size()) return std::nullopt;
    Diagnostic diagnostic = Difference(expected, found, at);
    diagnostic.notes.push_back("developed: body " +
                               PrintBody(found, *genotype_.alphabet));
    return diagnostic;
  }

  Diagnostic Difference(const std::vector<WrittenModule>& expected,
                        const std::vector<ExpectedModule>& found,
                        std::size_t at) const {
    const auto name = [&](const ExpectedModule& module) {
      return genotype_.SymbolOf(module.symbol).name;
    };
    const bool is_same_place = at < expected.size() && at < found.size() &&
                               expected[at].module.depth == found[at].depth &&
                               expected[at].module.face == found[at].face;
    if (is_same_place)
      return Fail(expected[at].span)
          .WithLabel(fmt::format("this module is {}", name(found[at])));
    if (at < found.size() && IsExtra(expected, found, at)) {
      // The parent has been expected: it stands before.
      std::size_t parent = at - 1;
      while (expected[parent].module.depth >= found[at].depth) --parent;
      return Fail(expected[parent].span)
          .WithLabel(fmt::format("has {} at its {}, which is not expected",
                                 name(found[at]),
                                 NameIn(kFaceNames, found[at].face)));
    }
    return Fail(expected[at].span).WithLabel("there is no such module");
  }

  // Whether the walk of what was found meets a module first there.
  static bool IsExtra(const std::vector<WrittenModule>& expected,
                      const std::vector<ExpectedModule>& found,
                      std::size_t at) {
    if (at == expected.size()) return true;
    const ExpectedModule& wanted = expected[at].module;
    return found[at].depth > wanted.depth ||
           (found[at].depth == wanted.depth && found[at].face < wanted.face);
  }

  const InlineTest& test_;
  const TestSpans& spans_;
  Genotype genotype_;
};

}  // namespace

std::optional<Diagnostic> RunInlineTest(const MappedProgram& mapped,
                                        std::size_t index) {
  return InlineTestRun(mapped, index).Run();
}

std::vector<ExpectedModule> AsExpected(const Body& body) {
  std::vector<ExpectedModule> modules;
  AppendModule(body, 0, {}, &modules);
  return modules;
}

}  // namespace plsc
