// Keys are read one by one and then held to each other (CheckTogether), but
// only if each was right by itself: a range that depends on a wrong number
// would be a second error about the first. Limits are about memory and time and
// say so. Printing writes every key, in the order of reading, and reads back to
// an equal experiment, by which runs are known again.

#include "runtime/evolve/experiment.h"
#include "grammar/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>

#include "compiler/limits.h"
#include "grammar/enum_names.h"
#include "grammar/keywords.h"
#include "runtime/evolve/trials_yaml.h"
#include "runtime/scenario/scenario_fitness.h"
#include "runtime/scenario/scenario_yaml.h"
#include "runtime/text/yaml_reader.h"
#include "runtime/text/yaml_text.h"

namespace plsc {

namespace {

constexpr int kFormat = 1;  // of experiment files, value of plsc_experiment
// Robots that are held in memory, 10 KB each, and compared each with each when
// they are selected, minutes for so many.
constexpr int kMaxPopulation = 100'000;
// Symbols of all genotypes, 40 bytes each: 2 GB. Random genotypes have somewhat
// less than the most that their options allow, evolved ones somewhat more.
constexpr double kMaxGenotypes = 50e6;
// Sizes beyond which a number is a slip of the pen.
constexpr int kMaxGenerations = 1'000'000;
constexpr int kMaxTournament = 1000;
constexpr int kMaxGroups = 1000;

constexpr Quantity kProbability = {Dimension::kNumber, 0, 1};

constexpr EnumNames<Encoding, 2> kEncodingNames{
    {{Encoding::kPlasticoding, "plasticoding"},
     {Encoding::kBaseline, "baseline"}}};

constexpr EnumNames<Inheritance, 3> kInheritanceNames{
    {{Inheritance::kGenotype, "genotype"},
     {Inheritance::kJoined, "joined"},
     {Inheritance::kSenses, "senses"}}};

constexpr EnumNames<InsertionPoint, 2> kInsertionNames{
    {{InsertionPoint::kAnywhere, "anywhere"},
     {InsertionPoint::kBeforeEnd, "before_end"}}};

constexpr EnumNames<Removal, 2> kRemovalNames{
    {{Removal::kByPosition, "by_position"}, {Removal::kByValue, "by_value"}}};

/// The limit that max_initial_terms has where it says no number.
constexpr std::string_view kAsMaxTerms = "max_terms";

/// A word that can stand in a genotype file.
std::optional<std::string> ReadName(const YamlValue& value,
                                    std::string_view what) {
  std::optional<std::string> name = value.Text(what);
  if (!name || IsName(*name)) return name;
  value.Report(Code::kUnknownWord,
               fmt::format("expected {}, found '{}'", what, *name),
               "a name is made of letters, digits and '_', begins with no "
               "digit, and is no word of the language");
  return std::nullopt;
}

std::optional<State> ReadRealState(State state, const YamlValue& value) {
  const std::string text = value.text();
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) {
    value.Report(Code::kWrongKind,
                 fmt::format("expected a range or a list of values, found "
                             "'{}'",
                             text),
                 "write '-40..60' or '[dry, wet]'");
    return std::nullopt;
  }
  const ParsedQuantity low =
      ParseQuantity(std::string_view(text).substr(0, dots), {});
  const ParsedQuantity high =
      ParseQuantity(std::string_view(text).substr(dots + 2), {});
  if (low.error || high.error || low.value >= high.value) {
    value.Report(
        Code::kWrongKind,
        fmt::format("expected a range from less to more, found '{}'", text),
        "write it as in '-40..60'");
    return std::nullopt;
  }
  state.type = StateType::kReal;
  state.low = low.value;
  state.high = high.value;
  return state;
}

std::optional<State> ReadEnumState(State state, const YamlValue& value) {
  const auto items = value.List("values");
  if (!items) return std::nullopt;
  state.type = StateType::kEnum;
  if (items->size() > kMaxSymbols) {
    value.Report(Code::kLimit,
                 fmt::format("a state has at most {} values, found {}",
                             kMaxSymbols, items->size()));
    return std::nullopt;
  }
  for (const YamlValue& item : *items)
    if (auto name = ReadName(item, "a value")) {
      const auto& known = state.values;
      if (std::find(known.begin(), known.end(), *name) != known.end())
        item.Report(Code::kMisfit,
                    fmt::format("value '{}' is given twice", *name));
      state.values.push_back(std::move(*name));
    }
  if (items->size() < 2)
    value.Report(Code::kMisfit, "expected at least two values");
  return state;
}

/// `inclined`, `{temperature: -40..60}` or `{ground: [dry, wet]}`.
std::optional<State> ReadState(const YamlValue& value) {
  State state;
  if (!value.is_map()) {
    auto name = ReadName(value, "a state");
    if (!name) return std::nullopt;
    state.name = std::move(*name);
    return state;
  }
  YamlMap map = *value.Map("a state");
  const std::vector<YamlMap::Entry>& entries = map.TakeAll();
  if (entries.size() != 1) {
    value.Report(Code::kWrongKind, "expected one state here",
                 "write each state as its own item of the list");
    return std::nullopt;
  }
  const YamlMap::Entry& entry = entries.front();
  auto name = ReadName(entry.at, "a state");
  if (!name) return std::nullopt;
  state.name = std::move(*name);
  return entry.value.is_scalar() ? ReadRealState(state, entry.value)
                                 : ReadEnumState(state, entry.value);
}

std::optional<std::vector<State>> ReadStates(const YamlValue& value) {
  std::vector<State> states;
  const auto items = value.List("states");
  if (!items) return std::nullopt;
  if (items->size() > kMaxStates) {
    value.Report(Code::kLimit,
                 fmt::format("a genotype has at most {} states, found {}",
                             kMaxStates, items->size()));
    return std::nullopt;
  }
  for (const YamlValue& item : *items) {
    std::optional<State> state = ReadState(item);
    if (!state) continue;
    const bool is_known = std::any_of(
        states.begin(), states.end(),
        [&](const State& other) { return other.name == state->name; });
    if (is_known)
      item.Report(Code::kMisfit,
                  fmt::format("state '{}' is given twice", state->name));
    else
      states.push_back(std::move(*state));
  }
  return states;
}

/// A number, or the word max_terms. `most_terms`: that it may be, what
/// max_terms is if that is right.
void ReadInitialTerms(YamlMap& map, int most_terms, GenotypeOptions& options) {
  const std::size_t errors = map.place().error_count();
  const auto most = map.Find("max_initial_terms");
  const bool is_word = most && most->is_scalar() && !most->text().empty() &&
                       std::isalpha(most->text()[0]) != 0;
  if (is_word && most->text() != kAsMaxTerms)
    most->Report(Code::kUnknownWord,
                 fmt::format("expected a whole number or {}, found '{}'",
                             kAsMaxTerms, most->text()),
                 fmt::format("write '{}'", kAsMaxTerms),
                 std::string(kAsMaxTerms));
  else if (most && !is_word)
    if (const auto number = most->Integer(0, most_terms, most_terms))
      options.max_initial_terms = static_cast<int>(*number);
  const bool is_most_right = map.place().error_count() == errors;
  options.min_initial_terms =
      map.Int("min_initial_terms", options.min_initial_terms, 0,
              is_most_right ? options.max_initial_terms.value_or(most_terms)
                            : most_terms);
}

void ReadVariation(YamlMap& map, Experiment& experiment) {
  MutationOptions& options = experiment.variation;
  options.clause_share =
      map.Number("clause_mutation", options.clause_share, kProbability);
  options.insertion =
      map.Choice("insertion", options.insertion, kInsertionNames);
  options.removal = map.Choice("removal", options.removal, kRemovalNames);
  experiment.inheritance =
      map.Choice("inheritance", experiment.inheritance, kInheritanceNames);
}

GenotypeOptions ReadGenotype(YamlMap& map) {
  GenotypeOptions options;
  const std::size_t errors = map.place().error_count();
  options.encoding = map.Choice("encoding", options.encoding, kEncodingNames);
  DevelopmentSettings& development = options.development;
  development.iterations = map.Int("iterations", development.iterations,
                                   kMinIterations, kMaxIterations);
  development.max_modules =
      map.Int("max_modules", development.max_modules, kMinModules, kMaxModules);
  development.move_to_new = map.Bool("move_to_new", development.move_to_new);
  const std::size_t before_groups = map.place().error_count();
  options.max_groups = map.Int("max_groups", options.max_groups, 1, kMaxGroups);
  const bool is_max_right = map.place().error_count() == before_groups;
  options.min_groups = map.Int("min_groups", options.min_groups, 1,
                               is_max_right ? options.max_groups : kMaxGroups);
  options.groups_per_rule =
      map.Bool("groups_per_rule", options.groups_per_rule);
  options.max_rules =
      map.Int("max_rules", options.max_rules, kMinLimit, kMaxLimit);
  const std::size_t before_terms = map.place().error_count();
  options.max_terms =
      map.Int("max_terms", options.max_terms, kMinLimit, kMaxLimit);
  ReadInitialTerms(
      map,
      map.place().error_count() == before_terms ? options.max_terms : kMaxLimit,
      options);
  if (const auto states = map.Find("states")) {
    if (auto read = ReadStates(*states)) options.states = *std::move(read);
    if (map.place().error_count() == errors && options.states.empty() &&
        options.encoding == Encoding::kPlasticoding)
      states->Report(Code::kMisfit,
                     "expected at least one state: clauses ask about them",
                     "write 'encoding: baseline' for rules without clauses");
  }
  return options;
}

/// What the authors' program did otherwise than the paper has it, unless a key
/// says so: for the same reason as the scenario's values (scenario_profile).
void TakeHabits(Profile profile, Experiment& experiment) {
  if (profile != Profile::kPublished) return;
  experiment.variation.insertion = InsertionPoint::kBeforeEnd;
  experiment.variation.removal = Removal::kByValue;
  experiment.inheritance = Inheritance::kJoined;
}

/// `profile`: of a scenario that names none. Where the scenario has a file of
/// its own it is read with the profile of the one that stands in for it.
void ReadScenarioOf(YamlMap& map, Profile profile, Experiment& experiment) {
  experiment.scenario = BothSeasons(profile);
  const auto value = map.Find("scenario");
  if (!value) return;
  if (value->is_map()) {
    YamlMap scenario = *value->Map("a scenario");
    experiment.scenario = ReadScenario(scenario, profile);
  } else if (auto file = value->Text("a scenario or the name of its file")) {
    experiment.scenario_file = std::move(*file);
  }
}

void ReadFitnessOf(YamlMap& map, Experiment& experiment) {
  const auto value = map.Find("fitness");
  if (!value) return;
  if (HasOwnFitness(experiment.scenario))
    value->Report(Code::kMisfit,
                  "fitness is given here and in the scenario, too",
                  "write it once");
  else if (!experiment.scenario_file.empty() && value->is_map())
    value->Report(Code::kMisfit,
                  "expected one formula for all seasons: they have a file of "
                  "their own",
                  "write 'fitness' by season in that file");
  else
    ReadFitness(*value, experiment.scenario);
}

int ReadPopulation(YamlMap& map, const char* key, int otherwise, int least) {
  const auto value = map.Find(key);
  if (!value) return otherwise;
  using Limits = std::numeric_limits<std::int64_t>;
  const auto number = value->Integer(Limits::min(), Limits::max(), otherwise);
  if (!number) return otherwise;
  if (*number >= least && *number <= kMaxPopulation)
    return static_cast<int>(*number);
  value->Report(Code::kOutOfRange,
                fmt::format("expected a whole number of {} to {}, found {}",
                            least, kMaxPopulation, *number),
                *number > kMaxPopulation
                    ? "all robots of a generation are held in memory, and "
                      "each is compared with each; more generations cost "
                      "neither"
                    : "");
  return otherwise;
}

/// The most that Initialise draws.
double LargestGenotype(const GenotypeOptions& options) {
  // Of each of the symbols that have rules, groups of five symbols a rule, and
  // one more where its head stands in front.
  const auto heads = PlasticodingAlphabet()->OfCategory(Category::kModule);
  const double rules =
      static_cast<double>(heads.size()) *
      (options.encoding == Encoding::kPlasticoding ? options.max_rules : 1);
  return rules * (5.0 * options.max_groups + 1);
}

void CheckSize(const YamlValue& place, const Experiment& experiment) {
  const double robots =
      static_cast<double>(experiment.population) + experiment.offspring;
  const double largest = LargestGenotype(experiment.genotype);
  if (robots * largest <= kMaxGenotypes) return;
  place.Report(
      Code::kMisfit,
      fmt::format(
          "{} robots of up to {:.0f} symbols each are more than the {:.0f} "
          "symbols that memory is meant for",
          robots, largest, kMaxGenotypes),
      "make 'population', 'offspring', 'max_rules' or 'max_groups' smaller");
}

void CheckTogether(YamlMap& map, const Experiment& experiment) {
  const auto place = [&](std::string_view key) {
    return map.Find(key).value_or(map.place());
  };
  if (Evaluations(experiment) > std::numeric_limits<int>::max())
    place("generations")
        .Report(Code::kMisfit,
                fmt::format("{} robots are more than can be numbered",
                            Evaluations(experiment)));
  CheckSize(place("population"), experiment);
  if (!experiment.scenario_file.empty()) return;
  const char* const about =
      CheckTargets(experiment.scenario) ? "fitness" : "scenario";
  for (const Diagnostic& error : CheckSenses(experiment))
    place(about).Report(error.code, error.message, error.help);
}

std::string PrintState(const State& state) {
  std::string name = PrintYamlText(state.name);
  switch (state.type) {
    case StateType::kBool:
      return name;
    case StateType::kReal:
      return fmt::format("{{{}: {}..{}}}", name, PrintPlainNumber(state.low),
                         PrintPlainNumber(state.high));
    case StateType::kEnum: {
      std::vector<std::string> values;
      for (const std::string& value : state.values)
        values.push_back(PrintYamlText(value));
      return fmt::format("{{{}: [{}]}}", name, fmt::join(values, ", "));
    }
  }
  return "";
}

std::string PrintVariation(const Experiment& experiment) {
  const MutationOptions& options = experiment.variation;
  std::string text;
  text += fmt::format("clause_mutation: {}\n",
                      PrintPlainNumber(options.clause_share));
  text += fmt::format("insertion: {}\n",
                      NameIn(kInsertionNames, options.insertion));
  text += fmt::format("removal: {}\n", NameIn(kRemovalNames, options.removal));
  text += fmt::format("inheritance: {}\n",
                      NameIn(kInheritanceNames, experiment.inheritance));
  return text;
}

std::string PrintGenotypeOptions(const GenotypeOptions& options) {
  std::vector<std::string> states;
  for (const State& state : options.states) states.push_back(PrintState(state));
  const auto word = [](bool value) { return value ? "True" : "False"; };
  const DevelopmentSettings& development = options.development;
  std::string text;
  text +=
      fmt::format("encoding: {}\n", NameIn(kEncodingNames, options.encoding));
  text += fmt::format("iterations: {}\n", development.iterations);
  text += fmt::format("max_modules: {}\n", development.max_modules);
  text += fmt::format("move_to_new: {}\n", word(development.move_to_new));
  text += fmt::format("min_groups: {}\n", options.min_groups);
  text += fmt::format("max_groups: {}\n", options.max_groups);
  text += fmt::format("groups_per_rule: {}\n", word(options.groups_per_rule));
  text += fmt::format("max_rules: {}\n", options.max_rules);
  text += fmt::format("max_terms: {}\n", options.max_terms);
  text += fmt::format("min_initial_terms: {}\n", options.min_initial_terms);
  text += fmt::format("max_initial_terms: {}\n",
                      options.max_initial_terms
                          ? std::to_string(*options.max_initial_terms)
                          : std::string(kAsMaxTerms));
  text += fmt::format("states: [{}]\n", fmt::join(states, ", "));
  return text;
}

/// `text` with `indent` blanks before every line.
std::string Indented(const std::string& text, int indent) {
  std::string indented;
  const std::string blanks(static_cast<std::size_t>(indent), ' ');
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin) + 1;
    indented += blanks + text.substr(begin, end - begin);
    begin = end;
  }
  return indented;
}

}  // namespace

