#pragma once

// What all pictures share, so that a module looks alike in each of them.

#include <cstddef>
#include <string_view>

#include "sim/body.h"

namespace plsc {

/// The authors' colours, a little lighter so that black text can be read.
std::string_view ModuleColour(ModuleType type);

/// A fill and the text that can be read on it.
struct InkOn {
  std::string_view fill;
  std::string_view ink;
};
/// For things that are numbered from 0: Okabe and Ito's colours, which the
/// colour-blind tell apart, without black; then again, so also say the number.
InkOn NumberColour(std::size_t number);

}  // namespace plsc
