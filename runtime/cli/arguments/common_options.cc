#include "runtime/cli/arguments/common_options.h"

namespace plsc::cli {

void AddForce(Options& options, bool& force) {
  options.Flag("--force", force,
               "replace files that are left alone otherwise: see \"What an "
               "output replaces\" in docs/formats.md");
}

Option AddOutput(Options& options, std::string& output, bool& force) {
  const Option added = options
                           .Add("-o,--output", output,
                                "file to write (default: standard output)")
                           .ValueName("FILE");
  AddForce(options, force);
  return added;
}

void AddFormat(Options& options, OutputFormat& format, const char* json) {
  options.Choice(
      "--format", format,
      std::string("text for people (default), or json: ") + json,
      {{"text", OutputFormat::kText}, {"json", OutputFormat::kJson}});
}

void AddColor(Options& options, ColorChoice& color) {
  options.Choice("--color", color,
                 "auto (default): on a terminal, unless NO_COLOR is set",
                 {{"auto", ColorChoice::kAuto},
                  {"always", ColorChoice::kAlways},
                  {"never", ColorChoice::kNever}});
}

void AddJobs(Options& options, std::optional<int>& jobs, const char* help) {
  options.Add("--jobs", jobs, help).Range(0, 1024).ValueName("N");
}

void AddRobot(Options& options, std::string& individual) {
  options.Add("ROBOT", individual, "which robot of the run: a number, or best")
      .ValueName("ROBOT");
}

Option AddEngine(Options& options, std::optional<EngineKind>& engine,
                 const char* help) {
  return options.Choice(
      "--engine", engine,
      "what moves the robots in all seasons, as if each "
      "said so (default: what the scenario says, else "
      "ode)" +
          std::string(help),
      {{"ode", EngineKind::kOde}, {"articulated", EngineKind::kArticulated}});
}

void AddAllowRange(Options& options, bool& allow_range) {
  options.Flag("--allow-range", allow_range,
               "arguments outside their range are warnings, not errors");
}

}  // namespace plsc::cli
