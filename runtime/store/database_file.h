#pragma once

// A database's file and its folder as the system sees them, before SQLite
// opens it: of what is missing there SQLite would say less, or another thing.

#include <string>

#include "grammar/failure.h"

namespace plsc {

/// Absolute, without links; empty if there is no such file.
std::string RealPath(const std::string& path);

/// As the user named the file, unless that is a link: companions are beside
/// what it points to.
std::string PrintablePath(const std::string& path);

/// Without a journal nobody writes, and a reader that did more than read the
/// file would leave files of its own beside it.
bool HasNoJournal(const std::string& path);

/// That it is a file with something in it, and may be read, or written to.
MaybeFailure CheckFile(const std::string& path, bool is_writing);

/// What is needed beside it, for the journal and its index.
MaybeFailure CheckBeside(const std::string& shown, bool is_writing);

}  // namespace plsc
