#pragma once

// A file that gets its name when it is whole, so that nobody ever sees a half
// of it, and a kill leaves none. Until then it has no name at all where the
// file system knows such files (O_TMPFILE), else one that nobody had; nothing
// that lies in the folder already is opened, followed, cut or deleted.

#include <cstdint>
#include <string>
#include <string_view>

#include "grammar/failure.h"

namespace plsc {

class NewFile {
 public:
  enum class Until : std::uint8_t {
    kNameless,
    kNamed,  ///< for tests: as on file systems that know no nameless files
  };

  explicit NewFile(std::string path, Until until = Until::kNameless);
  ~NewFile();  ///< without a name there is nothing left of it
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// These return "cannot write to 'x': No space left on device", and then
  /// nothing is there that was not before.
  MaybeFailure Write(std::string_view text);
  /// On the disk, under its name, which nothing may have yet.
  MaybeFailure Publish();
  /// Likewise, in place of the file of that name; of a link the link itself.
  MaybeFailure Replace();

  /// To be locked before it has a name. Closed with the object.
  int descriptor() const { return descriptor_; }

 private:
  void Open(Until until);
  void OpenNamed();
  void Flush();
  void Link(const std::string& name);
  std::string Neighbour();
  MaybeFailure failure() const;

  std::string path_;
  std::string neighbour_;  // its name until it is whole; empty: it has none
  std::string pending_;    // written to the object, not yet to the file
  int descriptor_ = -1;
  int error_ = 0;  // the system's first
};

}  // namespace plsc
