// What must hold of the history of any robot, over the authors' cases.

#include <catch2/catch.hpp>
#include <cstring>

#include "compiler/compile.h"
#include "compiler/environment_text.h"
#include "runtime/develop/develop.h"
#include "runtime/develop/phenotype_json.h"
#include "runtime/develop/provenance.h"
#include "tests/runtime/develop/compile_text.h"
#include "tests/runtime/develop/reference_cases.h"
#include "tests/sanitizer.h"

namespace plsc {
namespace {

// Exactly the created parts are credited: a mounted symbol with its module,
// its node and its edges, add_edge and loop with their edge.
void CheckCredits(const Trace& trace) {
  std::vector<int> modules(trace.phenotype.body.modules.size());
  std::vector<int> nodes(trace.phenotype.brain.nodes.size());
  std::vector<int> edges(trace.phenotype.brain.connections.size());
  for (std::size_t i = 0; i < trace.events.size(); ++i) {
    const Event& event = trace.events[i];
    const bool mounts =
        event.effect == Effect::kMounted || event.effect == Effect::kStarted;
    if (mounts) {
      ++modules.at(static_cast<std::size_t>(event.module));
      CHECK(trace.module_origins.at(static_cast<std::size_t>(event.module)) ==
            i);
    }
    if (mounts && event.node != kNoNode) {
      const auto node = static_cast<std::size_t>(event.node);
      ++nodes.at(node);
      CHECK(trace.node_origins.at(node) == i);
      CHECK(trace.phenotype.brain.nodes[node].module == event.module);
    }
    for (int k = 0; k < event.edge_count; ++k) {
      const auto edge = static_cast<std::size_t>(event.edge + k);
      ++edges.at(edge);
      CHECK(trace.edge_origins.at(edge) == i);
    }
  }
  CHECK(modules == std::vector<int>(modules.size(), 1));
  CHECK(nodes == std::vector<int>(nodes.size(), 1));
  CHECK(edges == std::vector<int>(edges.size(), 1));
}

// A command and the module that used it, or the command that overwrote it,
// name each other or come in order.
void CheckPartners(const Trace& trace) {
  for (std::size_t i = 0; i < trace.events.size(); ++i) {
    const Event& event = trace.events[i];
    if (event.effect == Effect::kMounted) {
      const Event& command = trace.events.at(event.partner);
      CHECK(command.effect == Effect::kSlotUsed);
      CHECK(command.partner == i);
    }
    if (event.effect == Effect::kSlotUsed)
      CHECK(trace.events.at(event.partner).effect == Effect::kMounted);
    if (event.effect == Effect::kSlotOverwritten) CHECK(event.partner > i);
  }
}

void CheckSet(const std::string& set) {
  const auto cases = test::ReadReferenceCases(set);
  for (std::size_t i = 0; i < cases.size(); i += test::kSparser) {
    const test::Json& one = cases[i];
    INFO(one["id"]);
    const Genotype genotype =
        test::CompileText(test::GenotypeText(one)).genotype;
    const Source senses("--env", test::EnvironmentText(one));
    const auto environment = ParseEnvironment(senses, genotype.states);
    REQUIRE(environment);
    const auto history = DevelopWithHistory(genotype, *environment);
    REQUIRE(history);
    const SymbolString string = FinalString(history->derivation);
    CHECK(string == Derive(genotype, history->active));
    const Trace& trace = *history->trace;
    REQUIRE(trace.events.size() == string.size());
    const auto plain = Develop(genotype, *environment);
    CHECK(DevelopmentJson(genotype, *environment, string, &*plain) ==
          DevelopmentJson(genotype, *environment, string, &trace.phenotype));
    CheckCredits(trace);
    CheckPartners(trace);
    for (const InsertionId id : history->derivation.string())
      CHECK(Ancestry(history->derivation, id).back() == 0);
  }
}

TEST_CASE(
    "every part of the authors' robots has exactly one symbol that made "
    "it",
    "[trace]") {
  for (const std::string& set : test::ReferenceSets()) CheckSet(set);
}

}  // namespace
}  // namespace plsc
