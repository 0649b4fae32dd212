#include "runtime/store/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <string_view>
#include <utility>

#include "runtime/develop/descriptors.h"
#include "runtime/store/database.h"
#include "runtime/store/packing.h"

namespace plsc {

namespace {

struct NewMeasure {
  std::string_view name;
  int since = 0;  // schema
};
// Of behaviour, in its order.
constexpr NewMeasure kNewMeasures[] = {
    {"servo_error_median", 3},
    {"servo_error_worst", 3},
    {"core_turns", 3},
    {"final_x", 5},
    {"final_y", 5},
    {"final_z", 5},
    {"heading", 5},
    {"straightness", 5},
    {"turning", 5},
    {"energy", 5},
    {"cost_of_transport", 5},
    {"target_distance", 5},
};

std::vector<std::string> Names(const std::vector<NamedValue>& list) {
  std::vector<std::string> names;
  names.reserve(list.size());
  for (const NamedValue& value : list) names.emplace_back(value.name);
  return names;
}

std::string Columns(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += fmt::format("  {} REAL,\n", name);
  return text;
}

std::string Qualified(std::string_view table,
                      const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += fmt::format(", {}.{}", table, name);
  return text;
}

constexpr const char* kRun = R"sql(CREATE TABLE run(
  id INTEGER PRIMARY KEY CHECK (id = 1),
  name TEXT NOT NULL,
  seed TEXT NOT NULL,  -- decimal; an INTEGER holds only half of them
  generations INTEGER NOT NULL,  -- to be made, the initial one included
  evaluations INTEGER NOT NULL,  -- to be made
  random TEXT NOT NULL,  -- where random numbers come from
  plsc TEXT NOT NULL,  -- versions
  ode TEXT NOT NULL,
  compiler TEXT NOT NULL,
  machine TEXT NOT NULL,  -- its kind: of the same kind, the same bits{}
  experiment TEXT NOT NULL,  -- YAML, every value
  scenario TEXT NOT NULL,  -- YAML, every value
  checksum INTEGER NOT NULL))sql";

// What schema 2 has more.
constexpr const char* kRunResults = R"sql(; or 'any'
  results INTEGER NOT NULL,  -- number of the arithmetic)sql";

constexpr const char* kSeason = R"sql(CREATE TABLE season(
  id INTEGER PRIMARY KEY,  -- from 1, in the scenario's order
  name TEXT NOT NULL UNIQUE))sql";

constexpr const char* kPhysics = R"sql(CREATE TABLE physics(
  season INTEGER NOT NULL REFERENCES season,
  name TEXT NOT NULL,  -- 'physics.step', 'servo.gain', 'terrain'
  value,  -- a number where it is one
  unit TEXT,  -- of a number that has one
  PRIMARY KEY (season, name)) WITHOUT ROWID)sql";

constexpr const char* kHeader = R"sql(CREATE TABLE header(
  id INTEGER PRIMARY KEY,
  before_name TEXT NOT NULL,  -- of the genotype's text, up to its name
  after_name TEXT NOT NULL,  -- up to its first rule
  UNIQUE (before_name, after_name)))sql";

constexpr const char* kIndividual = R"sql(CREATE TABLE individual(
  id INTEGER PRIMARY KEY,  -- from 1, in order of birth
  name TEXT NOT NULL,
  generation INTEGER NOT NULL,  -- of birth, from 0
  parent1 INTEGER REFERENCES individual,
  parent2 INTEGER REFERENCES individual,
  from_second TEXT NOT NULL,  -- JSON: symbols whose rules are parent2's
  mutation TEXT,  -- 'delete', 'swap', 'add', 'clause' or NULL
  mutated_rule INTEGER,  -- from 0
  senses TEXT NOT NULL,  -- JSON: inherited, state to value
  header INTEGER NOT NULL REFERENCES header,
  checksum INTEGER NOT NULL))sql";

constexpr const char* kRule = R"sql(CREATE TABLE rule(
  id INTEGER PRIMARY KEY,
  hash INTEGER NOT NULL,  -- of the text, for an index that is small
  text TEXT NOT NULL))sql";

