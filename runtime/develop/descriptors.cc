// The formulas of the authors' program (measure_body.py:57-384,
// measure_brain.py; paper, "Robot Descriptors"), oddities included: they are
// the axes of the paper's figures, and a mended one would be another axis. So
// children and modules are those without sensors throughout, joints that carry
// nothing count among the oscillators, free slots are never 0 but 0.0001, and a
// sigmoid makes deviations begin at 0.5.
//
// Sums run in the order of the body's modules and the brain's nodes. That order
// is part of the result: sums of doubles in another order differ in last bits,
// and stores keep and compare every bit.
//
// The lists of fields below (Visit*) name the columns of stores and tables, in
// their order. A name or a place that changes here changes the format of the
// store. Costs: modules times log modules, nodes times edges; microseconds.

#include "runtime/develop/descriptors.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "compiler/alphabet.h"
#include "sim/maths/exponential.h"

namespace plsc {

namespace {

// The authors' program counts children without sensors throughout.
int Children(const Body& body, const Module& module) {
  return static_cast<int>(std::count_if(
      module.children.begin(), module.children.end(), [&](int child) {
        return child != kNoModule &&
               body.modules[static_cast<std::size_t>(child)].type !=
                   ModuleType::kTouchSensor;
      }));
}

double Ratio(double part, double whole) {
  return whole > 0 ? part / whole : 0;
}

// Most modules that can be extremities of a body of `size`: below 6 all but
// the core; above, each further 3 modules add 2 and the remainder itself.
int MostExtremities(int size) {
  if (size < 6) return size - 1;
  return 2 * ((size - 6) / 3) + (size - 6) % 3 + 4;
}

void CountModules(const Body& body, BodyDescriptors& d) {
  for (const Module& module : body.modules) {
    const int children = Children(body, module);
    switch (module.type) {
      case ModuleType::kCore:
        if (children == 4) ++d.branching_modules_count;
        d.free_slots += 4 - children;
        break;
      case ModuleType::kBrick:
        ++d.brick_count;
        if (children == 3) ++d.branching_modules_count;
        d.free_slots += 3 - children;
        break;
      case ModuleType::kVerticalJoint:
      case ModuleType::kHorizontalJoint:
        ++d.hinge_count;
        if (children > 0) ++d.active_hinges_count;
        break;
      case ModuleType::kTouchSensor:
        ++d.touch_sensor_count;
        continue;  // no module of the size, no limb
    }
    if (module.type == ModuleType::kCore) continue;
    if (children == 0) ++d.extremities;
    if (children == 1) ++d.extensiveness;
  }
  d.absolute_size = 1 + d.brick_count + d.hinge_count;
}

using Cells = std::set<std::pair<int, int>>;

Cells CellsOf(const Body& body) {
  Cells cells;
  for (const Module& module : body.modules)
    if (module.type != ModuleType::kTouchSensor)
      cells.emplace(module.x, module.y);
  return cells;
}

void MeasureExtent(const Cells& cells, BodyDescriptors& d) {
  int left = 0;
  int right = 0;
  int back = 0;
  int front = 0;
  for (const auto& [x, y] : cells) {
    left = std::min(left, x);
    right = std::max(right, x);
    back = std::min(back, y);
    front = std::max(front, y);
  }
  d.width = right - left + 1;
  d.height = front - back + 1;
  d.coverage = static_cast<double>(d.absolute_size) / (d.width * d.height);
  d.proportion = static_cast<double>(std::min(d.width, d.height)) /
                 std::max(d.width, d.height);
}

// Of the cells off an axis through the core, the share whose mirror cell is
// taken as well; the larger of both axes.
double Symmetry(const Cells& cells) {
  int off_x = 0;
  int mirrored_x = 0;
  int off_y = 0;
  int mirrored_y = 0;
  for (const auto& [x, y] : cells) {
    if (x != 0) {
      ++off_x;
      mirrored_x += cells.contains({-x, y}) ? 1 : 0;
    }
    if (y != 0) {
      ++off_y;
      mirrored_y += cells.contains({x, -y}) ? 1 : 0;
    }
  }
  return std::max(Ratio(mirrored_x, off_x), Ratio(mirrored_y, off_y));
}

double Sigmoid(double x) {
  return 1 / (1 + Exp(-x));
}

double Median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle]
                                : (values[middle - 1] + values[middle]) / 2;
}

// Over n and not n - 1, as the authors' program has it.
double PopulationDeviation(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const double mean =
      std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / count);
}

struct ParameterSummary {
  double average = 0;    ///< median over the oscillators, over its maximum
  double deviation = 0;  ///< over the oscillators
};

