// Explanations of the codes P51: scenarios and experiments, which are YAML.

#include "runtime/cli/explanations/explanations.h"

namespace plsc::cli {

namespace {

constexpr Explanation kYamlRows[] = {
    {Code::kNotYamlOrJson, ExampleKind::kExperiment,
     R"(The file does not follow the syntax of YAML (a scenario, an experiment)
or of JSON (a golden file, a recording); the message is that of the
reader. Often a bracket or quote is not closed, or an indentation is wrong.
)",
     R"(plsc_experiment: 1
states: [inclined, hot
)",
     R"(plsc_experiment: 1
states: [inclined]
)"},
    {Code::kUnknownKey, ExampleKind::kExperiment,
     R"(No such key is known here. Unknown keys are errors, for a misspelt one
would otherwise silently leave its default. docs/experiments.md lists
all keys.
)",
     R"(plsc_experiment: 1
populaton: 50
)",
     R"(plsc_experiment: 1
population: 50
)"},
    {Code::kRepeatedKey, ExampleKind::kExperiment,
     R"(A key stands twice in one map, and only one of the values could count.
)",
     R"(plsc_experiment: 1
seed: 1
seed: 2
)",
     R"(plsc_experiment: 1
seed: 2
)"},
    {Code::kWrongKind, ExampleKind::kExperiment,
     R"(The value has another kind than the key needs: a text where a number is
expected, a list where a name is, and so on. A text in quotes is never a
number.
)",
     R"(plsc_experiment: 1
population: many
)",
     R"(plsc_experiment: 1
population: 50
)"},
    {Code::kOutOfRange, ExampleKind::kExperiment,
     R"(A number lies outside the range of its key; the message says which it
is.
)",
     R"(plsc_experiment: 1
mutation: 1.5
)",
     R"(plsc_experiment: 1
mutation: 0.5
)"},
    {Code::kWrongUnit, ExampleKind::kExperiment,
     R"(A quantity has a unit that does not measure it, or none where one must
be: angles say deg or rad. Without a unit other quantities are in SI.
)",
     R"(plsc_experiment: 1
scenario:
  sample_interval: 200 kg
  seasons:
    - {name: flat, terrain: flat, senses: {inclined: False}}
)",
     R"(plsc_experiment: 1
scenario:
  sample_interval: 200 ms
  seasons:
    - {name: flat, terrain: flat, senses: {inclined: False}}
)"},
    {Code::kMissingKey, ExampleKind::kExperiment,
     R"(A key without a default is missing. An experiment that has a scenario
says its seasons.
)",
     R"(plsc_experiment: 1
scenario: {name: summer}
)",
     R"(plsc_experiment: 1
scenario:
  name: summer
  seasons:
    - {name: flat, terrain: flat, senses: {inclined: False}}
)"},
    {Code::kUnknownWord, ExampleKind::kExperiment,
     R"(The value is a word, but none of those that the key knows, or a name
that is not written as names are.
)",
     R"(plsc_experiment: 1
encoding: lsystem
)",
     R"(plsc_experiment: 1
encoding: baseline
)"},
    {Code::kMisfit, ExampleKind::kExperiment,
     R"(Each value is right, but they do not fit together: two seasons of one
name, a season that does not answer a state that clauses ask about,
samples closer than the steps of the physics.
)",
     R"(plsc_experiment: 1
states: [hot]
scenario:
  seasons:
    - {name: flat, terrain: flat, senses: {inclined: False}}
)",
     R"(plsc_experiment: 1
states: [inclined]
scenario:
  seasons:
    - {name: flat, terrain: flat, senses: {inclined: False}}
)"},
    {Code::kFormulaSyntax, ExampleKind::kExperiment,
     R"(A formula has numbers, quantities and functions, between them + - * /,
comparisons (== != < <= > >=), 'and', 'or', 'not', and 'condition ? one :
other'; parentheses group. A choice has ': ' in it, which YAML takes for a
key: such a formula stands in quotes.
)",
     R"(plsc_experiment: 1
fitness: speed ^ 2
)",
     R"(plsc_experiment: 1
fitness: speed * speed
)"},
    {Code::kUnknownQuantity, ExampleKind::kExperiment,
     R"(No quantity and no function of a formula is called so.
docs/experiments.md lists all, with their units.
)",
     R"(plsc_experiment: 1
fitness: sped - 0.01 * energy
)",
     R"(plsc_experiment: 1
fitness: speed - 0.01 * energy
)"},
    {Code::kFormulaType, ExampleKind::kExperiment,
     R"(Numbers are added and compared, and comparisons are True or False: only
these can be joined by 'and' and 'or', or decide a choice. Each function
takes its own number of arguments.
)",
     R"(plsc_experiment: 1
fitness: speed > 0
)",
     R"(plsc_experiment: 1
fitness: "speed > 0 ? speed : 0"
)"},
    {Code::kNoNumber, ExampleKind::kExperiment,
     R"(This part of the formula would be no finite number in any life: a division
by 0, the root of a negative number, a logarithm of 0. Where that depends on
the life, its outcome is 'undefined_fitness'.
)",
     R"(plsc_experiment: 1
fitness: speed / (1 - 1)
)",
     R"(plsc_experiment: 1
fitness: speed / 2
)"},
};

}  // namespace

std::span<const Explanation> YamlExplanations() {
  return kYamlRows;
}

}  // namespace plsc::cli
