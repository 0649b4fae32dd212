#pragma once

// The name by which docs/library.md of 0.1.0 has it, kept for programs that
// include it; it stands in runtime/develop/.

#include "runtime/develop/develop.h"
