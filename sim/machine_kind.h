#pragma once

// What bits depend on besides our own code: libm picks variants of its
// functions by the processor (fused multiply-add or not), which differ in last
// bits. So their very results tell the kind of machine, and ODE's version the
// rest.

#include <string>

namespace plsc {

/// "x86_64 ode 0.16.2 libm 00ff...": machines of the same kind simulate the
/// same bits with the same program.
std::string MachineKind();

}  // namespace plsc
