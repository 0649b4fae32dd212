#pragma once

// The name by which 0.1.0 had it, kept for programs that include it; it stands
// in runtime/life/.

#include "runtime/life/season_json.h"