Experiment ReadExperiment(YamlMap& map) {
  Experiment experiment;
  const std::size_t errors = map.place().error_count();
  map.Int("plsc_experiment", kFormat, kFormat, kFormat);
  experiment.name = map.Text("name", "");
  if (const auto seed = map.Find("seed"))
    experiment.seed = seed->Unsigned().value_or(experiment.seed);
  if (const auto robots = map.Find("robots"))
    experiment.robots = ReadName(*robots, "a name").value_or(experiment.robots);
  experiment.population =
      ReadPopulation(map, "population", experiment.population, 2);
  experiment.offspring =
      ReadPopulation(map, "offspring", experiment.offspring, 1);
  experiment.generations =
      map.Int("generations", experiment.generations, 1, kMaxGenerations);
  experiment.mutation =
      map.Number("mutation", experiment.mutation, kProbability);
  experiment.crossover =
      map.Number("crossover", experiment.crossover, kProbability);
  experiment.tournament =
      map.Int("tournament", experiment.tournament, 1, kMaxTournament);
  const Profile profile = map.Choice("profile", Profile::kPaper, kProfileNames);
  TakeHabits(profile, experiment);
  ReadVariation(map, experiment);
  experiment.trials = ReadTrials(map);
  experiment.genotype = ReadGenotype(map);
  ReadScenarioOf(map, profile, experiment);
  ReadFitnessOf(map, experiment);
  map.Close();
  if (map.place().error_count() == errors) CheckTogether(map, experiment);
  return experiment;
}

