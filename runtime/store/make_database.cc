// A new database is made in memory and written as one image, because SQLite
// would make it in place with a journal beside it: a kill would leave half a
// store under its name. Its identity (companions) goes into schema_version, the
// one number of the header that SQLite keeps and does not interpret but for
// changes.

#include "runtime/store/make_database.h"

#include <fmt/format.h>

#include "runtime/store/companions.h"
#include "runtime/store/new_file.h"

namespace plsc {

namespace {}  // namespace

MaybeFailure MakeDatabase(const std::string& path,
                          const std::function<void(Database&)>& fill,
                          const std::function<MaybeFailure(int)>& prepare) {
  Database database;
  if (MaybeFailure failure = database.Open(path, Database::Mode::kMemory))
    return failure;
  {
    Transaction transaction(database);
    fill(database);
    if (MaybeFailure failure = transaction.Commit()) return failure;
  }
  // After the tables, each of which counts it up.
  database.Run(fmt::format("PRAGMA schema_version = {}", DrawIdentity()));
  const std::string image = database.Image();
  if (MaybeFailure failure = database.TakeFailure()) return failure;
  if (MaybeFailure failure = CheckNoCompanions(path)) return failure;
  NewFile file(path);
  if (MaybeFailure failure = file.Write(image)) return failure;
  if (prepare)
    if (MaybeFailure failure = prepare(file.descriptor())) return failure;
  return file.Publish();
}

}  // namespace plsc
