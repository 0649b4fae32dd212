// A generation's lives as a stream: robots are planned a few at a time, each
// piece of a life is looked up by its key (in the generation itself, then in
// the caches), and what nobody knows goes to the workers. A key is ordered
// once; whoever else lives the same is noted as a place to be filled when the
// answer comes. So equal robots cost one simulation, and which of them was
// first does not show in any result.
//
// What waits is bounded to some requests a worker, whatever the size of the
// generation: planning stops while kAhead requests a worker are outstanding,
// and goes on between answers. With fewer the workers would wait for us, and a
// generation that is planned as a whole would have its first simulation begun
// only then.
//
// Each place is filled exactly once, and a robot is told when all of its pieces
// are, of all of its trials. A worker's death is the answer for the places that
// waited for it but is not kept for others, nor in a cache: it says something
// about a process and nothing about a robot.

#include "runtime/evolve/generation_evaluator.h"

#include <cassert>
#include <utility>

#include "runtime/evolve/worker_request.h"
#include "runtime/life/simulated.h"

namespace plsc {

namespace {

// Requests that workers have before them, for each: enough that none waits
// while its owner stores what came before, and that MPI's ranks get some in
// advance; few enough that they take no memory to speak of (5 KB each).
constexpr int kAhead = 16;

// Robots that are planned in one go. Most take less than a millisecond, those
// of the longest strings a second.
constexpr int kPlans = 16;

}  // namespace

void GenerationEvaluator::Begin(const std::vector<Individual>& robots) {
  assert(outstanding_ == 0 && workers_.outstanding() == 0);
  robots_ = &robots;
  next_ = 0;
  orders_.clear();
  tickets_.clear();
  open_.assign(robots.size(), {});
  for (const Individual& robot : robots)
    outstanding_ += robot.evaluation.seasons.empty() ? 1 : 0;
}

void GenerationEvaluator::Cancel() {
  next_ = robots_->size();
  workers_.CancelWaiting();
}

bool GenerationEvaluator::HasRoom() const {
  return workers_.outstanding() < kAhead * (1 + workers_.workers());
}

/// Whether there is room for more at once.
bool GenerationEvaluator::PlanSome() {
  for (int planned = 0; planned < kPlans && next_ < robots_->size(); ++next_) {
    if (!HasRoom()) return false;
    if (!(*robots_)[next_].evaluation.seasons.empty()) continue;
    Plan(next_);
    ++planned;
  }
  return next_ < robots_->size() && HasRoom();
}

void GenerationEvaluator::Plan(std::size_t robot) {
  const Individual& one = (*robots_)[robot];
  OpenRobot& open = open_[robot];
  open.trials = TrialsOf(plan_, planner_, one);
  open.lives.resize(open.trials.size());
  std::vector<std::vector<LifePiece>> pieces;
  pieces.reserve(open.trials.size());
  for (std::size_t i = 0; i < open.trials.size(); ++i) {
    open.lives[i].resize(planner_.scenario().seasons.size());
    pieces.push_back(
        planner_.Plan(one.genotype, one.heritage.senses, open.trials[i]));
    open.pieces += pieces.back().size();
  }
  if (open.pieces == 0) known_.push_back(robot);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (LifePiece& piece : pieces[i]) {
      const Place place = {robot, i, piece.first};
      Take(place, std::move(piece));
    }
}

void GenerationEvaluator::Take(const Place& place, LifePiece piece) {
  if (!plan_.options.own_lives && TakeKnown(place, piece)) return;
  const Individual& one = (*robots_)[place.robot];
  workers_.Submit(static_cast<int>(orders_.size()),
                  RequestFor(one.genotype, one.heritage.senses, piece,
                             open_[place.robot].trials[place.trial]));
  tickets_[piece.keys] = orders_.size();
  orders_.push_back({std::move(piece), {place}, {}});
}

/// Whether somebody lives it, or has lived it before.
bool GenerationEvaluator::TakeKnown(const Place& place,
                                    const LifePiece& piece) {
  const auto seasons = static_cast<std::int64_t>(piece.keys.size());
  const auto ticket = tickets_.find(piece.keys);
  if (ticket != tickets_.end()) {
    counts_.looked_up += seasons;
    Order& order = orders_[ticket->second];
    if (order.simulated.empty())
      order.places.push_back(place);
    else
      Fill(place, order.simulated);
    return true;
  }
  const auto known = LookUp(piece);
  if (!known) return false;
  counts_.looked_up += seasons;
  Fill(place, *known);
  return true;
}

std::optional<std::vector<Simulated>> GenerationEvaluator::LookUp(
    const LifePiece& piece) {
  for (SimulationCache* cache : caches_) {
    std::vector<Simulated> found;
    for (const Key& key : piece.keys) {
      std::optional<Simulated> season = cache->Find(key);
      if (!season) break;
      found.push_back(std::move(*season));
    }
    if (found.size() == piece.keys.size()) return found;
  }
  return std::nullopt;
}

void GenerationEvaluator::Fill(const Place& place,
                               const std::vector<Simulated>& simulated) {
  OpenRobot& open = open_[place.robot];
  auto& seasons = open.lives[place.trial];
  for (std::size_t i = 0; i < simulated.size(); ++i) {
    assert(!seasons[place.first + i]);
    seasons[place.first + i] = simulated[i];
  }
  if (--open.pieces == 0) known_.push_back(place.robot);
}

double GenerationEvaluator::StepOf(std::size_t season) const {
  return planner_.scenario().seasons[season].physics.step;
}

void GenerationEvaluator::Receive(const Reply& reply) {
  Order& order = orders_[static_cast<std::size_t>(reply.ticket)];
  const LifePiece& piece = order.piece;
  order.simulated = SimulatedOf(reply, piece.keys.size());
  const std::vector<Simulated>& simulated = order.simulated;
  counts_.simulations += static_cast<std::int64_t>(piece.keys.size());
  for (std::size_t i = 0; i < simulated.size(); ++i) {
    counts_.simulated_seconds +=
        static_cast<double>(simulated[i].steps) * StepOf(piece.first + i);
    // A death may be bad luck; nobody else should have it.
    if (simulated[i].outcome == Outcome::kWorkerDied) {
      tickets_.erase(piece.keys);
      continue;
    }
    for (SimulationCache* cache : caches_)
      if (auto failure = cache->Add(piece.keys[i], simulated[i]))
        failure_ = std::move(failure);
  }
  for (const Place& place : order.places) Fill(place, simulated);
  order.places = {};
}

EvaluatedLife GenerationEvaluator::Assemble(std::size_t robot) {
  const Individual& one = (*robots_)[robot];
  const OpenRobot& open = open_[robot];
  std::vector<EvaluatedLife> lives;
  lives.reserve(open.trials.size());
  for (std::size_t i = 0; i < open.trials.size(); ++i)
    lives.push_back(planner_.Assemble(one.genotype, one.heritage.senses,
                                      open.lives[i], open.trials[i]));
  return OverTrials(std::move(lives), open.trials, plan_.options);
}

std::vector<EvaluatedRobot> GenerationEvaluator::Wait(int timeout_ms) {
  const bool has_more = PlanSome();
  if (known_.empty()) {
    for (const Reply& reply : workers_.Wait(has_more ? 0 : timeout_ms))
      Receive(reply);
    if (workers_.failure() && workers_.outstanding() > 0)
      failure_ = workers_.failure();
  }
  std::vector<EvaluatedRobot> evaluated;
  for (; !known_.empty(); known_.pop_front(), --outstanding_) {
    const std::size_t i = known_.front();
    evaluated.push_back({i, Assemble(i)});
    open_[i] = {};
  }
  return evaluated;
}

}  // namespace plsc
