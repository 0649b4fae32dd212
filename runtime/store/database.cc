// SQLite behind one door, held to what runs ask of it. WAL, so that readers and
// the writer do not wait for each other; synchronous NORMAL, so that a kill
// loses nothing and a power cut at most the last transactions, never the file.
// Files that come from anywhere are read with defensive settings, without
// trusting what their schema says.
//
// A file without a journal is opened as immutable: no lock, no files beside it,
// also in folders that cannot be written. Whoever reads so must find out by
// itself that somebody began to write meanwhile (StampOf).
//
// SQLite's locks belong to the process and are dropped when it closes any
// descriptor of the file; hence ConnectedFiles, and hence nobody else here
// opens a store. In a child of a fork the connection is the parent's: nothing
// is finalised and nothing closed there.
//
// Failures are kept, the first one, and statements after it do nothing. So code
// reads as if nothing could fail and asks once, at its end.

#include "runtime/store/database.h"

#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <set>
#include <system_error>
#include <utility>

#include "runtime/store/companions.h"
#include "runtime/store/database_file.h"
#include "runtime/text/system_reason.h"

namespace plsc {

namespace {

// How long to wait for another connection, ms. Readers never block writers
// (WAL); only checkpoints and recovery take moments.
constexpr int kPatience = 10000;

/// `last_error`: the system's, after the call that failed. SQLite keeps it of
/// some calls only.
Failure Explain(sqlite3* connection, const std::string& path, int code,
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
      // Disks are full in several ways.
      if (error == EFBIG || error == ENOSPC || error == EDQUOT)
        return fmt::format("cannot write to '{}': {}", path, reason);
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
      // Else it says which part of the file makes no sense.
      return {fmt::format("'{}' is damaged: {}", path, said),
              said == std::string_view(sqlite3_errstr(SQLITE_CORRUPT))
                  ? Failure::Kind::kMalformed
                  : Failure::Kind::kOther};
    case SQLITE_NOTADB:
      return fmt::format("'{}' is no SQLite file, or its beginning is damaged",
                         path);
    default:
      return fmt::format("cannot use '{}': {}", path, said);
  }
}

/// Files to which this process has connections. To open and close one of them
/// besides would drop SQLite's locks on it, and what lies beside them is known
/// to be theirs.
std::multiset<FileId>& ConnectedFiles() {
  static std::multiset<FileId> files;
  return files;
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

std::int64_t SingleInteger(Database& database, const std::string& sql) {
  Statement statement(database, sql);
  return statement.With().Next() ? statement.TakeInteger() : 0;
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

MaybeFailure Database::Open(const std::string& path, Mode mode) {
  Close();
  failure_.reset();
  path_ = path;
  owner_ = getpid();
  is_reading_ = mode == Mode::kRead || mode == Mode::kSalvage;
  is_immutable_ = false;
  real_path_ = mode == Mode::kMemory ? "" : RealPath(path);
  if (mode != Mode::kMemory) {
    if (MaybeFailure failure = CheckFile(path, mode == Mode::kWrite))
      return failure;
    const std::string shown = PrintablePath(path);
    const std::optional<FileId> file = FileIdOf(real_path_);
    if (!file || !ConnectedFiles().contains(*file))
      if (MaybeFailure failure = CheckCompanions(shown)) return failure;
    if (MaybeFailure failure = CheckBeside(shown, mode == Mode::kWrite))
      return failure;
    file_ = file;
  }
  if (MaybeFailure failure = Connect(mode)) {
    Close();
    return failure;
  }
  if (mode == Mode::kWrite) RememberPlace();
  return std::nullopt;
}

MaybeFailure Database::Connect(Mode mode) {
  is_immutable_ = is_reading_ && HasNoJournal(real_path_);
  if (is_immutable_) stamp_ = StampOf(path_);
  const std::string name = mode == Mode::kMemory ? ":memory:"
                           : is_immutable_       ? UriOf(real_path_)
                                                 : real_path_;
  Check(sqlite3_open_v2(
      name.c_str(), &connection_,
      (is_reading_ ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE) |
          (is_immutable_ ? SQLITE_OPEN_URI : 0),
      nullptr));
  if (file_ && connection_ != nullptr) ConnectedFiles().insert(*file_);
  if (has_failed()) return TakeFailure();
  Prepare(mode);
  return TakeFailure();
}

void Database::Prepare(Mode mode) {
  sqlite3_extended_result_codes(connection_, 1);
  sqlite3_busy_timeout(connection_, kPatience);
  // A damaged file must not run what its schema says, and reading must not
  // move what another process wrote from its journal into the file.
  const bool is_salvage = mode == Mode::kSalvage;
  sqlite3_db_config(connection_, SQLITE_DBCONFIG_DEFENSIVE,
                    is_salvage || mode == Mode::kMemory ? 0 : 1, nullptr);
  // Without this SQLite reads nothing of a file that is shorter than it says.
  if (is_salvage) Run("PRAGMA writable_schema = ON");
  sqlite3_db_config(connection_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  if (is_reading_)
    sqlite3_db_config(connection_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1,
                      nullptr);
  Run("PRAGMA cell_size_check = ON; PRAGMA foreign_keys = ON;"
      "PRAGMA synchronous = NORMAL; PRAGMA temp_store = MEMORY;"
      "SELECT count(*) FROM sqlite_master");
}

void Database::RememberPlace() {
  is_placed_ = true;
  journal_ = FileIdOf(real_path_ + "-wal");
  index_ = FileIdOf(real_path_ + "-shm");
}

MaybeFailure Database::CheckInPlace() const {
  return CheckInPlace(file_);
}

MaybeFailure Database::CheckInPlace(const std::optional<FileId>& file) const {
  const char* lost = FileIdOf(real_path_) != file                ? ""
                     : FileIdOf(real_path_ + "-wal") != journal_ ? "-wal"
                     : FileIdOf(real_path_ + "-shm") != index_   ? "-shm"
                                                                 : nullptr;
  if (lost == nullptr) return std::nullopt;
  return fmt::format(
      "'{}{}' was deleted, moved or replaced while it was written to",
      PrintablePath(path_), lost);
}

std::string Database::Image() {
  if (connection_ == nullptr || has_failed()) return "";
  sqlite3_int64 size = 0;
  unsigned char* bytes = sqlite3_serialize(connection_, "main", &size, 0);
  if (bytes == nullptr) {
    Fail(fmt::format("cannot make '{}': out of memory", path_));
    return "";
  }
  std::string image(reinterpret_cast<const char*>(bytes),
                    static_cast<std::size_t>(size));
  sqlite3_free(bytes);
  // https://www.sqlite.org/fileformat.html, 1.3.3: written and read as WAL,
  // so that readers and the writer do not wait for each other.
  image[18] = image[19] = 2;
  return image;
}

bool Database::is_own() const {
  return owner_ == getpid();
}

void Database::Close() {
  sqlite3* connection = std::exchange(connection_, nullptr);
  const std::optional<FileId> file = std::exchange(file_, std::nullopt);
  if (connection == nullptr || !is_own()) return;
  const bool is_lost = is_placed_ && CheckInPlace(file);
  is_placed_ = false;
  // SQLite would delete by their names what may be others' by now.
  int pages = 0, moved = -1;
  if (is_lost) {
    sqlite3_wal_checkpoint_v2(connection, nullptr, SQLITE_CHECKPOINT_PASSIVE,
                              &pages, &moved);
    sqlite3_db_config(connection, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  }
  sqlite3_close(connection);
  if (is_lost && pages == moved) {  // into the file, wherever that is
    if (FileIdOf(real_path_ + "-wal") == journal_)
      unlink((real_path_ + "-wal").c_str());
    if (FileIdOf(real_path_ + "-shm") == index_)
      unlink((real_path_ + "-shm").c_str());
  }
  if (!file) return;
  const auto connected = ConnectedFiles().find(*file);
  if (connected != ConnectedFiles().end()) ConnectedFiles().erase(connected);
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

void Database::Fail(MaybeFailure failure) {
  if (!failure_) failure_ = std::move(failure);
}

MaybeFailure Database::TakeFailure() {
  // Somebody began to write meanwhile; what was read may be of two instants.
  if (is_immutable_ && StampOf(path_) != stamp_)
    failure_ = {
        fmt::format("'{}' was changed while it was read: try again", path_),
        Failure::Kind::kChanged};
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
  const MaybeFailure failure = database_.TakeFailure();
  database_.Run("ROLLBACK");
  database_.TakeFailure();  // of full disks SQLite has rolled back itself
  if (failure) database_.Fail(*failure);
}

MaybeFailure Transaction::Commit() {
  database_.Run("COMMIT");
  if (database_.has_failed())
    Undo();
  else
    is_open_ = false;
  return database_.TakeFailure();
}

}  // namespace plsc
