#pragma once

// The text of a file without the pieces that trimming leaves out. Lines of
// which nothing stays go, and so do comments right above a rule that goes;
// all else stays as it was written.

#include <span>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "runtime/advice/trim_pieces.h"

namespace plsc {

std::string KeepText(const Source& source,
                     std::span<const MappedProgram> programs,
                     const Pieces& pieces, const Kept& kept);

}  // namespace plsc