constexpr const char* kRuleByHash = "CREATE INDEX rule_by_hash ON rule(hash)";

constexpr const char* kGenotypeRule = R"sql(CREATE TABLE genotype_rule(
  individual INTEGER NOT NULL REFERENCES individual,
  position INTEGER NOT NULL,  -- from 0
  rule INTEGER NOT NULL REFERENCES rule,
  PRIMARY KEY (individual, position)) WITHOUT ROWID)sql";

constexpr const char* kBody = R"sql(CREATE TABLE body(
  key TEXT PRIMARY KEY,  -- of the modules
  packed TEXT NOT NULL,  -- the view robot has it as JSON
{}  CHECK (length(key) = 32)))sql";

constexpr const char* kPhenotype = R"sql(CREATE TABLE phenotype(
  key TEXT PRIMARY KEY,  -- of body and brain
  body TEXT NOT NULL REFERENCES body,
  packed TEXT NOT NULL,  -- brain; the view robot has it as JSON
{}  CHECK (length(key) = 32)))sql";

constexpr const char* kSimulation = R"sql(CREATE TABLE simulation(
  key TEXT PRIMARY KEY,  -- of the phenotype, the season and the physics
  begin REAL NOT NULL,  -- s since birth
  inclination REAL,  -- rad
  outcome TEXT NOT NULL,
  reason TEXT NOT NULL,
  is_valid INTEGER NOT NULL,  -- whether it behaved; else these are NULL:
{}  state_hash TEXT NOT NULL,
  steps INTEGER NOT NULL,
  solver_warnings INTEGER NOT NULL,
  CHECK (length(key) = 32)) WITHOUT ROWID)sql";

constexpr const char* kEvaluation = R"sql(CREATE TABLE evaluation(
  individual INTEGER NOT NULL REFERENCES individual,
  season INTEGER NOT NULL REFERENCES season,
  phenotype TEXT REFERENCES phenotype,  -- NULL: no robot developed
  simulation TEXT REFERENCES simulation,  -- NULL: nothing to simulate
  profile TEXT NOT NULL,
  begin REAL NOT NULL,  -- s since birth
  inclination REAL,  -- rad, if the IMU was asked
  sensed TEXT NOT NULL,  -- JSON: state to value
  sources TEXT NOT NULL,  -- JSON: state to who told it, 'season' or 'imu'
  change TEXT NOT NULL,  -- 'born', 'none', 'brain', 'body'
  change_reason TEXT NOT NULL,
  outcome TEXT NOT NULL,
  reason TEXT NOT NULL,
  fitness REAL,  -- m/s; NULL is worse than any number
  checksum INTEGER NOT NULL,
  PRIMARY KEY (individual, season)) WITHOUT ROWID)sql";

constexpr const char* kTrial = R"sql(CREATE TABLE trial(
  individual INTEGER NOT NULL REFERENCES individual,
  season INTEGER NOT NULL REFERENCES season,
  number INTEGER NOT NULL,  -- from 1
  phenotype TEXT REFERENCES phenotype,  -- NULL: no robot developed
  simulation TEXT REFERENCES simulation,  -- NULL: nothing to simulate
  outcome TEXT NOT NULL,
  reason TEXT NOT NULL,
  fitness REAL,  -- m/s; NULL is worse than any number
  lift REAL NOT NULL,  -- m; how this life was disturbed
  shift_x REAL NOT NULL,  -- m
  shift_y REAL NOT NULL,  -- m
  yaw REAL NOT NULL,  -- rad
  friction REAL NOT NULL,  -- factor
  lean REAL NOT NULL,  -- rad
  touch REAL NOT NULL,  -- probability
  touch_seed TEXT NOT NULL,  -- decimal
  motor REAL NOT NULL,  -- rad
  motor_seed TEXT NOT NULL,  -- decimal
  PRIMARY KEY (individual, season, number)) WITHOUT ROWID)sql";

constexpr const char* kGeneration = R"sql(CREATE TABLE generation(
  number INTEGER PRIMARY KEY,  -- from 0; a row when it is completed
  best INTEGER NOT NULL REFERENCES individual,
{}  checksum INTEGER NOT NULL))sql";

