#pragma once

// The difference of two texts as `diff -u` prints it.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace plsc {

/// Empty when the texts are equal. `old_name` and `new_name` head it. Ends of
/// lines are not shown otherwise than as they are; a text without one at its
/// end gets the usual remark.
std::string UnifiedDiff(std::string_view old_text, std::string_view new_text,
                        std::string_view old_name, std::string_view new_name);

/// Neighbouring lines of a text that became others, or that came between two.
struct ChangedLines {
  std::size_t first_line = 0;  ///< of the old text, from 0
  std::size_t end_line = 0;    ///< behind the last one
  std::size_t begin = 0;       ///< their bytes
  std::size_t end = 0;
  std::string replacement;  ///< with the ends of its lines
};

/// The changes that UnifiedDiff prints, in order.
std::vector<ChangedLines> LineChanges(std::string_view old_text,
                                      std::string_view new_text);

}  // namespace plsc
