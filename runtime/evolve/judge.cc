#include "runtime/evolve/judge.h"

#include <cassert>
#include <utility>

#include "compiler/compile.h"
#include "runtime/evolve/evaluation_frame.h"

namespace plsc {

Work JudgeWith(Evaluator evaluate) {
  return [evaluate = std::move(evaluate)](const std::string& text) {
    const Result<Program> program = Compile(Source("<worker>", text));
    // Every genotype prints as text that compiles to an equal one.
    assert(program);
    return Pack(evaluate(program->genotype));
  };
}

Evaluation EvaluationOf(const Reply& reply,
                        const std::vector<Season>& seasons) {
  if (reply.answer) {
    std::optional<Evaluation> evaluation = Unpack(*reply.answer);
    assert(evaluation);
    return std::move(*evaluation);
  }
  Evaluation evaluation;
  for (const Season& season : seasons) {
    SeasonResult result;
    result.season = season.name;
    result.outcome = Outcome::kWorkerDied;
    result.reason = "the process that simulated it died, twice";
    evaluation.seasons.push_back(std::move(result));
  }
  return evaluation;
}

}  // namespace plsc