Result<Experiment> ParseExperiment(const Source& yaml) {
  const YamlFile file(yaml);
  Experiment experiment;
  if (std::optional<YamlMap> root = file.Root("an experiment"))
    experiment = ReadExperiment(*root);
  if (!file.diagnostics().empty()) return file.diagnostics();
  return experiment;
}

bool AreSame(const Experiment& one, const Experiment& other) {
  Experiment there = one;
  there.scenario_file = other.scenario_file;
  return there == other;
}

bool HasOwnFitness(const Experiment& experiment) {
  return HasOwnFitness(experiment.scenario);
}

std::string PrintExperimentKeys(const Experiment& experiment, int indent) {
  std::string text;
  text += fmt::format("robots: {}\n", PrintYamlText(experiment.robots));
  text += fmt::format("population: {}\n", experiment.population);
  text += fmt::format("offspring: {}\n", experiment.offspring);
  text += fmt::format("generations: {}\n", experiment.generations);
  text += fmt::format("mutation: {}\n", PrintPlainNumber(experiment.mutation));
  text +=
      fmt::format("crossover: {}\n", PrintPlainNumber(experiment.crossover));
  text += fmt::format("tournament: {}\n", experiment.tournament);
  text += PrintVariation(experiment);
  text += PrintFitness(experiment.scenario, "");
  text += PrintTrials(experiment.trials);
  text += PrintGenotypeOptions(experiment.genotype);
  return Indented(text, indent) + Indented("scenario:\n", indent) +
         PrintScenarioKeys(WithoutFitness(experiment.scenario), indent + 2);
}

std::string PrintExperiment(const Experiment& experiment) {
  std::string text = fmt::format("plsc_experiment: {}\n", kFormat);
  if (!experiment.name.empty())
    text += fmt::format("name: {}\n", PrintYamlText(experiment.name));
  text += fmt::format("seed: {}\n", experiment.seed);
  return text + PrintExperimentKeys(experiment, 0);
}

std::vector<Diagnostic> CheckSenses(const Experiment& experiment) {
  if (experiment.trials.noise.touch > 0 &&
      experiment.scenario.controller == ControllerMode::kOpenLoop)
    return {Diagnostic(Code::kMisfit, {},
                       "noise of touch sensors has no effect with 'controller: "
                       "open_loop', nor have they")
                .WithHelp("leave 'touch' out of 'noise', or write 'controller: "
                          "coupled'")};
  if (const auto problem = CheckTargets(experiment.scenario)) return {*problem};
  if (experiment.genotype.encoding == Encoding::kBaseline) return {};
  return CheckSenses(experiment.scenario, experiment.genotype.states);
}

}  // namespace plsc