ParameterSummary Summarise(const std::vector<Node>& oscillators,
                           double Node::*parameter) {
  std::vector<double> values;
  values.reserve(oscillators.size());
  for (const Node& node : oscillators) values.push_back(node.*parameter);
  return {Median(values) / plasticoding::kOscillatorHigh,
          PopulationDeviation(values)};
}

// Median over the touch inputs of the share of oscillators that they reach.
double SensorsReach(const Brain& brain, std::size_t oscillators) {
  std::vector<double> reaches;
  for (std::size_t i = 0; i < brain.nodes.size(); ++i) {
    if (brain.nodes[i].type != NodeType::kInput) continue;
    const auto edges = std::count_if(
        brain.connections.begin(), brain.connections.end(),
        [&](const Connection& c) { return c.source == static_cast<int>(i); });
    reaches.push_back(static_cast<double>(edges) /
                      static_cast<double>(oscillators));
  }
  return Median(reaches);
}

// Median over the oscillators of the balance of inhibiting and exciting
// weights that arrive; loops are left out.
double SynapticReception(const Brain& brain) {
  std::vector<double> balances;
  for (std::size_t i = 0; i < brain.nodes.size(); ++i) {
    if (brain.nodes[i].type != NodeType::kOscillator) continue;
    double negative = 0;
    double positive = 0;
    for (const Connection& c : brain.connections) {
      if (c.destination != static_cast<int>(i) || c.source == c.destination)
        continue;
      (c.weight < 0 ? negative : positive) += std::abs(c.weight);
    }
    balances.push_back(
        Ratio(std::min(negative, positive), std::max(negative, positive)));
  }
  return Median(balances);
}

// Each field under its name, of const structs and others: one list for both
// directions.
template <typename Descriptors, typename Visit>
void VisitBody(Descriptors& d, const Visit& visit) {
  visit("branching", d.branching);
  visit("branching_modules_count", d.branching_modules_count);
  visit("limbs", d.limbs);
  visit("extremities", d.extremities);
  visit("length_of_limbs", d.length_of_limbs);
  visit("extensiveness", d.extensiveness);
  visit("coverage", d.coverage);
  visit("joints", d.joints);
  visit("hinge_count", d.hinge_count);
  visit("active_hinges_count", d.active_hinges_count);
  visit("brick_count", d.brick_count);
  visit("touch_sensor_count", d.touch_sensor_count);
  visit("brick_sensor_count", d.brick_sensor_count);
  visit("proportion", d.proportion);
  visit("width", d.width);
  visit("height", d.height);
  visit("absolute_size", d.absolute_size);
  visit("sensors", d.sensors);
  visit("symmetry", d.symmetry);
  visit("free_slots", d.free_slots);
}

template <typename Descriptors, typename Visit>
void VisitBrain(Descriptors& d, const Visit& visit) {
  visit("avg_period", d.avg_period);
  visit("dev_period", d.dev_period);
  visit("avg_phase_offset", d.avg_phase_offset);
  visit("dev_phase_offset", d.dev_phase_offset);
  visit("avg_amplitude", d.avg_amplitude);
  visit("dev_amplitude", d.dev_amplitude);
  visit("avg_intra_dev_params", d.avg_intra_dev_params);
  visit("avg_inter_dev_params", d.avg_inter_dev_params);
  visit("sensors_reach", d.sensors_reach);
  visit("recurrence", d.recurrence);
  visit("synaptic_reception", d.synaptic_reception);
}

template <typename Descriptors, typename Visit>
void VisitBehaviour(Descriptors& b, const Visit& visit) {
  visit("velocity", b.velocity);
  visit("displacement_velocity", b.displacement_velocity);
  visit("displacement_velocity_hill", b.displacement_velocity_hill);
  visit("head_balance", b.head_balance);
  visit("contacts", b.contacts);
  visit("servo_error_median", b.servo_error_median);
  visit("servo_error_worst", b.servo_error_worst);
  visit("core_turns", b.core_turns);
  visit("final_x", b.final_x);
  visit("final_y", b.final_y);
  visit("final_z", b.final_z);
  visit("heading", b.heading);
  visit("straightness", b.straightness);
  visit("turning", b.turning);
  visit("energy", b.energy);
  visit("cost_of_transport", b.cost_of_transport);
  visit("target_distance", b.target_distance);
}

/// Adds what it visits to a list.
struct Lister {
  std::vector<NamedValue>& values;

  void operator()(std::string_view name, double value) const {
    values.push_back({name, value, false});
  }
  void operator()(std::string_view name, int value) const {
    values.push_back({name, static_cast<double>(value), true});
  }
};

/// Sets what it visits from a list, in its order.
struct Setter {
  const std::vector<double>& values;
  std::size_t& next;

