// sim/maths once more, in a namespace of its own, with the options that
// CMakeLists.txt gives this file.

#define plsc plsc_unoptimised

#include "tests/sim/maths/all_maths.h"
