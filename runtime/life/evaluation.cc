#include "runtime/life/evaluation.h"

#include "runtime/life/life.h"

namespace plsc {

Evaluation Evaluate(const Genotype& genotype, const Scenario& scenario,
                    const Disturbances& disturbances) {
  Evaluation evaluation;
  for (Life life(genotype, scenario, nullptr, {}, disturbances);
       !life.is_over();)
    evaluation.seasons.push_back(life.Next().result);
  return evaluation;
}

}  // namespace plsc
