#include "grammar/foreign_file.h"

#include <catch2/catch.hpp>

#include "grammar/screen.h"

namespace plsc {
namespace {

TEST_CASE("Genotypes of Revolve are recognised, those of plsc are not",
          "[foreign_file]") {
  struct Row {
    const char* why;
    const char* text;
    bool is_foreign;
  };
  const std::vector<Row> rows = {
      {"the one line of Python that it exports",
       "{<Alphabet.CORE_COMPONENT: 'C'>: [[<Alphabet.CORE_COMPONENT: 'C'>, "
       "[]]]}",
       true},
      {"with clauses", "{<Alphabet.BLOCK: 'B'>: [[[['hill', '==', True]], []]]",
       true},
      {"its lines of tokens", "C C brainmoveTTS_1|2 addf AJ1_0.5|2|3|4\n",
       true},
      {"a joint's rule first", "\n AJ2 AJ2_1|1|1|1 movef\nB B addl ST_0.1\n",
       true},
      {"a genotype", "plsc 1\nalphabet plasticoding 1\n", false},
      {"a genotype without its version", "alphabet plasticoding 1\n", false},
      {"one that uses a word of Revolve's", "rule C -> { C addf B }\n", false},
      {"a rule without keyword", "C -> { C add_front B }\n", false},
      {"Revolve's words in a comment", "# C C addf B\nplsc 1\n", false},
      {"a Python text in a comment", "plsc 1 # <Alphabet.BLOCK: 'B'>\n", false},
      {"nothing", "", false},
      {"a brace", "{", false},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const auto found = DescribeForeignFile(row.text);
      REQUIRE(found.has_value() == row.is_foreign);
      if (!found) continue;
      CHECK(found->code == Code::kAuthorsGenotype);
      CHECK(found->message.find("Revolve") != std::string::npos);
      CHECK(Screen(Source("a", row.text))->code == Code::kAuthorsGenotype);
    }
  }
}

}  // namespace
}  // namespace plsc
