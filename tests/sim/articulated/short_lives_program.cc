// Prints the final states of short_lives.h, a line each. Of a program that has
// nothing but the simulator without ODE, so that it is built quickly in many
// ways: by CMakeLists.txt here with -O0 and -O2, by .ci/check_bits with all
// compilers and levels.
//
//   short_lives              prints
//   short_lives FILE [N]     compares with what it printed once, the first and
//                            every Nth: status 1 if any differs

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <string>

#include "tests/sim/articulated/short_lives.h"

namespace {

std::string LineOf(const plsc::test::ShortLife& life) {
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016" PRIx64, plsc::test::HashOf(life));
  return life.name + ' ' + hash;
}

}  // namespace

int main(int count, char** arguments) {
  const auto lives = plsc::test::ShortLives();
  if (count < 2) {
    for (const auto& life : lives) std::puts(LineOf(life).c_str());
    return 0;
  }
  std::ifstream file(arguments[1]);
  const int every = count > 2 ? std::atoi(arguments[2]) : 1;
  int different = 0, place = 0;
  for (const auto& life : lives) {
    std::string filed;
    std::getline(file, filed);
    if (place++ % every != 0) continue;
    const std::string line = LineOf(life);
    if (line == filed) continue;
    std::printf("on file: %s\nhere:    %s\n", filed.c_str(), line.c_str());
    ++different;
  }
  return different == 0 ? 0 : 1;
}
