// A table from the key of a simulation to what it told, shared by any number of
// runs and processes. A key says nothing of the program, so entries are kept by
// engine, too: what is found was made by the same program on the same kind of
// machine, or it is not found.
//
// No result may depend on it, so nothing that goes wrong here is an error of
// the run: an entry whose checksum is wrong is dropped and simulated anew, a
// file that cannot be used is not used any more, and a warning says so at the
// end. The checksum is of key, engine and value together, so that a value in
// the wrong row is no entry either.

#include "runtime/store/shared_cache.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>
#include <vector>

#include "runtime/evolve/simulated_frame.h"
#include "runtime/life/simulated.h"
#include "runtime/store/make_database.h"
#include "runtime/store/schema_check.h"

namespace plsc {

namespace {

// "plsK" in the file's header: neither a run nor anything else.
constexpr int kApplication = 0x706c734b;
// 2: entries have checksums.
constexpr int kFormat = 2;

// Who waits for another process's transaction waits for milliseconds; half a
// minute is a dead disk.
constexpr const char* kSetUp = R"(
PRAGMA busy_timeout = 30000;
)";

const std::vector<SchemaItem>& Tables() {
  static const std::vector<SchemaItem> tables = {
      {"engine",
       R"(CREATE TABLE engine(
  id INTEGER PRIMARY KEY, text TEXT UNIQUE NOT NULL))",
       SchemaKind::kTable, false, ""},
      {"simulation",
       R"(CREATE TABLE simulation(
  key TEXT NOT NULL, engine INTEGER NOT NULL REFERENCES engine(id),
  value TEXT NOT NULL, checksum INTEGER NOT NULL,
  PRIMARY KEY(key, engine)) WITHOUT ROWID)",
       SchemaKind::kTable, false, ""},
  };
  return tables;
}

void AddTables(Database& database) {
  database.Run(
      fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};",
                  kApplication, kFormat));
  for (const SchemaItem& table : Tables()) database.Run(table.sql);
}

std::string ToHex(const std::string& bytes) {
  std::string text;
  text.reserve(2 * bytes.size());
  for (const char byte : bytes)
    text += fmt::format("{:02x}", static_cast<unsigned char>(byte));
  return text;
}

/// Nothing if it is no such text.
std::optional<std::string> FromHex(const std::string& text) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                  : -1;
  };
  if (text.size() % 2 != 0) return std::nullopt;
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    const int high = digit(text[i]);
    const int low = digit(text[i + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    bytes += static_cast<char>(16 * high + low);
  }
  return bytes;
}

/// Of all that an entry is, its place included: SQLite finds damage to its own
/// structure only, and a wrong number would be somebody's result.
std::int64_t ChecksumOf(const std::string& key, const std::string& engine,
                        const std::string& value) {
  return static_cast<std::int64_t>(
      KeyOf(fmt::format("{}\n{}\n{}", key, engine, value)).low);
}

std::string WrongFormat(const std::string& path, int format) {
  if (format > kFormat)
    return fmt::format(
        "'{}' was made by a newer plsc (its format is {}, this program knows "
        "{}): use that one, or another file",
        path, format, kFormat);
  // Reading them would not help: an entry is found by the very program only
  // that added it.
  return fmt::format(
      "'{}' is a cache of format {}, whose entries have no checksums, so that "
      "damage would go unseen: delete it, or name another file (no run needs "
      "it)",
      path, format);
}

int NumberOf(Database& database, const char* pragma) {
  Statement statement(database, fmt::format("PRAGMA {}", pragma));
  return statement.Next() ? statement.TakeInt() : 0;
}

}  // namespace

struct SharedCache::Statements {
  explicit Statements(Database& database)
      : find(database,
             "SELECT value, checksum FROM simulation "
             "WHERE key = ? AND engine = ?"),
        add(database, "INSERT OR IGNORE INTO simulation VALUES(?, ?, ?, ?)"),
        drop(database, "DELETE FROM simulation WHERE key = ? AND engine = ?") {}
  Statement find;
  Statement add;
  Statement drop;
};

SharedCache::SharedCache() = default;

