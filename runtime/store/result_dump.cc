#include "runtime/store/result_dump.h"

#include <fmt/format.h>

#include "runtime/store/database.h"
#include "runtime/store/schema.h"
#include "runtime/store/verify.h"

namespace plsc {

namespace {

void AppendTable(Database& database, const SchemaItem& table,
                 std::string& text) {
  text += table.name + "\n";
  Statement rows(database, fmt::format("SELECT * FROM {} ORDER BY {}",
                                       table.name, table.order));
  rows.With();
  while (rows.Next()) {
    for (int i = 0; i < rows.columns(); ++i) {
      text += ' ';
      text += rows.TakeBytes();
    }
    text += '\n';
  }
}

}  // namespace

Expected<std::string, Failure> DumpResults(const std::string& path) {
  Database database;
  if (auto failure = database.Open(path, Database::Mode::kRead))
    return *failure;
  if (auto failure = CheckIdentity(database)) return *failure;
  std::string text;
  {
    const Transaction instant(database);
    for (const SchemaItem& item : Schema())
      if (item.kind == SchemaKind::kTable && item.is_result)
        AppendTable(database, item, text);
  }
  if (auto failure = database.TakeFailure()) return *failure;
  return text;
}

}  // namespace plsc
