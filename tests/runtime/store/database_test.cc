#include "runtime/store/database.h"

#include <sys/wait.h>
#include <unistd.h>

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "runtime/store/make_database.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

using test::Scratch;

/// With a table t of two columns.
void Make(Database& database, const std::string& path) {
  const auto fill = [](Database& made) { made.Run("CREATE TABLE t(a, b)"); };
  REQUIRE(MakeDatabase(path, fill) == std::nullopt);
  REQUIRE(database.Open(path, Database::Mode::kWrite) == std::nullopt);
}

std::int64_t Count(Database& database) {
  Statement count(database, "SELECT count(*) FROM t");
  REQUIRE(count.With().Next());
  return count.TakeInteger();
}

}  // namespace

TEST_CASE("Values come back bit for bit", "[database]") {
  const Scratch scratch;
  Database database;
  Make(database, scratch / "db");
  Statement insert(database, "INSERT INTO t VALUES(?, ?)");
  Statement select(database, "SELECT a FROM t WHERE b = ?");
  int row = 0;
  using Limits = std::numeric_limits<double>;
  for (const double value :
       {0.1, 1.0, -1.0, 1e300, -5e-324, Limits::max(), Limits::lowest(),
        Limits::infinity(), 9007199254740993.0, 1.0 / 3}) {
    insert.With(value, ++row).Run();
    REQUIRE(select.With(row).Next());
    CHECK(std::bit_cast<std::uint64_t>(select.TakeReal()) ==
          std::bit_cast<std::uint64_t>(value));
  }
  insert.With(-0.0, ++row).Run();
  REQUIRE(select.With(row).Next());
  CHECK(std::bit_cast<std::uint64_t>(select.TakeReal()) == 0);
  insert.With(Limits::quiet_NaN(), ++row).Run();
  REQUIRE(select.With(row).Next());
  CHECK(select.IsNull());
  CHECK(std::isnan(select.TakeReal()));
  const std::string text("a\0b'\"\xc3\xa9", 7);
  for (const std::string& value : {text, std::string()}) {
    insert.With(value, ++row).Run();
    REQUIRE(select.With(row).Next());
    CHECK(select.TakeText() == value);
  }
  insert.With(std::numeric_limits<std::int64_t>::min(), ++row).Run();
  REQUIRE(select.With(row).Next());
  CHECK(select.TakeInteger() == std::numeric_limits<std::int64_t>::min());
  REQUIRE(select.With(row).Next());
  CHECK(select.TakeInt() == 0);  // it does not fit
  insert.With(std::optional<double>(), ++row).Run();
  REQUIRE(select.With(row).Next());
  CHECK(select.TakeOptional() == std::nullopt);
  CHECK(database.TakeFailure() == std::nullopt);
}

TEST_CASE("Bytes of a value tell its type", "[database]") {
  const Scratch scratch;
  Database database;
  Make(database, scratch / "db");
  Statement values(database, "SELECT 1, 1.0, '1', x'31', NULL, ''");
  REQUIRE(values.With().Next());
  std::string bytes;
  for (int i = 0; i < values.columns(); ++i) bytes += values.TakeBytes() + " ";
  CHECK(bytes == "i1:1 r16:3ff0000000000000 t1:1 b1:1 n0: t0: ");
}

TEST_CASE("After a failure nothing is done until it is told", "[database]") {
  const Scratch scratch;
  Database database;
  Make(database, scratch / "db");
  database.Run("no SQL");
  CHECK(database.has_failed());
  database.Run("INSERT INTO t VALUES(1, 2)");
  Statement late(database, "INSERT INTO t VALUES(1, 2)");
  late.With().Run();
  CHECK_FALSE(late.Next());
  CHECK(database.TakeFailure() ==
        "cannot use '" + (scratch / "db") + "': near \"no\": syntax error");
  CHECK(database.TakeFailure() == std::nullopt);
  CHECK(Count(database) == 0);
}

TEST_CASE("A transaction is there as a whole or not at all", "[database]") {
  const Scratch scratch;
  Database database;
  Make(database, scratch / "db");
  {
    Transaction transaction(database);
    database.Run("INSERT INTO t VALUES(1, 2)");
    CHECK(transaction.Commit() == std::nullopt);
  }
  CHECK(Count(database) == 1);
  {
    Transaction transaction(database);
    database.Run("INSERT INTO t VALUES(1, 2)");
    database.Run("wrong");
    CHECK(transaction.Commit());
  }
  CHECK(Count(database) == 1);
  {
    const Transaction transaction(database);
    database.Run("INSERT INTO t VALUES(1, 2)");
  }
  CHECK(Count(database) == 1);
  CHECK(database.TakeFailure() == std::nullopt);
}

TEST_CASE("A reader changes nothing and leaves nothing", "[database]") {
  const Scratch scratch;
  const std::string path = scratch / "a file? 100% #1";
  {
    Database database;
    Make(database, path);
  }
  const std::string before = test::ReadBytes(path);
  {
    Database database;
    REQUIRE(database.Open(path, Database::Mode::kRead) == std::nullopt);
    CHECK(Count(database) == 0);
    database.Run("INSERT INTO t VALUES(1, 2)");
    CHECK(database.TakeFailure() ==
          "cannot write to '" + path + "': it is read-only");
  }
  CHECK(test::ReadBytes(path) == before);
  CHECK(scratch.Files().size() == 1);
}

TEST_CASE("A reader is told when the file changed under it", "[database]") {
  const Scratch scratch;
  const std::string path = scratch / "db";
  {
    Database database;
    Make(database, path);
  }
  Database reader;
  REQUIRE(reader.Open(path, Database::Mode::kRead) == std::nullopt);
  CHECK(reader.TakeFailure() == std::nullopt);
  {
    Database database;
    REQUIRE(database.Open(path, Database::Mode::kWrite) == std::nullopt);
    database.Run("INSERT INTO t VALUES(1, 2)");
  }
  CHECK(reader.TakeFailure() ==
        Failure("'" + path + "' was changed while it was read: try again",
                Failure::Kind::kChanged));
}

TEST_CASE("A child of a fork leaves its parent's database alone",
          "[database]") {
  const Scratch scratch;
  const std::string path = scratch / "db";
  Database database;
  Make(database, path);
  database.Run("INSERT INTO t VALUES(1, 2)");
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    database.Close();  // as destructors would
    _exit(0);
  }
  REQUIRE(waitpid(child, nullptr, 0) == child);
  CHECK(scratch.Files() == std::vector<std::string>{"db", "db-shm", "db-wal"});
  database.Run("INSERT INTO t VALUES(1, 2)");
  CHECK(Count(database) == 2);
}

}  // namespace plsc
