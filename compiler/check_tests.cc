#include "compiler/check_tests.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "compiler/limits.h"
#include "grammar/reporter.h"
#include "grammar/suggest.h"

namespace plsc {

namespace {

class TestChecker {
 public:
  TestChecker(const ast::File& file, const Scope& scope,
              const Resolution& resolution)
      : file_(file), scope_(scope), resolution_(resolution) {
    for (const ast::Environment& environment : file.environments) {
      const std::string_view name = file.Text(environment.name);
      if (known_.insert(name).second) environments_.push_back(name);
    }
  }

  std::vector<Diagnostic> Check() {
    std::unordered_map<std::string_view, Span> names;
    for (const ast::Test& test : file_.tests) {
      if (reporter_.is_full()) break;
      const auto [first, is_new] =
          names.emplace(file_.Text(test.name), test.name);
      if (!is_new)
        reporter_
            .Report(Code::kRepeatedName, test.name,
                    fmt::format("test '{}' is declared twice",
                                file_.Text(test.name)))
            .WithOther(first->second, "first declared here");
      CheckPlace(test);
      if (test.has_after) CheckAfter(test.after);
      if (test.nodes.count > 0) CheckBody(test);
    }
    return reporter_.Take();
  }

 private:
  void CheckPlace(const ast::Test& test) {
    // The environment that is meant may be the one that did not parse.
    if (file_.is_incomplete) return;
    if (test.environment.end == 0) {
      if (scope_.header.states.empty()) return;
      Diagnostic& diagnostic =
          reporter_.Report(Code::kWrongTest, test.name,
                           fmt::format("test '{}' does not say its environment",
                                       file_.Text(test.name)));
      if (environments_.empty())
        diagnostic.help =
            "declare one, as in 'environment flat { inclined = False }', and "
            "write 'in flat' behind the name";
      else
        diagnostic.help =
            fmt::format("write 'in {}' behind the name", environments_[0]);
      return;
    }
    const std::string_view place = file_.Text(test.environment);
    if (known_.contains(place)) return;
    Diagnostic& diagnostic = reporter_.Report(
        Code::kWrongTest, test.environment,
        fmt::format("environment '{}' is not declared", place));
    if (!AddSuggestion(place, environments_, &diagnostic))
      diagnostic.help =
          fmt::format("declare it, as in 'environment {} {{ ... }}'", place);
  }

  void CheckAfter(const ast::Value& after) {
    const int most = scope_.header.development.iterations;
    if (after.is_integer && after.number >= 0 && after.number <= most) return;
    reporter_
        .Report(Code::kWrongTest, after.span,
                fmt::format("there is no string after {} rewritings",
                            file_.Text(after.span)))
        .WithLabel(fmt::format("this genotype has 0 to {}", most));
  }

  void CheckBody(const ast::Test& test) {
    if (scope_.header.alphabet == nullptr) return;
    if (!scope_.header.alphabet->is_built_in()) {
      reporter_
          .Report(Code::kImpossibleBody, test.name,
                  fmt::format("alphabet '{}' has no bodies",
                              scope_.header.alphabet->name()))
          .WithHelp("expect a string: '-> { ... }'");
      return;
    }
    path_.clear();
    for (std::uint32_t k = 0; k < test.nodes.count; ++k) {
      if (reporter_.is_full()) return;
      CheckModule(test.nodes.first + k);
    }
  }

  void CheckModule(std::uint32_t at) {
    const ast::BodyNode& node = file_.nodes[at];
    const ResolvedNode& resolved = resolution_.nodes[at];
    path_.resize(node.depth);
    if (resolved.symbol) CheckKind(node, *resolved.symbol);
    if (node.depth > 0 && resolved.face) CheckFace(node, *resolved.face);
    path_.push_back({resolved.symbol, {}});
  }

  void CheckKind(const ast::BodyNode& node, SymbolId id) {
    const bool is_module =
        scope_.header.SymbolOf(id).category == Category::kModule;
    const std::string_view name = file_.Text(node.name);
    if (!is_module)
      reporter_
          .Report(Code::kImpossibleBody, node.name,
                  fmt::format("'{}' is no module", name))
          .WithLabel("modules are C, B, A1, A2 and T");
    else if (node.depth == 0 && id != plasticoding::kC)
      reporter_.Report(
          Code::kImpossibleBody, node.name,
          fmt::format("a body starts with the core C, not with '{}'", name));
    else if (node.depth > 0 && id == plasticoding::kC)
      reporter_.Report(Code::kImpossibleBody, node.name,
                       "a robot has exactly one core");
  }

  // Joints carry modules at the front only, sensors none (paper, Fig. 2). What
  // is mounted on the core when its other faces are taken comes to its back
  // (docs/development.md).
  void CheckFace(const ast::BodyNode& node, Face face) {
    Open& parent = path_.back();
    Span& taken = parent.faces[static_cast<std::size_t>(face)];
    if (taken.end > 0)
      reporter_
          .Report(Code::kImpossibleBody, node.face,
                  fmt::format("the {} of this module is given twice",
                              NameIn(kFaceNames, face)))
          .WithOther(taken, "first given here");
    taken = node.face;
    if (parent.symbol == plasticoding::kT)
      reporter_.Report(Code::kImpossibleBody, node.face,
                       "nothing can be mounted on a sensor");
    const bool is_joint = parent.symbol == plasticoding::kA1 ||
                          parent.symbol == plasticoding::kA2;
    if (is_joint && face != Face::kFront)
      reporter_
          .Report(
              Code::kImpossibleBody, node.face,
              fmt::format("a joint has no {} face", NameIn(kFaceNames, face)))
          .WithLabel("modules are mounted at its front");
    if (face == Face::kBack && !is_joint && parent.symbol &&
        parent.symbol != plasticoding::kC && parent.symbol != plasticoding::kT)
      reporter_
          .Report(Code::kImpossibleBody, node.face, "only the core has a back")
          .WithLabel("a module's back is where it is mounted itself");
  }

  // A module whose children are being read.
  struct Open {
    std::optional<SymbolId> symbol;
    std::array<Span, kFaces> faces;
  };

  const ast::File& file_;
  const Scope& scope_;
  const Resolution& resolution_;
  std::vector<std::string_view> environments_;  // in file order
  std::unordered_set<std::string_view> known_;
  std::vector<Open> path_;
  Reporter reporter_;
};

}  // namespace

std::vector<Diagnostic> CheckTests(const ast::File& file, const Scope& scope,
                                   const Resolution& resolution) {
  return TestChecker(file, scope, resolution).Check();
}

}  // namespace plsc
