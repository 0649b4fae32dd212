#pragma once

// The commands of plsc. One joins by a line of the list in registry.cc;
// parsing, help, completion scripts, manual pages and the description of the
// command line all begin with that list, and no other has to be told.

#include <memory>
#include <utility>
#include <vector>

#include "runtime/cli/arguments/command.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

/// A command's place in the parser, and what is typed, once that is parsed.
struct Declared {
  const CLI::App* app = nullptr;
  Command command;
};

/// How a command declares itself: a struct for what is typed, and beside it
/// Add(Options&, One&) and Run(const One&, Io&).
using Declare = Declared (*)(CLI::App& parent);

template <typename One>
Declared DeclareOne(CLI::App& parent) {
  auto one = std::make_unique<One>();
  Options options(parent);
  Add(options, *one);
  return {&options.app(), Command(std::move(one))};
}

using Registry = std::vector<Declare>;

/// All, in the order of help.
const Registry& Commands();

}  // namespace plsc::cli
