#pragma once

// A command as it was typed: what its options filled, and what does it. Each
// is a struct of its own, declared with its options (Add) and its function
// (Run) in the headers beside; registry.h says how one joins plsc.

#include <memory>
#include <string>
#include <typeinfo>

#include "runtime/cli/files/io.h"

namespace plsc::cli {

template <typename One>
Exit RunOne(const void* what, Io& io) {
  return Run(*static_cast<const One*>(what), io);
}

template <typename One>
void DeleteOne(const void* what) {
  delete static_cast<const One*>(what);
}

/// Pointers to functions, not std::function or std::any: there are as many
/// commands as there are instances of what this is made of.
class Command {
 public:
  template <typename One>
  explicit Command(std::unique_ptr<One> one)
      : what_(one.release(), DeleteOne<One>),
        type_(&typeid(One)),
        run_(RunOne<One>) {}

  Exit Execute(Io& io) const { return run_(what_.get(), io); }

  /// Null: it is none of these.
  template <typename One>
  const One* As() const {
    return *type_ == typeid(One) ? static_cast<const One*>(what_.get())
                                 : nullptr;
  }

 private:
  std::shared_ptr<const void> what_;
  const std::type_info* type_;
  Exit (*run_)(const void*, Io&);
};

/// What the command line already answered: help, version, or a usage error.
struct Answer {
  Exit exit = Exit::kFine;
  std::string out;
  std::string err;
};
Exit Run(const Answer& answer, Io& io);

}  // namespace plsc::cli
