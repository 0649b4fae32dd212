#include "runtime/cli/arguments/live.h"

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

void Add(Options& options, LiveCommand& command) {
  options.Command("live",
                  "Write a robot and watch it walk, in a browser beside you");
  options
      .Add("INPUT", command.input,
           "a genotype file, to edit; the store of a run, also while it goes "
           "on, or a study's folder, to follow")
      .Required();
  options
      .Add("--scenario", command.scenario,
           "YAML file with the seasons and the physics for a genotype file "
           "(default: the paper's, 50 s Flat then 50 s Tilted)")
      .ValueName("FILE");
  options
      .Add("--port", command.port,
           "of this machine to listen at (default: one that is free)")
      .Range(0, 65535)
      .ValueName("N");
  options
      .Add("--host", command.host,
           "address to listen at, as a number (default: 127.0.0.1, which only "
           "this machine can reach)")
      .ValueName("ADDRESS");
  AddJobs(options, command.jobs,
          "processes that live robots (0 and default: one a core that may be "
          "used)");
  options
      .Add("--idle", command.idle,
           "ends when no page has been open for so long (default: at Ctrl-C)")
      .NotNegative()
      .ValueName("SECONDS");
  options.Flag("--open", command.open, "opens the page in your browser");
  options.Footer(
      "Prints an address and serves its page until Ctrl-C: an editor with what "
      "is wrong\nand what can be written, the robot in every environment, its "
      "lives in 3-D. What\nyou change there lives again at once and is saved "
      "to the file; what another editor\nsaves is in the page a blink later. "
      "Where both were changed the page shows both\nand asks. Of a run it "
      "shows how it goes, the best robots of each generation and\nwhom they "
      "come from.\n\n"
      "The address has a token: whoever has it can read and write the file. "
      "Nobody else\nis answered, and no other machine while --host is not "
      "given.\n\n"
      "  plsc live gecko.pls --open\n"
      "  plsc live gecko.pls --scenario examples/life.yaml --port 8000\n"
      "  plsc live run1.sqlite\n"
      "  plsc live paper");
}

}  // namespace plsc::cli