// Of its survivors, since schema 3.
constexpr const char* kCensus = R"sql(  -- of its survivors, how many:
  genotypes INTEGER NOT NULL,  -- distinct, names apart
  phenotypes INTEGER NOT NULL,  -- distinct, the robots of all seasons together
  founders INTEGER NOT NULL,  -- of generation 0 have rules in them
  plastic_bodies INTEGER NOT NULL,  -- have another body in some season
  plastic_brains INTEGER NOT NULL,  -- have the same body, another brain
  rules INTEGER NOT NULL,  -- rules they have, all together
  regulated_rules INTEGER NOT NULL,  -- of these have a clause
  silent_rules INTEGER NOT NULL,  -- of these were active in no season
)sql";

constexpr const char* kMember = R"sql(CREATE TABLE member(
  generation INTEGER NOT NULL REFERENCES generation,
  individual INTEGER NOT NULL REFERENCES individual,
  place INTEGER NOT NULL,  -- in the pool, from 0: parents, then children
  count INTEGER NOT NULL,  -- others of the pool that it dominates
  survivor INTEGER,  -- from 0 in the order of selection; NULL: not selected
  PRIMARY KEY (generation, individual)) WITHOUT ROWID)sql";

constexpr const char* kSession = R"sql(CREATE TABLE session(
  id INTEGER PRIMARY KEY,
  started TEXT NOT NULL,  -- UTC
  ended TEXT,  -- NULL: it goes on, or was killed
  how TEXT,  -- 'finished', 'stopped', 'failed: ...'
  host TEXT NOT NULL,
  pid INTEGER NOT NULL,
  plsc TEXT NOT NULL,
  ode TEXT NOT NULL,
  compiler TEXT NOT NULL,
  machine TEXT NOT NULL,
  jobs INTEGER NOT NULL,  -- asked for
  workers INTEGER,
  evaluations INTEGER,
  simulated INTEGER,  -- seasons
  looked_up INTEGER,  -- seasons that were known
  seconds REAL,
  cpu_seconds REAL))sql";

// The inner SELECT puts the rules in order; SQLite keeps an ORDER BY below a
// group_concat.
constexpr const char* kGenotype =
    R"sql(CREATE VIEW genotype(id, name, text) AS
  SELECT individual.id, individual.name,
    header.before_name || individual.name || header.after_name ||
    ifnull((SELECT group_concat(char(10) || text, '') FROM
      (SELECT rule.text AS text FROM genotype_rule
       JOIN rule ON rule.id = genotype_rule.rule
       WHERE genotype_rule.individual = individual.id
       ORDER BY genotype_rule.position)), '')
  FROM individual JOIN header ON header.id = individual.header)sql";

constexpr const char* kResult = R"sql(CREATE VIEW result AS
  SELECT evaluation.individual AS id, individual.generation,
    season.name AS season, evaluation.fitness, evaluation.outcome,
    evaluation.reason, evaluation.begin, evaluation.inclination,
    evaluation.sensed, evaluation.sources, evaluation.change,
    evaluation.change_reason{}{}{}, simulation.steps,
    simulation.solver_warnings, simulation.state_hash,
    evaluation.phenotype, evaluation.simulation
  FROM evaluation
  JOIN individual ON individual.id = evaluation.individual
  JOIN season ON season.id = evaluation.season
  LEFT JOIN phenotype ON phenotype.key = evaluation.phenotype
  LEFT JOIN body ON body.key = phenotype.body
  LEFT JOIN simulation ON simulation.key = evaluation.simulation)sql";

constexpr const char* kRobot = R"sql(CREATE VIEW robot AS
  SELECT phenotype.key AS phenotype, {} AS body, {} AS brain
  FROM phenotype JOIN body ON body.key = phenotype.body)sql";

constexpr const char* kPopulation = R"sql(CREATE VIEW population AS
  SELECT member.generation, member.survivor, member.individual AS id,
    member.count
  FROM member WHERE member.survivor IS NOT NULL)sql";

