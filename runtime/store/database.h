#pragma once

// The door to SQLite: a connection, prepared statements and transactions. What
// goes wrong is kept as a message until it is asked for; after it, statements
// do nothing, so that a caller may check once at the end. Knows nothing of
// runs.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "grammar/failure.h"
#include "runtime/store/file_id.h"

struct sqlite3;       // SQLite's own, as its header declares them
struct sqlite3_stmt;  // likewise

namespace plsc {

class Database;

/// One SQL statement. Doubles are kept bit for bit, but that -0 becomes 0 and
/// what is no number NULL, which is read as a quiet NaN.
class Statement {
 public:
  Statement(Database& database, const std::string& sql);
  ~Statement();
  Statement(Statement&& other) noexcept;
  Statement& operator=(Statement&&) = delete;

  /// Starts anew with these values for its parameters, in order. Texts must
  /// live until the next With or Run has ended.
  template <typename... Values>
  Statement& With(const Values&... values) {
    Restart();
    (Bind(values), ...);
    return *this;
  }
  /// Like With, one value more.
  template <typename Value>
  Statement& And(const Value& value) {
    Bind(value);
    return *this;
  }
  void Run();   ///< to the end, whatever rows there are
  bool Next();  ///< whether there is another row

  int columns() const;
  /// Of the row: each takes the next column, the first one first.
  bool IsNull() const;
  std::int64_t TakeInteger();
  int TakeInt();  ///< 0 if it does not fit
  double TakeReal();
  std::optional<double> TakeOptional();
  std::string TakeText();
  /// Its type and value as bytes, the same only for the same.
  std::string TakeBytes();
  std::string ColumnName(int column) const;
  /// 'i'nteger, 'r'eal, 't'ext, 'b'lob or 'n'ull, of the next column.
  char Type() const;

 private:
  void Restart();
  void Bind(std::int64_t value);
  void Bind(int value) { Bind(std::int64_t{value}); }
  void Bind(double value);
  void Bind(std::string_view value);
  void Bind(const std::string& value) { Bind(std::string_view(value)); }
  void Bind(const char* value) { Bind(std::string_view(value)); }
  void Bind(std::nullopt_t);
  template <typename Value>
  void Bind(const std::optional<Value>& value) {
    if (value)
      Bind(*value);
    else
      Bind(std::nullopt);
  }
  void Check(int code);

  Database& database_;
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0;
  int column_ = 0;
};

class Database {
 public:
  enum class Mode : std::uint8_t {
    kMemory,   ///< no file, whatever the path: see Image
    kWrite,    ///< a file that exists
    kRead,     ///< likewise; nothing is ever changed
    kSalvage,  ///< likewise; also what is cut off
  };

  Database() = default;
  ~Database() { Close(); }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Refused is also what SQLite would use with the file and is not of it
  /// (companions.h), and to write to a file that has several names.
  MaybeFailure Open(const std::string& path, Mode mode);
  /// All statements must be gone. In a child of a fork it does nothing: the
  /// file is the parent's.
  void Close();
  /// Whether what is written still goes to the file of this name: that neither
  /// it nor its journal was deleted, moved or replaced since it was opened.
  MaybeFailure CheckInPlace() const;
  /// Of a database in memory: what a file would have in it, in WAL mode.
  std::string Image();
  bool is_open() const { return connection_ != nullptr; }
  /// Opened by this very process, not by a parent of it.
  bool is_own() const;
  const std::string& path() const { return path_; }

  /// One or several statements without parameters.
  void Run(const std::string& sql);
  bool has_failed() const { return failure_.has_value(); }
  /// The first failure since the last call.
  MaybeFailure TakeFailure();
  /// As if SQLite had said it.
  void Fail(MaybeFailure failure);

 private:
  friend class Statement;
  friend class Transaction;
  void Check(int code);
  MaybeFailure Connect(Mode mode);
  void Prepare(Mode mode);
  void RememberPlace();
  MaybeFailure CheckInPlace(const std::optional<FileId>& file) const;

  sqlite3* connection_ = nullptr;
  std::string path_;
  std::string real_path_;  // no links in it: companions are beside the file
  std::optional<FileId> file_;  // while there is a connection to one
  // Of who writes, from when it was opened:
  bool is_placed_ = false;
  std::optional<FileId> journal_;
  std::optional<FileId> index_;
  int owner_ = 0;  // pid
  bool is_reading_ = false;
  bool is_immutable_ = false;  // SQLite takes the file for one that stays
  std::string stamp_;          // of a file that is taken so
  MaybeFailure failure_;
};

/// The one integer that the statement asks for; 0 if there is no row.
std::int64_t SingleInteger(Database& database, const std::string& sql);

/// All that is written while it lives, or nothing; and all that is read is of
/// one instant.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();  ///< takes everything back, unless committed
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  /// What went wrong since it began; then nothing of it was written.
  MaybeFailure Commit();

 private:
  void Undo();

  Database& database_;
  bool is_open_ = true;
};

}  // namespace plsc
