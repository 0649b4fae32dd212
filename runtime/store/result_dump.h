#pragma once

// All result tables of a run as text, to be compared: equal texts are equal
// runs, bit for bit. What depends on the clock or the machine (the table
// `session`) is left out.

#include <string>

#include "grammar/expected.h"
#include "grammar/failure.h"

namespace plsc {

/// A line a row, tables and rows in a fixed order, doubles in hexadecimal.
/// Works on unfinished runs and while another process writes.
Expected<std::string, Failure> DumpResults(const std::string& path);

}  // namespace plsc
