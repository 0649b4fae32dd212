#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "runtime/cli/files/io.h"
#include "runtime/cli/run.h"

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  // A file that may grow no more (ulimit -f) is a full disk, which is told.
  ::signal(SIGXFSZ, SIG_IGN);
  const bool is_terminal = ::isatty(2) != 0;
  plsc::cli::Io io{std::cin, std::cout, std::cerr, is_terminal,
                   plsc::cli::WantsColor(is_terminal, std::getenv("NO_COLOR"))};
  io.input_descriptor = 0;
  io.out_in_color =
      plsc::cli::WantsColor(::isatty(1) != 0, std::getenv("NO_COLOR"));
  struct winsize window {};
  if (::ioctl(1, TIOCGWINSZ, &window) == 0 && window.ws_col > 0)
    io.out_columns = window.ws_col;
  const auto exit = plsc::cli::Main({argv + 1, argv + argc}, io);
  std::cout.flush();
  if (!std::cout) {
    // A full disk or a closed pipe behind `plsc ... > file`.
    std::cerr << "plsc: cannot write to standard output\n";
    return static_cast<int>(plsc::cli::Exit::kBadInput);
  }
  return static_cast<int>(exit);
}
