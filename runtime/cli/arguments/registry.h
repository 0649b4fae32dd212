#pragma once

// The commands of plsc. One joins by a line of the list in registry.cc;
// parsing, help, completion scripts, manual pages and the description of the
// command line all begin with that list, and no other has to be told.

#include <functional>
#include <memory>
#include <vector>

#include "runtime/cli/arguments/command.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

/// A command's place in the parser.
struct Declared {
  const CLI::App* app = nullptr;
  std::function<Command()> command;  ///< what was typed, once that is parsed
};

/// How a command declares itself: a struct for what is typed, and beside it
/// Add(Options&, One&) and Run(const One&, Io&).
using Declare = Declared (*)(CLI::App& parent);

template <typename One>
Declared DeclareOne(CLI::App& parent) {
  const auto command = std::make_shared<One>();
  Options options(parent);
  Add(options, *command);
  return {&options.app(), [command] { return Command(*command); }};
}

using Registry = std::vector<Declare>;

/// All, in the order of help.
const Registry& Commands();

}  // namespace plsc::cli
