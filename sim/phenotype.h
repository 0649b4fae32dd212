#pragma once

// A robot as developed for one environment.

#include "sim/body.h"
#include "sim/brain.h"

namespace plsc {

struct Phenotype {
  Body body;
  Brain brain;

  friend bool operator==(const Phenotype&, const Phenotype&) = default;
};

}  // namespace plsc
