// Prints the grammar of plsc as EBNF, or with the name of a document puts it
// there: what the target update_ebnf does with docs/language.md.

#include <fstream>
#include <iostream>
#include <sstream>

#include "grammar/language_ebnf.h"

int main(int argc, char** argv) {
  const std::string ebnf = plsc::testing::LanguageEbnf();
  if (argc < 2) {
    std::cout << ebnf;
    return 0;
  }
  std::ostringstream text;
  text << std::ifstream(argv[1]).rdbuf();
  const std::string updated = plsc::testing::WithEbnf(text.str(), ebnf);
  if (updated.empty()) {
    std::cerr << "print_ebnf: " << argv[1] << " has no place for a grammar\n";
    return 1;
  }
  if (updated == text.str()) return 0;
  std::ofstream file(argv[1]);
  file << updated;
  return file.flush() ? 0 : 1;
}
