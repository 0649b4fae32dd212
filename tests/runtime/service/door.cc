// A request a line on standard input, an answer a line on standard output:
// Service for whoever has no page (runtime/service; docs/service.md).

#include <iostream>
#include <string>

#include "runtime/service/service.h"
#include "runtime/text/version.h"

int main() {
  std::ios::sync_with_stdio(false);
  plsc::Service service(plsc::kVersion);
  for (std::string line; std::getline(std::cin, line);)
    std::cout << service.Answer(line) << '\n' << std::flush;
}
