#include "tests/runtime/study/small_study.h"

#include "runtime/evolve/evolve.h"
#include "runtime/store/run_store.h"
#include "tests/runtime/evolve/fake_run.h"

namespace plsc::test {

Study SmallStudy() {
  Study study;
  study.name = "small";
  study.seed = 7;
  study.repetitions = 2;
  study.experiments = {{"plastic", SmallExperiment()},
                       {"baseline", SmallExperiment()}};
  study.experiments[1].experiment.genotype.encoding = Encoding::kBaseline;
  return study;
}

RunEnd Execute(const RunTask& task, int most) {
  RunStore store;
  if (task.resume ? store.Open(task.path)
                  : store.Create(task.path, task.experiment))
    return RunEnd::kFailed;
  EvolveOptions options;
  options.jobs = 1;
  options.simulate = Look;
  options.observers = {&store};
  if (task.resume) options.saved = *store.Load();
  std::int64_t done = 0;
  options.on_progress = [&](const Progress& progress) {
    done = progress.evaluations;
  };
  options.should_stop = [&] { return most > 0 && done >= most; };
  const RunResult result = Evolve(task.experiment, options);
  if (store.Close()) return RunEnd::kFailed;
  return result.ending == Ending::kFinished  ? RunEnd::kFinished
         : result.ending == Ending::kStopped ? RunEnd::kStopped
                                             : RunEnd::kFailed;
}

}  // namespace plsc::test