  void operator()(std::string_view, double& value) const {
    value = values[next++];
  }
  void operator()(std::string_view, int& value) const {
    // Values of a damaged file may be anything.
    constexpr double kMost = std::numeric_limits<int>::max();
    const double number = values[next++];
    value = number >= -kMost && number <= kMost ? static_cast<int>(number) : 0;
  }
};

}  // namespace

BodyDescriptors DescribeBody(const Body& body) {
  BodyDescriptors d;
  CountModules(body, d);
  const int size = d.absolute_size;
  // Below 5 the divisor would be 0, below 3 that of the limbs.
  if (size >= 5)
    d.branching = d.branching_modules_count / std::floor((size - 2) / 3.0);
  d.limbs = Ratio(d.extremities, MostExtremities(size));
  if (size >= 3) {
    d.length_of_limbs = static_cast<double>(d.extensiveness) / (size - 2);
    d.joints = static_cast<double>(d.active_hinges_count) / (size - 2);
  }
  const Cells cells = CellsOf(body);
  MeasureExtent(cells, d);
  d.symmetry = Symmetry(cells);
  // The authors' program keeps the division defined with this number, and
  // publishes it as a descriptor. Sensors sit on free slots: it gives 0.
  if (d.free_slots == 0) d.free_slots = 0.0001;
  d.sensors = d.touch_sensor_count / d.free_slots;
  return d;
}

BrainDescriptors DescribeBrain(const Phenotype& phenotype) {
  BrainDescriptors d;
  BodyDescriptors counts;
  CountModules(phenotype.body, counts);
  // The authors' program asks nothing of such a brain (revolve_bot.py:102-109),
  // not even for the descriptors that would be defined.
  if (counts.active_hinges_count == 0) return d;

  std::vector<Node> oscillators;
  std::vector<double> intra;
  for (const Node& node : phenotype.brain.nodes) {
    if (node.type != NodeType::kOscillator) continue;
    oscillators.push_back(node);
    intra.push_back(
        PopulationDeviation({node.period, node.phase_offset, node.amplitude}));
  }
  const ParameterSummary period = Summarise(oscillators, &Node::period);
  const ParameterSummary offset = Summarise(oscillators, &Node::phase_offset);
  const ParameterSummary amplitude = Summarise(oscillators, &Node::amplitude);
  d.avg_period = period.average;
  d.dev_period = Sigmoid(period.deviation);
  d.avg_phase_offset = offset.average;
  d.dev_phase_offset = Sigmoid(offset.deviation);
  d.avg_amplitude = amplitude.average;
  d.dev_amplitude = Sigmoid(amplitude.deviation);
  d.avg_intra_dev_params = Sigmoid(Median(intra));
  d.avg_inter_dev_params =
      Sigmoid((period.deviation + offset.deviation + amplitude.deviation) / 3);
  d.sensors_reach = SensorsReach(phenotype.brain, oscillators.size());
  const auto loops = std::count_if(
      phenotype.brain.connections.begin(), phenotype.brain.connections.end(),
      [](const Connection& c) { return c.source == c.destination; });
  d.recurrence =
      static_cast<double>(loops) / static_cast<double>(oscillators.size());
  d.synaptic_reception = SynapticReception(phenotype.brain);
  return d;
}

std::vector<NamedValue> List(const BodyDescriptors& descriptors) {
  std::vector<NamedValue> values;
  VisitBody(descriptors, Lister{values});
  return values;
}

std::vector<NamedValue> List(const BrainDescriptors& descriptors) {
  std::vector<NamedValue> values;
  VisitBrain(descriptors, Lister{values});
  return values;
}

std::vector<NamedValue> List(const Behaviour& behaviour) {
  std::vector<NamedValue> values;
  VisitBehaviour(behaviour, Lister{values});
  return values;
}

BodyDescriptors BodyDescriptorsOf(const std::vector<double>& values) {
  BodyDescriptors descriptors;
  std::size_t next = 0;
  VisitBody(descriptors, Setter{values, next});
  assert(next == values.size());
  return descriptors;
}

BrainDescriptors BrainDescriptorsOf(const std::vector<double>& values) {
  BrainDescriptors descriptors;
  std::size_t next = 0;
  VisitBrain(descriptors, Setter{values, next});
  assert(next == values.size());
  return descriptors;
}

Behaviour BehaviourOf(const std::vector<double>& values) {
  Behaviour behaviour;
  std::size_t next = 0;
  VisitBehaviour(behaviour, Setter{values, next});
  behaviour.is_valid = true;
  assert(next == values.size());
  return behaviour;
}

}  // namespace plsc
