#include "compiler/foreign_names.h"

#include <fmt/format.h>

#include <array>

namespace plsc {

namespace {

struct Row {
  std::string_view revolve;
  std::string_view table_one;
};

// Tokens of Revolve at the commit that the paper cites, and Table 1's names.
constexpr std::array<Row, 18> kRows = {{
    {"AJ1", "A2"},
    {"AJ2", "A1"},
    {"ST", "T"},
    {"addr", "add_right"},
    {"addf", "add_front"},
    {"addl", "add_left"},
    {"mover", "move_right"},
    {"movef", "move_front"},
    {"movel", "move_left"},
    {"moveb", "move_back"},
    {"brainmoveFTS", "move_ref_I"},
    {"brainmoveTTS", "move_ref_N"},
    {"brainedge", "add_edge"},
    {"brainperturb", "mutate_edge"},
    {"brainloop", "loop"},
    {"brainampperturb", "mutate_amp"},
    {"brainperperturb", "mutate_per"},
    {"brainoffperturb", "mutate_off"},
}};

}  // namespace

std::string_view PlasticodingNameFor(std::string_view revolve) {
  for (const Row& row : kRows)
    if (row.revolve == revolve) return row.table_one;
  return {};
}

std::string ForeignNote(std::string_view revolve) {
  if (revolve == "AJ1")
    return "AJ1 is Revolve's horizontal joint; the paper's name for it is A2 "
           "(not A1), and its parameters are ordered w, a, p, o";
  if (revolve == "AJ2")
    return "AJ2 is Revolve's vertical joint; the paper's name for it is A1 "
           "(not A2), and its parameters are ordered w, a, p, o";
  return fmt::format("{} is Revolve's word; the paper's is {}", revolve,
                     PlasticodingNameFor(revolve));
}

}  // namespace plsc
