#include <catch2/catch.hpp>

#include "runtime/authors/genotype.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

TEST_CASE("A genotype is written as Revolve writes it", "[authors_text]") {
  // Letters C, AJ1, AJ2, B, ST; numbers as Python has them.
  CHECK(*AuthorsGenotypeText(test::Robot(
            "rule C -> { C add_left A1(0.5, 4, 2, 3) move_ref_I(1, 2)\n"
            "mutate_per(0.00001) }")) ==
        "{<Alphabet.CORE_COMPONENT: 'C'>: [[<Alphabet.CORE_COMPONENT: 'C'>, "
        "[]], [<Alphabet.ADD_LEFT: 'addl'>, []], [<Alphabet.JOINT_VERTICAL: "
        "'AJ2'>, [0.5, 2.0, 3.0, 4.0]], [<Alphabet.MOVE_REF_S: "
        "'brainmoveFTS'>, [1, 2]], [<Alphabet.MUTATE_PER: "
        "'brainperperturb'>, [1e-05]]], <Alphabet.JOINT_HORIZONTAL: 'AJ1'>: "
        "[], <Alphabet.JOINT_VERTICAL: 'AJ2'>: [], <Alphabet.BLOCK: 'B'>: [], "
        "<Alphabet.SENSOR: 'ST'>: []}");
  CHECK(AuthorsGenotypeText(
            test::Robot("sense hill: bool\nrule B -> if hill = False and hill "
                        "!= True then { B }"))
            ->find("<Alphabet.BLOCK: 'B'>: [[[['hill', '==', False], ['and'], "
                   "['hill', '!=', True]], [[<Alphabet.BLOCK: 'B'>, []]]]]") !=
        std::string::npos);
}

}  // namespace
}  // namespace plsc
