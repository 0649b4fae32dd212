#include "runtime/store/shared_cache.h"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

namespace plsc {
namespace {

/// A file name for one test, gone afterwards.
class Scratch {
 public:
  Scratch()
      : path_((std::filesystem::temp_directory_path() /
               ("plsc_shared_cache_" + std::to_string(getpid())))
                  .string()) {
    Remove();
  }
  ~Scratch() { Remove(); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::string& path() const { return path_; }

 private:
  void Remove() const {
    for (const char* suffix : {"", "-wal", "-shm"})
      std::filesystem::remove(path_ + suffix);
  }
  std::string path_;
};

Simulated Example() {
  Simulated example;
  example.inclination = 0.1 + 0.2;
  example.behaviour.is_valid = true;
  example.behaviour.displacement_velocity_hill = -0.0;
  example.state_hash = 0xfedcba9876543210;
  example.steps = 10000;
  return example;
}

TEST_CASE("A cache finds what any run added, bit for bit", "[shared_cache]") {
  const Scratch scratch;
  {
    SharedCache cache;
    REQUIRE_FALSE(cache.Open(scratch.path()));
    CHECK_FALSE(cache.Find({1, 2}));
    CHECK_FALSE(cache.Add({1, 2}, Example()));
    SharedCache other;  // at the same time
    REQUIRE_FALSE(other.Open(scratch.path()));
    CHECK(other.Find({1, 2}));
    CHECK_FALSE(other.Add({3, 4}, Example()));
    CHECK(cache.Find({3, 4}));
    CHECK_FALSE(cache.warning());
  }
  SharedCache cache;
  REQUIRE_FALSE(cache.Open(scratch.path()));
  const auto found = cache.Find({1, 2});
  REQUIRE(found);
  CHECK(found->inclination == 0.1 + 0.2);
  CHECK(std::signbit(found->behaviour.displacement_velocity_hill));
  CHECK(found->state_hash == 0xfedcba9876543210);
  CHECK(found->steps == 10000);
  CHECK_FALSE(cache.Find({2, 1}));
}

TEST_CASE("What another program simulated is not found", "[shared_cache]") {
  const Scratch scratch;
  SharedCache theirs;
  REQUIRE_FALSE(theirs.Open(scratch.path(), "another engine"));
  CHECK_FALSE(theirs.Add({1, 2}, Example()));
  SharedCache ours;
  REQUIRE_FALSE(ours.Open(scratch.path()));
  CHECK_FALSE(ours.Find({1, 2}));
  CHECK(ThisEngine() == ThisEngine());
}

TEST_CASE("What is no cache is refused, and stays as it is", "[shared_cache]") {
  const Scratch scratch;
  std::ofstream(scratch.path()) << "a text that was here before";
  SharedCache cache;
  CHECK(cache.Open(scratch.path()));
  std::ifstream file(scratch.path());
  std::string text;
  std::getline(file, text);
  CHECK(text == "a text that was here before");
  CHECK(SharedCache().Open("/no/such/folder/cache"));
  CHECK(SharedCache().Open("/tmp"));
}

TEST_CASE("A cache that cannot be written any more only warns",
          "[shared_cache]") {
  const Scratch scratch;
  SharedCache cache;
  REQUIRE_FALSE(cache.Open(scratch.path()));
  CHECK_FALSE(cache.Add({1, 2}, Example()));
  // Files may not grow from here on, as on a full disk.
  struct rlimit before {};
  getrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, SIG_IGN);
  const struct rlimit small = {1, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  CHECK_FALSE(cache.Add({3, 4}, Example()));
  setrlimit(RLIMIT_FSIZE, &before);
  REQUIRE(cache.warning());
  CHECK(cache.warning()->find("not used any more") != std::string::npos);
  CHECK_FALSE(cache.Find({1, 2}));
}

}  // namespace
}  // namespace plsc
