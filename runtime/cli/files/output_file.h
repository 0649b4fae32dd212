#pragma once

// How outputs get onto the disk: a file as a whole or not at all, a pipe or a
// device as it is written. Whether a file may be replaced is not asked here:
// that is WriteOutput (output_path.h), which all outputs take.

#include <optional>
#include <string>
#include <string_view>

#include "grammar/expected.h"
#include "runtime/cli/files/io.h"
#include "runtime/cli/files/pipe_errors.h"

namespace plsc::cli {

/// Whether the path is a descriptor of this process under a name, as
/// /dev/stdout.
bool IsDescriptor(const std::string& path);

/// A file for outputs that are written in pieces: a neighbour file, flushed to
/// the disk, takes its name, and the rights of the file that it replaces. A
/// pipe or a device is written into.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();  ///< of what is not finished nothing is left
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// These return the system's reason when it fails, the first that there was.
  std::optional<std::string> Write(std::string_view text);
  std::optional<std::string> Finish();
  /// As Finish, but only over a file of these bytes, or where there is none
  /// (null). False: something else is there, and stays. Nobody who puts another
  /// file there meanwhile loses it.
  Expected<bool, std::string> FinishOver(const std::string* previous);

  /// The file's own, behind symbolic links.
  const std::string& path() const { return path_; }

 private:
  bool Open();
  void Flush();
  /// All that was written is on the disk.
  bool IsOnDisk();
  std::optional<std::string> reason() const;

  PipeErrors are_errors_;
  std::string path_;
  std::string neighbour_;  // its name until it is finished; empty: it has none
  std::string pending_;    // written to the object, not yet to the file
  int descriptor_ = -1;
  int error_ = 0;
};

/// All of a file at once. The reason when that fails.
std::optional<std::string> WriteFile(const std::string& path,
                                     std::string_view text);

/// The same, printing why. Whether it is written.
bool WriteOrReport(const std::string& path, std::string_view text, Io& io);

}  // namespace plsc::cli
