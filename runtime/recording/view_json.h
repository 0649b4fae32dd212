#pragma once

// What the page of `plsc view` shows (runtime/pages/src/view): recordings as
// their files have them, each with where it came from and its seasons' relief.

#include <string>
#include <vector>

#include "runtime/recording/recording.h"

namespace plsc {

struct ViewedLife {
  std::string source;  ///< "gecko.rec.json", "run1.sqlite, robot 17"
  std::string remark;  ///< what to keep in mind when looking; may be empty
  Recording recording;
};

/// An object, see docs/formats.md.
std::string ViewJson(const std::vector<ViewedLife>& lives);

}  // namespace plsc
