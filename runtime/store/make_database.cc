#include "runtime/store/make_database.h"

#include <fmt/format.h>

#include "runtime/store/companions.h"
#include "runtime/store/new_file.h"

namespace plsc {

namespace {

using Failure = std::optional<std::string>;

}  // namespace

Failure MakeDatabase(const std::string& path,
                     const std::function<void(Database&)>& fill,
                     const std::function<Failure(int)>& prepare) {
  Database database;
  if (Failure failure = database.Open(path, Database::Mode::kMemory))
    return failure;
  {
    Transaction transaction(database);
    fill(database);
    if (Failure failure = transaction.Commit()) return failure;
  }
  // After the tables, each of which counts it up.
  database.Run(fmt::format("PRAGMA schema_version = {}", DrawIdentity()));
  const std::string image = database.Image();
  if (Failure failure = database.TakeFailure()) return failure;
  if (Failure failure = CheckNoCompanions(path)) return failure;
  NewFile file(path);
  if (Failure failure = file.Write(image)) return failure;
  if (prepare)
    if (Failure failure = prepare(file.descriptor())) return failure;
  return file.Publish();
}

}  // namespace plsc
