#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>

#include "grammar/shown_line.h"
#include "runtime/cli/arguments/live.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/live/live_server.h"
#include "runtime/cli/running/interrupt.h"
#include "runtime/pages/page.h"
#include "runtime/service/service.h"
#include "runtime/text/version.h"
#include "runtime/workers/worker_count.h"

namespace plsc::cli {

namespace {

Expected<std::unique_ptr<Subject>, Failure> Join(const LiveCommand& command) {
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(command.input, ignored);
  const bool is_run = !is_folder && IsDatabase(command.input);
  if ((is_folder || is_run) && !command.scenario.empty())
    return Failure("--scenario is of genotype files; robots of " +
                   std::string(is_run ? "a run" : "a study") +
                   " live where they were bred");
  if (is_folder) return JoinStudy(command.input);
  if (is_run) return JoinRun(command.input);
  return JoinFile(command.input, command.scenario);
}

Work MakeWork() {
  return [service = std::make_shared<Service>(kVersion)](
             const std::string& request) { return service->Answer(request); };
}

/// Says nothing where there is no browser: the address is printed.
void OpenInBrowser(const std::string& address, Io& io) {
  std::string program = "xdg-open";
  std::string argument = address;
  char* arguments[] = {program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int descriptor : {0, 1, 2})
    posix_spawn_file_actions_addopen(&actions, descriptor, "/dev/null", 2, 0);
  pid_t child = 0;
  if (posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments,
                   environ) != 0)
    io.err << "note: there is no xdg-open here to open the page with\n";
  posix_spawn_file_actions_destroy(&actions);
}

}  // namespace

Exit Run(const LiveCommand& command, Io& io) {
  if (!HasPages())
    return Complain("this plsc was built without npm, and has no pages", io);
  auto subject = Join(command);
  if (!subject) return Complain(subject.error(), io);
  LiveOptions options;
  options.host = command.host;
  options.port = command.port;
  options.asker.lives = WorkerCount(command.jobs.value_or(0));
  const InterruptHandler handler;
  const auto live =
      LiveServer::Begin(options, std::move(*subject), MakeWork,
                        [](const std::string& title, const std::string& data) {
                          return PageHtml(PageKind::kLive, title, data);
                        });
  if (!live) return Complain(live.error(), io);
  const std::string address = (*live)->address();
  if (!(*live)->is_private())
    io.err << fmt::format(
        "warning: other machines can reach {}; whoever learns the address "
        "below can read and write {}, and nothing on the way is encrypted\n",
        Escaped(command.host), Escaped(command.input));
  io.out << address << '\n';
  io.out.flush();
  io.err << fmt::format("serving {}; Ctrl-C ends it\n", Escaped(command.input));
  if (command.open) OpenInBrowser(address, io);
  while (!InterruptHandler::is_interrupted()) {
    (*live)->Step();
    if (command.idle && (*live)->Idle().count() >= *command.idle) break;
  }
  return Exit::kFine;
}

}  // namespace plsc::cli
