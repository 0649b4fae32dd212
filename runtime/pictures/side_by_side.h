#pragma once

// Blocks of text beside each other, as a terminal shows them.

#include <string>
#include <vector>

namespace plsc {

/// Blocks in rows: as many beside each other as fit into `columns` characters,
/// at least one; a blank line between rows. Every character is as wide as any
/// other. Lines end in a newline and carry no trailing blanks.
std::string SideBySide(const std::vector<std::string>& blocks,
                       std::size_t columns);

}  // namespace plsc
