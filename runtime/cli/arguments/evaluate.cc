#include "runtime/cli/arguments/evaluate.h"

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

void Add(Options& options, EvaluateCommand& command) {
  options.Command("evaluate",
                  "Evaluate genotypes for an optimiser in another program");
  options
      .Flag("--stdin", command.is_stdin,
            "read genotypes from standard input, a JSON object a line")
      .Required();
  options
      .Add("--scenario", command.scenario,
           "YAML file with the seasons and the physics (default: the "
           "paper's, 50 s Flat then 50 s Tilted by 5 degrees)")
      .ValueName("FILE");
  AddEngine(options, command.engine);
  AddJobs(options, command.jobs,
          "worker processes (0 and default: one a core that may be "
          "used); changes no answer");
  options.Flag("--in-order", command.in_order,
               "answer in the order of the requests instead of as they finish");
  options.Flag("--allow-range", command.allow_range,
               "arguments outside their range are warnings");
  options.Footer(
      "A request is a line such as\n\n"
      "  {\"id\": 7, \"genotype\": \"plsc 1\\ngenotype ...\"}\n\n"
      "and is answered, when its seasons are lived, by a line\n\n"
      "  {\"id\": 7, \"fitness\": {\"flat\": 0.027, \"tilted\": null}, "
      "\"seasons\": [...]}\n\n"
      "Fitness in m/s (null: the robot did not complete that season); a season "
      "is what\n`plsc simulate --format json` prints, with all descriptors. "
      "What is wrong with a\nrequest is its answer, and the others go on:\n\n"
      "  {\"id\": 7, \"line\": 3, \"error\": \"...\", \"diagnostics\": "
      "[...]}\n\n"
      "Write as many requests as you like before you read; several are worked "
      "on at\nonce. The end of the input ends the command. Exit status 1: some "
      "request was wrong.\ndocs/optimisers.md has more, and examples/"
      "one_plus_one.py is a whole search.\n\n"
      "  plsc evaluate --stdin < requests.jsonl > answers.jsonl\n"
      "  plsc evaluate --stdin --scenario hot.yaml --jobs 4");
}

}  // namespace plsc::cli
