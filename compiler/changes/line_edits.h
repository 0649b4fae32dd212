#pragma once

// How one text became another, line by line: the shortest script, by Myers'
// "An O(ND) difference algorithm and its variations" (1986), the basic one.
// docs/dependencies.md says why it is not a library's.

#include <string_view>
#include <vector>

namespace plsc {

using Lines = std::vector<std::string_view>;

/// With their ends, so that "a\r\n" and "a\n" differ.
Lines SplitLines(std::string_view text);

/// One line of the script: in the old text, in the new one, or in both.
enum class LineEdit : char { kKeep = ' ', kDelete = '-', kInsert = '+' };

/// Of texts with very many differences, everything between their equal
/// beginnings and ends counts as changed: right, only longer.
std::vector<LineEdit> FindLineEdits(const Lines& from, const Lines& to);

}  // namespace plsc