SharedCache::~SharedCache() {
  statements_.reset();
  database_.Close();
}

MaybeFailure SharedCache::Open(const std::string& path,
                               const std::string& engine) {
  MaybeFailure failure = OpenFile(path, engine);
  if (failure) Discard();
  return failure;
}

MaybeFailure SharedCache::OpenFile(const std::string& path,
                                   const std::string& engine) {
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path, error))) {
    MaybeFailure failure = MakeDatabase(path, AddTables);
    is_new_ = !failure;
    // Another process may have made it meanwhile.
    if (failure && !std::filesystem::exists(path, error)) return failure;
  }
  if (MaybeFailure failure = database_.Open(path, Database::Mode::kWrite))
    return failure;
  const int application = NumberOf(database_, "application_id");
  const int format = NumberOf(database_, "user_version");
  if (MaybeFailure failure = database_.TakeFailure()) return failure;
  if (application != kApplication)
    return fmt::format("'{}' is no cache of plsc", path);
  if (format != kFormat) return WrongFormat(path, format);
  if (MaybeFailure failure = CheckNothingAdded(database_, Tables()))
    return failure;
  database_.Run(kSetUp);
  {
    Transaction transaction(database_);
    Statement(database_, "INSERT OR IGNORE INTO engine(text) VALUES(?)")
        .With(engine)
        .Run();
    Statement number(database_, "SELECT id FROM engine WHERE text = ?");
    if (number.With(engine).Next()) engine_id_ = number.TakeInteger();
    if (MaybeFailure failure = transaction.Commit()) return failure;
  }
  engine_ = engine;
  statements_ = std::make_unique<Statements>(database_);
  return database_.TakeFailure();
}

MaybeFailure SharedCache::warning() const {
  if (damaged_ == 0) return gone_;
  std::string text = fmt::format(
      "{} of the cache '{}' {} damaged, dropped and simulated anew",
      damaged_ == 1 ? "an entry" : fmt::format("{} entries", damaged_),
      database_.path(), damaged_ == 1 ? "was" : "were");
  if (gone_) text += "; " + gone_->text;
  return text;
}

void SharedCache::Discard() {
  statements_.reset();
  const bool is_ours =
      is_new_ && (!database_.is_open() || !database_.CheckInPlace());
  database_.Close();
  std::error_code ignored;
  if (is_ours) std::filesystem::remove(database_.path(), ignored);
}

void SharedCache::Check() {
  MaybeFailure failure = database_.TakeFailure();
  if (!failure) failure = database_.CheckInPlace();
  if (!failure) return;
  gone_ = fmt::format("the cache is not used any more: {}", failure->text);
}

std::optional<Simulated> SharedCache::TakeEntry(const std::string& key) {
  const std::string value = statements_->find.TakeText();
  if (statements_->find.TakeInteger() != ChecksumOf(key, engine_, value))
    return std::nullopt;
  const auto bytes = FromHex(value);
  if (!bytes) return std::nullopt;
  auto simulated = UnpackSimulated(*bytes);
  if (!simulated || simulated->size() != 1) return std::nullopt;
  return std::move(simulated->front());
}

std::optional<Simulated> SharedCache::Find(const Key& key) {
  if (gone_) return std::nullopt;
  const std::string digits = Hex(key);
  Statement& find = statements_->find;
  std::optional<Simulated> found;
  const bool is_there = find.With(digits, engine_id_).Next();
  if (is_there) found = TakeEntry(digits);
  find.With();  // lets the row go: an open read keeps the log from shrinking
  if (is_there && !found) {
    ++damaged_;
    statements_->drop.With(digits, engine_id_).Run();
  }
  Check();
  // What was read beside a failure is no entry.
  if (gone_) return std::nullopt;
  return found;
}

MaybeFailure SharedCache::Add(const Key& key, const Simulated& simulated) {
  if (gone_) return std::nullopt;
  const std::string digits = Hex(key);
  const std::string value = ToHex(PackSimulated({simulated}));
  statements_->add
      .With(digits, engine_id_, value, ChecksumOf(digits, engine_, value))
      .Run();
  Check();
  return std::nullopt;
}

}  // namespace plsc
