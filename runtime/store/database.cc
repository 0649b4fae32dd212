#include "runtime/store/database.h"

#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

namespace plsc {

namespace {

// How long to wait for another connection, ms. Readers never block writers
// (WAL); only checkpoints and recovery take moments.
constexpr int kPatience = 10000;

std::string SystemReason(int error) {
  return std::error_code(error, std::generic_category()).message();
}

/// `last_error`: the system's, after the call that failed. SQLite keeps it of
/// some calls only.
std::string Explain(sqlite3* connection, const std::string& path, int code,
                    int last_error) {
  const char* said = sqlite3_errmsg(connection);
  const int kept = sqlite3_system_errno(connection);
  const int error = kept != 0 ? kept : last_error;
  const std::string reason = error != 0 ? SystemReason(error) : said;
  switch (code & 0xff) {  // the rest says more of it
    case SQLITE_FULL:
      return fmt::format("cannot write to '{}': {}", path,
                         SystemReason(ENOSPC));
    case SQLITE_IOERR:
      return fmt::format("cannot read or write '{}': {}", path, reason);
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
      return fmt::format("cannot open '{}': {}", path, reason);
    case SQLITE_READONLY:
      return fmt::format("cannot write to '{}': it is read-only", path);
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return fmt::format("cannot use '{}': another program holds it", path);
    case SQLITE_CORRUPT:
      return fmt::format("'{}' is damaged: {}", path, said);
    case SQLITE_NOTADB:
      return fmt::format("'{}' is no SQLite file, or its beginning is damaged",
                         path);
    default:
      return fmt::format("cannot use '{}': {}", path, said);
  }
}

/// What the system says before SQLite would say less.
Database::Failure CheckFile(const std::string& path, Database::Mode mode) {
  // access, because to open and close the file would drop the locks of another
  // connection of this process.
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    return fmt::format("cannot open '{}': {}", path,
                       SystemReason(error ? error.value() : ENOENT));
  if (std::filesystem::is_directory(status))
    return fmt::format("cannot open '{}': it is a folder", path);
  if (!std::filesystem::is_regular_file(status))
    return fmt::format("cannot open '{}': it is no file", path);
  const bool is_reading =
      mode == Database::Mode::kRead || mode == Database::Mode::kSalvage;
  const int rights = is_reading ? R_OK : R_OK | W_OK;
  if (access(path.c_str(), rights) != 0)
    return fmt::format("cannot {} '{}': {}", is_reading ? "read" : "write to",
                       path, SystemReason(errno));
  // SQLite takes an empty file for a database without tables.
  if (mode != Database::Mode::kCreate &&
      std::filesystem::file_size(path, error) == 0)
    return fmt::format("'{}' is empty", path);
  return std::nullopt;
}

/// Without a journal nobody writes, and a reader that did more than read the
/// file would leave files of its own beside it.
bool HasNoJournal(const std::string& path) {
  return access((path + "-wal").c_str(), F_OK) != 0;
}

/// Changes whenever the file does: its size and when it was written.
std::string StampOf(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return "";
  return fmt::format("{} {} {} {}", status.st_ino, status.st_size,
                     status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
}

std::string UriOf(const std::string& path) {
  // Two slashes would begin the name of a host.
  std::string uri = path.starts_with("//") ? "file://" : "file:";
  for (const char c : path) {
    if (c == '%' || c == '?' || c == '#')
      uri += fmt::format("%{:02x}", static_cast<unsigned char>(c));
    else
      uri += c;
  }
  return uri + "?immutable=1";
}

}  // namespace

Statement::Statement(Database& database, const std::string& sql)
    : database_(database) {
  if (database_.connection_ == nullptr || database_.has_failed()) return;
  Check(sqlite3_prepare_v3(database_.connection_, sql.c_str(), -1,
                           SQLITE_PREPARE_PERSISTENT, &statement_, nullptr));
}

Statement::~Statement() {
  // The connection is the parent's in a child of a fork.
  if (database_.is_own()) sqlite3_finalize(statement_);
}

Statement::Statement(Statement&& other) noexcept
    : database_(other.database_),
      statement_(std::exchange(other.statement_, nullptr)),
      bound_(other.bound_),
      column_(other.column_) {}

void Statement::Check(int code) {
  if (code != SQLITE_OK) database_.Check(code);
}

void Statement::Restart() {
  if (statement_ != nullptr) sqlite3_reset(statement_);  // said before
  bound_ = 0;
}

void Statement::Bind(std::int64_t value) {
  if (statement_ != nullptr)
    Check(sqlite3_bind_int64(statement_, ++bound_, value));
}

void Statement::Bind(double value) {
  // SQLite would store -0 as 0 in tables, but not everywhere else.
  if (statement_ != nullptr)
    Check(sqlite3_bind_double(statement_, ++bound_, value == 0 ? 0 : value));
}

void Statement::Bind(std::string_view value) {
  // A view of nothing has no address, which SQLite would take for NULL.
  const char* text = value.empty() ? "" : value.data();
  if (statement_ != nullptr)
    Check(sqlite3_bind_text64(statement_, ++bound_, text, value.size(),
                              SQLITE_STATIC, SQLITE_UTF8));
}

void Statement::Bind(std::nullopt_t) {
  if (statement_ != nullptr) Check(sqlite3_bind_null(statement_, ++bound_));
}

void Statement::Run() {
  while (Next()) {
  }
}

bool Statement::Next() {
  column_ = 0;
  if (statement_ == nullptr || database_.has_failed()) return false;
  errno = 0;
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) database_.Check(code);
  sqlite3_reset(statement_);  // ends reading, so that others may write
  return false;
}

int Statement::columns() const {
  return statement_ == nullptr ? 0 : sqlite3_column_count(statement_);
}

char Statement::Type() const {
  switch (sqlite3_column_type(statement_, column_)) {
    case SQLITE_INTEGER:
      return 'i';
    case SQLITE_FLOAT:
      return 'r';
    case SQLITE_TEXT:
      return 't';
    case SQLITE_BLOB:
      return 'b';
    default:
      return 'n';
  }
}

bool Statement::IsNull() const {
  return Type() == 'n';
}

std::int64_t Statement::TakeInteger() {
  return sqlite3_column_int64(statement_, column_++);
}

int Statement::TakeInt() {
  const std::int64_t value = TakeInteger();
  return std::in_range<int>(value) ? static_cast<int>(value) : 0;
}

double Statement::TakeReal() {
  if (!IsNull()) return sqlite3_column_double(statement_, column_++);
  ++column_;
  return std::numeric_limits<double>::quiet_NaN();
}

std::optional<double> Statement::TakeOptional() {
  if (!IsNull()) return TakeReal();
  ++column_;
  return std::nullopt;
}

std::string Statement::TakeText() {
  const unsigned char* text = sqlite3_column_text(statement_, column_);
  const int size = sqlite3_column_bytes(statement_, column_);
  ++column_;
  if (text == nullptr) return "";
  return {reinterpret_cast<const char*>(text), static_cast<std::size_t>(size)};
}

std::string Statement::TakeBytes() {
  const char type = Type();
  std::string value;
  if (type == 'i')
    value = std::to_string(TakeInteger());
  else if (type == 'r')
    value = fmt::format("{:016x}", std::bit_cast<std::uint64_t>(TakeReal()));
  else
    value = TakeText();
  return fmt::format("{}{}:{}", type, value.size(), value);
}

std::string Statement::ColumnName(int column) const {
  return sqlite3_column_name(statement_, column);
}

Database::Failure Database::Open(const std::string& path, Mode mode) {
  Close();
  failure_.reset();
  path_ = path;
  owner_ = getpid();
  is_reading_ = mode == Mode::kRead || mode == Mode::kSalvage;
  if (mode != Mode::kCreate)
    if (Failure failure = CheckFile(path, mode)) return failure;
  if (Failure failure = Connect(mode)) {
    Close();
    return failure;
  }
  return std::nullopt;
}

Database::Failure Database::Connect(Mode mode) {
  const bool is_reading = is_reading_;
  is_immutable_ = is_reading && HasNoJournal(path_);
  if (is_immutable_) stamp_ = StampOf(path_);
  const int flags = is_reading ? SQLITE_OPEN_READONLY
                    : mode == Mode::kCreate
                        ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE
                        : SQLITE_OPEN_READWRITE;
  const std::string name = is_immutable_ ? UriOf(path_) : path_;
  Check(sqlite3_open_v2(name.c_str(), &connection_,
                        flags | (is_immutable_ ? SQLITE_OPEN_URI : 0),
                        nullptr));
  if (has_failed()) return TakeFailure();
  sqlite3_extended_result_codes(connection_, 1);
  sqlite3_busy_timeout(connection_, kPatience);
  // A damaged file must not run what its schema says, and reading must not
  // move what another process wrote from its journal into the file.
  const bool is_salvage = mode == Mode::kSalvage;
  sqlite3_db_config(connection_, SQLITE_DBCONFIG_DEFENSIVE, is_salvage ? 0 : 1,
                    nullptr);
  // Without this SQLite reads nothing of a file that is shorter than it says.
  if (is_salvage) Run("PRAGMA writable_schema = ON");
  sqlite3_db_config(connection_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  if (is_reading)
    sqlite3_db_config(connection_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1,
                      nullptr);
  Run("PRAGMA cell_size_check = ON; PRAGMA foreign_keys = ON;"
      "PRAGMA synchronous = NORMAL; PRAGMA temp_store = MEMORY;"
      "SELECT count(*) FROM sqlite_master");
  return TakeFailure();
}

bool Database::is_own() const {
  return owner_ == getpid();
}

void Database::Close() {
  sqlite3* connection = std::exchange(connection_, nullptr);
  if (connection != nullptr && is_own()) sqlite3_close(connection);
}

void Database::Run(const std::string& sql) {
  if (connection_ == nullptr || has_failed()) return;
  errno = 0;
  Check(sqlite3_exec(connection_, sql.c_str(), nullptr, nullptr, nullptr));
}

void Database::Check(int code) {
  const int last_error = errno;
  if (code != SQLITE_OK && !failure_)
    failure_ = Explain(connection_, path_, code, last_error);
}

void Database::Fail(std::string failure) {
  if (!failure_) failure_ = std::move(failure);
}

Database::Failure Database::TakeFailure() {
  // Somebody began to write meanwhile; what was read may be of two instants.
  if (is_immutable_ && StampOf(path_) != stamp_)
    failure_ =
        fmt::format("'{}' was changed while it was read: try again", path_);
  return std::exchange(failure_, std::nullopt);
}

Transaction::Transaction(Database& database) : database_(database) {
  // Writers at once, so that they cannot fail in the middle.
  database_.Run(database_.is_reading_ ? "BEGIN" : "BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (is_open_) Undo();
}

void Transaction::Undo() {
  is_open_ = false;
  const Database::Failure failure = database_.TakeFailure();
  database_.Run("ROLLBACK");
  database_.TakeFailure();  // of full disks SQLite has rolled back itself
  if (failure) database_.Fail(*failure);
}

Database::Failure Transaction::Commit() {
  database_.Run("COMMIT");
  if (database_.has_failed())
    Undo();
  else
    is_open_ = false;
  return database_.TakeFailure();
}

}  // namespace plsc
