#pragma once

// Tables of text for people.

#include <string>
#include <vector>

namespace plsc {

/// A line a row: columns as wide as their widest cell, two blanks between them,
/// none at a line's end. Rows may differ in length. Cells are ASCII.
std::string AlignedRows(const std::vector<std::vector<std::string>>& rows);

}  // namespace plsc
