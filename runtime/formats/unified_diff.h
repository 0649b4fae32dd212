#pragma once

// The difference of two texts as `diff -u` prints it. Our own because Debian
// has no small C++ library for it: libgit2 is a whole version control system,
// and dtl, which other projects copy into their tree, is not packaged. The
// algorithm is Myers' "An O(ND) difference algorithm and its variations"
// (1986), the basic one, on lines.

#include <string>
#include <string_view>

namespace plsc {

/// Empty when the texts are equal. `old_name` and `new_name` head it. Ends of
/// lines are not shown otherwise than as they are; a text without one at its
/// end gets the usual remark.
std::string UnifiedDiff(std::string_view old_text, std::string_view new_text,
                        std::string_view old_name, std::string_view new_name);

}  // namespace plsc
