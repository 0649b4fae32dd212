#pragma once

// All result tables of a run as text, to be compared: equal texts are equal
// runs, bit for bit. What depends on the clock or the machine (the table
// `session`) is left out.

#include <string>

#include "runtime/store/loaded.h"

namespace plsc {

/// A line a row, tables and rows in a fixed order, doubles in hexadecimal.
/// Works on unfinished runs and while another process writes.
Loaded<std::string> DumpResults(const std::string& path);

}  // namespace plsc
