#pragma once

// The difference of two texts as `diff -u` prints it.

#include <string>
#include <string_view>

namespace plsc {

/// Empty when the texts are equal. `old_name` and `new_name` head it. Ends of
/// lines are not shown otherwise than as they are; a text without one at its
/// end gets the usual remark.
std::string UnifiedDiff(std::string_view old_text, std::string_view new_text,
                        std::string_view old_name, std::string_view new_name);

}  // namespace plsc
