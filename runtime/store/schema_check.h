#pragma once

// Whether a database's schema is one of ours to the last object: a trigger that
// somebody added would run with every row that is written.

#include <string>
#include <vector>

#include "grammar/failure.h"
#include "runtime/store/database.h"
#include "runtime/store/schema.h"

namespace plsc {

/// That nothing is in the schema but `known`, by kind, name and text, and what
/// SQLite makes by itself; else the first object that is, by its name.
MaybeFailure CheckNothingAdded(Database& database,
                               const std::vector<SchemaItem>& known);

}  // namespace plsc
