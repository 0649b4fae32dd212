#include <unistd.h>

#include <iostream>

#include "runtime/cli/commands.h"

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  plsc::cli::Io io{std::cin, std::cout, std::cerr, ::isatty(2) != 0};
  const auto exit = plsc::cli::Main({argv + 1, argv + argc}, io);
  std::cout.flush();
  if (!std::cout) {
    // A full disk or a closed pipe behind `plsc ... > file`.
    std::cerr << "plsc: cannot write to standard output\n";
    return static_cast<int>(plsc::cli::Exit::kBadInput);
  }
  return static_cast<int>(exit);
}
