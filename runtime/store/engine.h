#pragma once

// Which program simulated something. Neither the version says it, which stays
// the same while the program is worked on, nor the file of the process
// (/proc/self/exe), which may be a loader, or an interpreter that plsc is a
// module of. So it is a hash of what all of these are linked with: the objects
// on the way of a life, taken when plsc is built (engine_id.cmake).

#include <string>
#include <string_view>

namespace plsc {

/// Hexadecimal digits, other ones where any of the objects differs.
std::string_view EngineId();

/// What simulations are a function of besides their keys: EngineId() and, where
/// ODE lives any, the kind of the machine. Others' simulations are not found in
/// caches.
std::string ThisEngine(bool uses_ode = true);

}  // namespace plsc
