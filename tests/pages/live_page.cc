// The page of a robot that is edited, of data on standard input: what commands
// write and servers serve, for tests that open it.

#include <iostream>
#include <iterator>
#include <string>

#include "runtime/pages/page.h"

int main() {
  const std::string json(std::istreambuf_iterator<char>(std::cin), {});
  std::cout << plsc::PageHtml(plsc::PageKind::kLive, "robot", json);
}
