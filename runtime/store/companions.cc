// SQLite finds its journal by name alone, and what it finds it plays back, cuts
// and deletes. A journal of another database that lies there by chance (two
// files renamed, a copy put back) would so destroy both. Therefore every store
// carries a random identity in its header, the journal carries it in its copy
// of page 1, and the two must agree before SQLite sees them. What cannot be
// told apart (an empty journal, one without page 1) is what SQLite itself
// leaves behind, and harmless.
//
// The format is read here by its documentation and by as little of it as
// suffices: magic numbers, page size, salt, frames until page 1. Others may
// write meanwhile; what is read while it changes is taken for unknown, not for
// foreign.

#include "runtime/store/companions.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <string_view>

#include "runtime/store/file_id.h"

namespace plsc {

namespace {
using Bytes = std::array<unsigned char, 100>;

// https://www.sqlite.org/fileformat.html: the header of a database; of a
// journal that is written ahead (WAL) with its frames; of its index.
constexpr std::string_view kMagic("SQLite format 3\0", 16);
constexpr std::uint32_t kWalMagic = 0x377f0682;  // or 1 more
constexpr std::uint32_t kWalVersion = 3007000;   // of the index, too
constexpr std::size_t kWalHeader = 32, kFrameHeader = 24;
constexpr std::size_t kIdentity = 40;  // the place in a database's first page

std::uint32_t Word(const unsigned char* bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 |
         std::uint32_t{bytes[2]} << 8 | std::uint32_t{bytes[3]};
}

class File {
 public:
  explicit File(const std::string& path)
      : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  ~File() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /// How many bytes of `size` there are; the others are 0.
  std::size_t Read(std::size_t place, std::size_t size, Bytes& bytes) const {
    bytes.fill(0);
    const ssize_t count =
        pread(descriptor_, bytes.data(), size, static_cast<off_t>(place));
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }

 private:
  int descriptor_;
};

struct Header {
  bool is_database = false;  ///< else SQLite will say so, too
  std::size_t page_size = 0;
  std::uint32_t identity = 0;
};

Header HeaderOf(const std::string& path) {
  Bytes bytes{};
  Header header;
  const File file(path);
  header.is_database =
      file.Read(0, bytes.size(), bytes) == bytes.size() &&
      std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) == 0;
  const std::size_t size = std::size_t{bytes[16]} << 8 | bytes[17];
  header.page_size = size == 1 ? 65536 : size;
  header.identity = Word(bytes.data() + kIdentity);
  return header;
}

bool IsThere(const std::string& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0;
}

/// The first `size` bytes of a journal, a part of them if it is shorter:
/// whether SQLite wrote them. Zeros are what a power cut leaves.
bool BeginsAsJournal(const Bytes& bytes, std::size_t size) {
  const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(size);
  if (std::all_of(bytes.begin(), end, [](unsigned char b) { return b == 0; }))
    return true;
  Bytes magic{};
  for (int i = 0; i < 4; ++i)
    magic[static_cast<std::size_t>(i)] =
        static_cast<unsigned char>(kWalMagic >> (24 - 8 * i));
  const std::size_t known = std::min<std::size_t>(size, 4);
  Bytes begin = bytes;
  if (known == 4) begin[3] &= 0xfe;
  if (std::memcmp(begin.data(), magic.data(), known) != 0) return false;
  return size < 8 || Word(bytes.data() + 4) == kWalVersion;
}

/// Of the first page 1 in a journal's frames; nothing if it has none.
std::optional<std::uint32_t> IdentityIn(const File& journal,
                                        const Bytes& header,
                                        std::size_t page_size) {
  Bytes frame{};
  Bytes again{};
  constexpr std::size_t kEnough = kFrameHeader + kIdentity + 4;
  for (std::size_t place = kWalHeader;
       journal.Read(place, kEnough, frame) == kEnough;
       place += kFrameHeader + page_size) {
    // What is left of a journal that was begun anew has another salt.
    if (std::memcmp(frame.data() + 8, header.data() + 16, 8) != 0) break;
    if (Word(frame.data()) != 1) continue;
    // SQLite writes a frame's header first: if that is as it was, so was the
    // page when it was read.
    journal.Read(place, kFrameHeader, again);
    if (std::memcmp(frame.data(), again.data(), kFrameHeader) != 0) break;
    const std::uint32_t identity =
        Word(frame.data() + kFrameHeader + kIdentity);
    if (identity != 0) return identity;  // else a power cut lost the page
  }
  return std::nullopt;
}

bool IsJournalOf(const Header& database, const std::string& path) {
  const File file(path);
  Bytes header{};
  const std::size_t size = file.Read(0, kWalHeader, header);
  if (!BeginsAsJournal(header, size)) return false;
  if (size < kWalHeader || Word(header.data()) == 0) return true;
  if (!database.is_database) return true;
  if (Word(header.data() + 8) != database.page_size) return false;
  const auto identity = IdentityIn(file, header, database.page_size);
  return !identity || *identity == database.identity;
}

/// SQLite makes it anew from the journal, so all that counts is whose it is.
bool IsIndex(const std::string& path, off_t size) {
  if (size == 0 || size == 3) return true;  // as SQLite makes it
  const File file(path);
  Bytes bytes{};
  std::uint32_t version = 0;
  file.Read(0, sizeof version, bytes);
  std::memcpy(&version, bytes.data(), sizeof version);  // of this machine
  return size % 4096 == 0 && (version == 0 || version == kWalVersion);
}

std::string Foreign(const std::string& path, const std::string& companion) {
  return fmt::format(
      "'{}' is not of '{}', but SQLite would use it with that, and then cut "
      "and delete it: move it away, to the store that it is of if there is one",
      companion, path);
}

}  // namespace

MaybeFailure CheckCompanions(const std::string& path) {
  const std::string journal = path + "-wal";
  const std::string index = path + "-shm";
  // Nothing of ours ever has one: all is in WAL mode.
  if (IsThere(path + "-journal")) return Foreign(path, path + "-journal");
  struct stat status {};
  const auto is_plain = [&] {
    return S_ISREG(status.st_mode) && status.st_nlink <= 1;
  };
  bool has_journal = false;
  if (lstat(journal.c_str(), &status) == 0) {
    has_journal = true;
    if (!is_plain() || !IsJournalOf(HeaderOf(path), journal))
      return Foreign(path, journal);
  }
  if (lstat(index.c_str(), &status) != 0) return std::nullopt;
  if (!is_plain() || !IsIndex(index, status.st_size))
    return Foreign(path, index);
  // Others may begin and end to work on it while we look: the index is made
  // after the journal, and deleted before it.
  if (!has_journal && !IsThere(journal) && IsThere(index))
    return fmt::format(
        "'{}' is there, but not the journal '{}' that it belongs to: put that "
        "back, or, if it is lost and nobody works on '{}', delete '{}'",
        index, journal, path, index);
  return std::nullopt;
}

MaybeFailure CheckNoCompanions(const std::string& path) {
  for (const char* end : {"-journal", "-wal", "-shm"})
    if (IsThere(path + end))
      return fmt::format(
          "'{}' is in the way: it is of a '{}' that is gone, and SQLite would "
          "use it with a new one: move it away, delete it, or choose another "
          "name",
          path + end, path);
  return std::nullopt;
}

std::int32_t DrawIdentity() {
  std::random_device chance;
  const auto drawn = static_cast<std::int32_t>(chance() & 0x7fffffff);
  return std::max(drawn, std::int32_t{1});
}

}  // namespace plsc
