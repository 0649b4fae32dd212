// One line for each kind of result that is the same on all machines: a name and
// the hash of many, bit for bit. Built for this machine and for another one by
// .ci/check_aarch64, which compares. No ODE: its results have a kind of
// machine.

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "compiler/print.h"
#include "runtime/develop/descriptors.h"
#include "runtime/develop/develop.h"
#include "runtime/develop/phenotype_json.h"
#include "runtime/vary/crossover.h"
#include "runtime/vary/initialise.h"
#include "runtime/vary/mutate.h"
#include "sim/assembly.h"
#include "sim/controller.h"
#include "sim/fnv.h"
#include "sim/overlap.h"
#include "sim/placement.h"
#include "sim/recorder.h"
#include "sim/simulate.h"
#include "tests/sim/maths/maths_hash.h"
#include "tests/sim/terrains.h"

namespace plsc {
namespace {

constexpr std::uint64_t kSeed = 16;  // any
constexpr int kGenotypes = 300;

void Tell(const char* name, std::uint64_t hash) {
  std::printf("%s %016llx\n", name, static_cast<unsigned long long>(hash));
}

void Random() {
  Fnv hash;
  Rng rng({kSeed, 0, 0, Purpose::kInitialise});
  for (int i = 0; i < 100'000; ++i)
    for (const double x : {rng.Normal(), rng.Uniform(), rng.Uniform(-3, 7),
                           static_cast<double>(rng.Index(1000))})
      hash.Add(x);
  Tell("random", hash.value());
}

/// Drawn, crossed and mutated, every other one of the baseline.
std::vector<Genotype> Genotypes() {
  std::vector<Genotype> genotypes;
  for (std::uint64_t i = 0; i < kGenotypes; ++i) {
    Rng rng({kSeed, 1, i, Purpose::kInitialise});
    GenotypeOptions options;
    if (i % 2 == 1) options.encoding = Encoding::kBaseline;
    Genotype genotype = Initialise(options, rng);
    if (i >= 2)
      genotype = Cross(genotype, genotypes[i - 2],
                       DrawCrossover(*genotype.alphabet, rng));
    for (int k = 0; k < 3; ++k) {
      const Mutation mutation = DrawMutation(genotype, options.encoding, rng);
      genotype = Mutate(std::move(genotype), mutation, rng);
    }
    genotypes.push_back(std::move(genotype));
  }
  return genotypes;
}

/// Those that can be assembled and have joints are given back.
std::vector<Phenotype> Developed(const std::vector<Genotype>& genotypes) {
  std::vector<Phenotype> robots;
  Fnv hash;
  for (const Genotype& genotype : genotypes) {
    const std::size_t states = genotype.states.size();
    for (const double is_inclined : {0.0, 1.0}) {
      const auto phenotype = Develop(
          genotype, Environment{std::vector<double>(states, is_inclined)});
      if (!phenotype) continue;
      hash.Add(BodyJson(phenotype->body));
      hash.Add(BrainJson(*phenotype));
      for (const NamedValue& one : List(DescribeBody(phenotype->body)))
        hash.Add(one.value);
      for (const NamedValue& one : List(DescribeBrain(*phenotype)))
        hash.Add(one.value);
      const Assembly assembly = Assemble(phenotype->body);
      if (!assembly.hinges.empty() && FindOverlaps(assembly).empty())
        robots.push_back(*phenotype);
    }
  }
  Tell("developed", hash.value());
  return robots;
}

void Controlled(const std::vector<Phenotype>& robots) {
  Fnv hash;
  for (const Phenotype& robot : robots)
    for (const ControllerMode mode :
         {ControllerMode::kOpenLoop, ControllerMode::kCoupled}) {
      Controller controller(robot, mode);
      std::vector<bool> touched(robot.body.modules.size());
      for (int update = 0; update < 400; ++update) {
        touched[static_cast<std::size_t>(update) % touched.size()].flip();
        for (const double output : controller.Update(update / 8.0, touched))
          hash.Add(output);
      }
    }
  Tell("controlled", hash.value());
}

void Placed(const std::vector<Phenotype>& robots) {
  Fnv hash;
  const SimulationOptions options;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const Assembly assembly = Assemble(robots[i].body);
    const auto turn = static_cast<double>(i);
    for (const Terrain& terrain : test::AllTerrains()) {
      const Placement start =
          StartOf(assembly, terrain, options, {turn / 10, -turn / 7, turn});
      for (const double x : start.position) hash.Add(x);
      for (const double x : start.axes.reshaped()) hash.Add(x);
      for (const double x : RollPitchYaw(start.axes)) hash.Add(x);
      hash.Add(SpotOf(start).heading);
    }
  }
  Tell("placed", hash.value());
}

/// 100 lives of 5 s on all kinds of ground.
void Lives(const std::vector<Phenotype>& robots) {
  Fnv hash;
  const std::vector<Terrain> terrains = test::AllTerrains();
  SimulationOptions options;
  options.physics.engine = EngineKind::kArticulated;
  options.duration = 5;
  for (std::size_t i = 0; i < 100; ++i) {
    const Trajectory life = Simulate(robots[i * robots.size() / 100],
                                     terrains[i % terrains.size()], options);
    hash.Add(std::to_string(life.state_hash));
    hash.Add(static_cast<double>(life.outcome));
    for (const double x : life.mass_centre.reshaped()) hash.Add(x);
    for (const double x : life.core_orientation.reshaped()) hash.Add(x);
  }
  Tell("lived", hash.value());
}

}  // namespace
}  // namespace plsc

int main() {
  plsc::Tell("maths", plsc::test::MathsHash());
  plsc::Random();
  const std::vector<plsc::Genotype> genotypes = plsc::Genotypes();
  plsc::Fnv printed;
  for (const plsc::Genotype& genotype : genotypes)
    printed.Add(plsc::Print(genotype));
  plsc::Tell("genotypes", printed.value());
  const std::vector<plsc::Phenotype> robots = plsc::Developed(genotypes);
  std::printf("robots %zu\n", robots.size());
  plsc::Controlled(robots);
  plsc::Placed(robots);
  plsc::Lives(robots);
  return robots.size() > 50 ? 0 : 1;
}
