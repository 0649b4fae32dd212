#pragma once

// A command as it was typed: what its options filled, and what does it. Each
// is a struct of its own, declared with its options (Add) and its function
// (Run) in the headers beside; registry.h says how one joins plsc.

#include <any>
#include <string>
#include <utility>

#include "runtime/cli/files/io.h"

namespace plsc::cli {

template <typename One>
Exit RunOne(const std::any& what, Io& io) {
  return Run(*std::any_cast<One>(&what), io);
}

class Command {
 public:
  template <typename One>
  explicit Command(One what) : what_(std::move(what)), run_(RunOne<One>) {}

  Exit Execute(Io& io) const { return run_(what_, io); }

  /// Null: it is none of these.
  template <typename One>
  const One* As() const {
    return std::any_cast<One>(&what_);
  }

 private:
  std::any what_;
  Exit (*run_)(const std::any&, Io&);
};

/// What the command line already answered: help, version, or a usage error.
struct Answer {
  Exit exit = Exit::kFine;
  std::string out;
  std::string err;
};
Exit Run(const Answer& answer, Io& io);

}  // namespace plsc::cli
