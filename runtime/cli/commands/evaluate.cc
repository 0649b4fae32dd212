// Two things to wait for, lines and answers, in one thread: the pool's wait
// also ends when a line comes (WakeOn), and lines are taken only while there is
// room, so that an asker who sends a million genotypes is held up by its own
// pipe and not by our memory. Every line gets exactly one answer, also one that
// cannot be read; with --in-order answers wait for those before them.

#include <fmt/format.h>

#include <cassert>
#include <map>
#include <ostream>
#include <utility>

#include "compiler/compile.h"
#include "compiler/print.h"
#include "grammar/shown_line.h"
#include "runtime/cli/arguments/evaluate.h"
#include "runtime/cli/commands/ask_tell.h"
#include "runtime/cli/files/line_reader.h"
#include "runtime/cli/files/load_yaml.h"
#include "runtime/cli/running/interrupt.h"
#include "runtime/evolve/worker_request.h"
#include "runtime/life/evaluation.h"
#include "runtime/workers/worker_count.h"
#include "runtime/workers/worker_pool.h"

namespace plsc::cli {

namespace {

// Genotypes a worker that are read ahead: enough that none of them waits, few
// enough that memory does not grow with what the asker has to send.
constexpr int kReadAhead = 64;

// ms between two looks at whether Ctrl-C was pressed, which also ends a wait.
constexpr int kLongestWait = 1000;

/// What workers do: "ID\nGENOTYPE" to the line that answers it.
Work EvaluationWork(const Scenario& scenario) {
  return [scenario](const std::string& request) {
    const std::size_t end = request.find('\n');
    CompileOptions options;
    options.allow_out_of_range = true;  // the parent knows what may pass
    const Result<Program> program =
        Compile(Source("<worker>", request.substr(end + 1)), options);
    assert(program);
    return EvaluationAnswer(request.substr(0, end), program->genotype,
                            Evaluate(program->genotype, scenario));
  };
}

double LongestEvaluation(const Scenario& scenario) {
  Experiment experiment;
  experiment.scenario = scenario;
  return HangSeconds(experiment);
}

/// A line of the asker: what a worker is given, or the answer to what is wrong.
struct Examined {
  std::string id = "null";
  std::string request;
  std::string failure;
};

Examined ExamineLine(const InputLine& line, const Scenario& scenario,
                     const CompileOptions& options) {
  Examined examined;
  const auto fail = [&](const auto&... problem) {
    examined.failure = FailureAnswer(examined.id, line.number, problem...);
    return examined;
  };
  if (line.is_cut) return fail("the line is over 16 MiB");
  const Source source(fmt::format("<stdin line {}>", line.number), line.text);
  const Result<EvaluationRequest> request = ParseEvaluationRequest(source);
  examined.id = request ? request->id : IdOfRequest(line.text);
  if (!request) return fail(request.diagnostics(), source);
  const Source text("<genotype>", request->genotype);
  const Result<Program> program = Compile(text, options);
  if (!program) return fail(program.diagnostics(), text);
  const Genotype& genotype = program->genotype;
  if (!genotype.alphabet->is_built_in())
    return fail(fmt::format("alphabet '{}' has no bodies to simulate",
                            genotype.alphabet->name()));
  const auto unknown = CheckSenses(scenario, genotype.states);
  if (!unknown.empty()) return fail(unknown, text);
  examined.request = examined.id + '\n' + Print(genotype);
  return examined;
}

/// Gives genotypes to workers and prints the answers.
class LinesEvaluation {
 public:
  LinesEvaluation(const EvaluateCommand& command, const Scenario& scenario,
                  Io& io)
      : command_(command),
        scenario_(scenario),
        io_(io),
        lines_(io),
        pool_({WorkerCount(command.jobs.value_or(0)),
               LongestEvaluation(scenario)},
              EvaluationWork(scenario)) {
    pool_.WakeOn(io.input_descriptor);
  }

  Exit Run() {
    while (!InterruptHandler::is_interrupted() && !pool_.failure() && io_.out) {
      while (has_room() && lines_.has_line()) Take(*lines_.Next());
      if (lines_.is_at_end() && pool_.outstanding() == 0) break;
      // Whichever of the two has something to wait for, waits; WakeOn lets the
      // workers' wait end when a line comes.
      const bool wants_lines = has_room() && !lines_.is_at_end();
      if (wants_lines)
        lines_.Fill(pool_.outstanding() == 0 ? kLongestWait : 0);
      else
        pool_.WakeOn(-1);
      const bool can_take = has_room() && lines_.has_line();
      for (const Reply& reply : pool_.Wait(can_take ? 0 : kLongestWait))
        Report(reply);
      if (!lines_.is_at_end()) pool_.WakeOn(io_.input_descriptor);
    }
    return Status();
  }

 private:
  struct Asked {
    std::size_t line = 0;
    std::string id;
  };

  bool has_room() const {
    return pool_.outstanding() < kReadAhead * pool_.workers();
  }

  void Take(const InputLine& line) {
    if (line.text.find_first_not_of(" \t\r") == std::string::npos) return;
    CompileOptions options;
    options.allow_out_of_range = command_.allow_range;
    Examined examined = ExamineLine(line, scenario_, options);
    const int ticket = next_++;
    if (!examined.failure.empty()) {
      ++failed_;
      return Print(ticket, examined.failure);
    }
    pool_.Submit(ticket, std::move(examined.request));
    asked_[ticket] = {line.number, std::move(examined.id)};
  }

  void Report(const Reply& reply) {
    const Asked asked = std::move(asked_.extract(reply.ticket).mapped());
    if (reply.answer) return Print(reply.ticket, *reply.answer);
    ++failed_;
    Print(reply.ticket,
          FailureAnswer(asked.id, asked.line,
                        "the simulation broke down, twice: " + reply.death));
  }

  void Print(int ticket, const std::string& answer) {
    if (!command_.in_order) {
      io_.out << answer << '\n';
    } else {
      early_[ticket] = answer;
      for (; early_.contains(printed_); ++printed_)
        io_.out << early_.extract(printed_).mapped() << '\n';
    }
    io_.out.flush();  // the asker waits for it
  }

  Exit Status() {
    if (InterruptHandler::is_interrupted()) return Exit::kInterrupted;
    if (pool_.failure()) {
      io_.err << fmt::format("error: {}\n", Escaped(*pool_.failure()));
      return Exit::kBadInput;
    }
    return failed_ == 0 ? Exit::kFine : Exit::kBadInput;
  }

  const EvaluateCommand& command_;
  const Scenario& scenario_;
  Io& io_;
  LineReader lines_;
  WorkerPool pool_;
  int next_ = 0;                // ticket
  std::map<int, Asked> asked_;  // by ticket; those with the workers
  // Of in_order: who is answered next, and answers that wait for others.
  int printed_ = 0;
  std::map<int, std::string> early_;
  std::size_t failed_ = 0;
};

}  // namespace

Exit Run(const EvaluateCommand& command, Io& io) {
  auto scenario = LoadScenario(command.scenario, io);
  if (!scenario || !UseEngine(command.engine, *scenario, io))
    return Exit::kBadInput;
  const InterruptHandler handler;
  return LinesEvaluation(command, *scenario, io).Run();
}

}  // namespace plsc::cli
