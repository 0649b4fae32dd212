#include "runtime/store/schema_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace plsc {

namespace {

const char* WordOf(SchemaKind kind) {
  switch (kind) {
    case SchemaKind::kTable:
      return "table";
    case SchemaKind::kIndex:
      return "index";
    case SchemaKind::kView:
      return "view";
  }
  return "";
}

}  // namespace

MaybeFailure CheckNothingAdded(Database& database,
                               const std::vector<SchemaItem>& known) {
  Statement objects(database, "SELECT type, name, sql FROM sqlite_master");
  objects.With();
  while (objects.Next()) {
    const std::string type = objects.TakeText();
    const std::string name = objects.TakeText();
    const bool has_text = !objects.IsNull();
    const std::string sql = objects.TakeText();
    // An index of a UNIQUE, and what ANALYZE finds out.
    if (!has_text && type == "index" && name.starts_with("sqlite_autoindex_"))
      continue;
    if (type == "table" && name.starts_with("sqlite_stat")) continue;
    const bool is_known =
        std::any_of(known.begin(), known.end(), [&](const SchemaItem& item) {
          return type == WordOf(item.kind) && name == item.name &&
                 sql == item.sql;
        });
    if (is_known) continue;
    objects.With();
    return fmt::format(
        "'{}' has {} {} '{}', which no version of plsc made: nothing is "
        "written "
        "to it as long as that is there (sqlite3 '{}' 'DROP {} \"{}\"')",
        database.path(), type == "index" ? "an" : "a", type, name,
        database.path(), type, name);
  }
  return database.TakeFailure();
}

}  // namespace plsc
