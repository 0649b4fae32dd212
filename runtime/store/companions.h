#pragma once

// What SQLite keeps beside a database, by name alone: FILE-journal, FILE-wal
// and FILE-shm. It would play back any journal of that name into the database,
// cut or delete it, and follow a link. So whatever lies there must be known to
// be the database's own before SQLite opens it.

#include <cstdint>
#include <string>

#include "grammar/failure.h"

namespace plsc {

/// What is wrong beside the database that is at `path`, naming the file; or
/// nothing. Opens and closes the database's file: not for one to which this
/// process has a connection, whose locks that would drop (as POSIX has it).
MaybeFailure CheckCompanions(const std::string& path);

/// Likewise of a database that is to be made: there may be none.
MaybeFailure CheckNoCompanions(const std::string& path);

/// A database's own number, by which its journal is known: what SQLite calls
/// the schema version, chosen by chance when the database is made. Never 0.
std::int32_t DrawIdentity();

}  // namespace plsc
