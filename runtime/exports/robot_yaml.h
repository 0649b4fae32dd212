#pragma once

// A robot as the authors' program writes and loads it (Revolve at ae99a098:
// revolve_module.py:112-147, revolve_bot.py:165-177, brain_nn.py:53-99): the
// tree of modules and the network. Masses and shapes are that program's own;
// the two joints are told apart by orientation and colour alone, and the
// symbols' own weights are not in it.

#include <string>

namespace plsc {

struct RobotModel;

std::string RobotYaml(const RobotModel& model);

/// As Python's YAML reads it back: always with a point, so that no number is
/// an integer and none with an exponent a text.
std::string YamlFloat(double number);

}  // namespace plsc
