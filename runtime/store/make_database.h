#pragma once

// A new database: made in memory, so that SQLite needs no file beside it, and
// given its name when it is whole.

#include <functional>
#include <string>

#include "grammar/failure.h"
#include "runtime/store/database.h"

namespace plsc {

/// Of what `fill` writes, in WAL mode, under a name that nothing has yet, and
/// beside which there is nothing that SQLite would take for its own. What went
/// wrong, or nothing; then nothing was made. `prepare`, if given, gets the
/// file's descriptor before the file has its name.
MaybeFailure MakeDatabase(
    const std::string& path, const std::function<void(Database&)>& fill,
    const std::function<MaybeFailure(int)>& prepare = nullptr);

}  // namespace plsc
