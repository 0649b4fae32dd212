#pragma once

// The name by which docs/library.md of 0.1.0 has it, kept for programs that
// include it; both stand in runtime/life/.

#include "runtime/life/evaluation.h"
#include "runtime/life/life.h"