// All there is to the state of the random numbers.
constexpr const char* kNext =
    R"sql(CREATE VIEW next(random, seed, generation, id) AS
  SELECT run.random, run.seed, (SELECT count(*) FROM generation),
    1 + ifnull((SELECT max(individual) FROM member WHERE generation =
      (SELECT max(number) FROM generation)), 0)
  FROM run)sql";

std::vector<SchemaItem> MakeSchema(int version) {
  const auto body = BodyColumns();
  const auto brain = BrainColumns();
  const auto behaviour = BehaviourColumns(version);
  const auto table = [](const char* name, std::string sql, const char* order) {
    return SchemaItem{name, std::move(sql), SchemaKind::kTable, true, order};
  };
  const auto view = [](const char* name, std::string sql) {
    return SchemaItem{name, std::move(sql), SchemaKind::kView, true, ""};
  };
  std::vector<SchemaItem> items = {
      table("run", fmt::format(kRun, version < 2 ? "" : kRunResults), "id"),
      table("season", kSeason, "id"),
      table("physics", kPhysics, "season, name"),
      table("header", kHeader, "id"),
      table("individual", kIndividual, "id"),
      table("rule", kRule, "id"),
      {"rule_by_hash", kRuleByHash, SchemaKind::kIndex, true, ""},
      table("genotype_rule", kGenotypeRule, "individual, position"),
      table("body", fmt::format(kBody, Columns(body)), "key"),
      table("phenotype", fmt::format(kPhenotype, Columns(brain)), "key"),
      table("simulation", fmt::format(kSimulation, Columns(behaviour)), "key"),
      table("evaluation", kEvaluation, "individual, season"),
      table("generation", fmt::format(kGeneration, version < 3 ? "" : kCensus),
            "number"),
      table("member", kMember, "generation, individual"),
      {"session", kSession, SchemaKind::kTable, false, "id"},
      view("genotype", kGenotype),
      view("result", fmt::format(kResult, Qualified("body", body),
                                 Qualified("phenotype", brain),
                                 Qualified("simulation", behaviour))),
      view("robot", fmt::format(kRobot, UnpackSql("body.packed"),
                                UnpackSql("phenotype.packed"))),
      view("population", kPopulation),
      view("next", kNext),
  };
  // After what it refers to.
  const auto members =
      std::find_if(items.begin(), items.end(),
                   [](const SchemaItem& one) { return one.name == "member"; });
  if (version >= 4)
    items.insert(members, table("trial", kTrial, "individual, season, number"));
  return items;
}

}  // namespace

const std::vector<SchemaItem>& Schema(int version) {
  static const std::vector<SchemaItem> all[] = {MakeSchema(1), MakeSchema(2),
                                                MakeSchema(3), MakeSchema(4),
                                                MakeSchema(5)};
  static_assert(std::size(all) == kSchemaVersion);
  assert(version >= kOldestSchema && version <= kSchemaVersion);
  return all[version - kOldestSchema];
}

int SchemaOf(Database& database) {
  const std::int64_t version = SingleInteger(database, "PRAGMA user_version");
  return std::in_range<int>(version) ? static_cast<int>(version) : 0;
}

std::vector<std::string> BodyColumns() {
  return Names(List(BodyDescriptors{}));
}

std::vector<std::string> BrainColumns() {
  return Names(List(BrainDescriptors{}));
}

std::vector<std::string> BehaviourColumns(int version) {
  std::vector<std::string> names = Names(List(Behaviour{}));
  for (const std::string& missing : MissingMeasures(version))
    std::erase(names, missing);
  return names;
}

std::vector<std::string> CensusColumns(int version) {
  if (version < 3) return {};
  return {"genotypes",      "phenotypes", "founders",        "plastic_bodies",
          "plastic_brains", "rules",      "regulated_rules", "silent_rules"};
}

std::vector<std::string> MissingMeasures(int version) {
  std::vector<std::string> missing;
  for (const NewMeasure& measure : kNewMeasures)
    if (measure.since > version) missing.emplace_back(measure.name);
  return missing;
}

}  // namespace plsc
