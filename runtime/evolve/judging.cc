#include "runtime/evolve/judging.h"

#include <cassert>
#include <utility>

#include "runtime/evolve/judge.h"

namespace plsc {

void Judging::Begin(const std::vector<Individual>& robots) {
  assert(outstanding_ == 0 && workers_.outstanding() == 0);
  robots_ = &robots;
  orders_.clear();
  tickets_.clear();
  lives_.assign(robots.size(), {});
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (!robots[i].evaluation.seasons.empty()) continue;
    ++outstanding_;
    lives_[i].seasons.resize(planner_.scenario().seasons.size());
    std::vector<LifePiece> pieces =
        planner_.Plan(robots[i].genotype, robots[i].heritage.senses);
    lives_[i].pieces = pieces.size();
    if (pieces.empty()) known_.push_back(i);
    for (LifePiece& piece : pieces) Take(i, std::move(piece));
  }
}

void Judging::Take(std::size_t robot, LifePiece piece) {
  const auto seasons = static_cast<std::int64_t>(piece.keys.size());
  const auto ticket = tickets_.find(piece.keys.front());
  if (ticket != tickets_.end()) {
    counts_.looked_up += seasons;
    orders_[ticket->second].robots.push_back(robot);
  } else if (const auto known = LookUp(piece)) {
    counts_.looked_up += seasons;
    Fill(robot, piece, *known);
  } else {
    const Individual& one = (*robots_)[robot];
    workers_.Submit(static_cast<int>(orders_.size()),
                    RequestFor(one.genotype, one.heritage.senses, piece));
    tickets_[piece.keys.front()] = orders_.size();
    orders_.push_back({std::move(piece), {robot}});
  }
}

std::optional<std::vector<Simulated>> Judging::LookUp(const LifePiece& piece) {
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

void Judging::Fill(std::size_t robot, const LifePiece& piece,
                   const std::vector<Simulated>& simulated) {
  OpenLife& life = lives_[robot];
  for (std::size_t i = 0; i < simulated.size(); ++i)
    life.seasons[piece.first + i] = simulated[i];
  if (--life.pieces == 0) known_.push_back(robot);
}

double Judging::StepOf(std::size_t season) const {
  return planner_.scenario().seasons[season].physics.step;
}

void Judging::Receive(const Reply& reply) {
  const Order& order = orders_[static_cast<std::size_t>(reply.ticket)];
  const LifePiece& piece = order.piece;
  const std::vector<Simulated> simulated =
      SimulatedOf(reply, piece.keys.size());
  counts_.simulations += static_cast<std::int64_t>(piece.keys.size());
  for (std::size_t i = 0; i < simulated.size(); ++i) {
    counts_.simulated_seconds +=
        static_cast<double>(simulated[i].steps) * StepOf(piece.first + i);
    // A death may be bad luck; nobody else should have it.
    if (simulated[i].outcome == Outcome::kWorkerDied) continue;
    for (SimulationCache* cache : caches_)
      if (auto failure = cache->Add(piece.keys[i], simulated[i]))
        failure_ = std::move(failure);
  }
  for (const std::size_t robot : order.robots) Fill(robot, piece, simulated);
}

std::vector<Verdict> Judging::Wait(int timeout_ms) {
  if (known_.empty()) {
    for (const Reply& reply : workers_.Wait(timeout_ms)) Receive(reply);
    if (workers_.failure() && workers_.outstanding() > 0)
      failure_ = workers_.failure();
  }
  std::vector<Verdict> verdicts;
  for (; !known_.empty(); known_.pop_front(), --outstanding_) {
    const std::size_t i = known_.front();
    const Individual& one = (*robots_)[i];
    verdicts.push_back({i, planner_.Assemble(one.genotype, one.heritage.senses,
                                             lives_[i].seasons)});
    lives_[i] = {};
  }
  return verdicts;
}

}  // namespace plsc
