#pragma once

// Lines of standard input as they come, for a command that has other things to
// wait for in the meantime.

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "runtime/cli/files/io.h"

namespace plsc::cli {

struct InputLine {
  std::size_t number = 0;  ///< from 1
  std::string text;        ///< without its end
  bool is_cut = false;     ///< longer than the limit; what came first
};

class LineReader {
 public:
  /// Bytes a line; that of genotype files (ReadSource).
  static constexpr std::size_t kLongestLine = std::size_t{16} << 20;

  /// Reads io.input_descriptor, or io.in where there is none. The limit is
  /// another one in tests only.
  explicit LineReader(Io& io, std::size_t longest = kLongestLine)
      : io_(io), longest_(longest) {}

  /// Reads what is there; if that is nothing, waits for at most `timeout_ms`
  /// (-1: until something comes or a signal does).
  void Fill(int timeout_ms);
  /// The next whole line that was read; the last one may lack its end.
  std::optional<InputLine> Next();
  /// No more lines will come.
  bool is_at_end() const { return is_closed_ && lines_.empty(); }
  bool has_line() const { return !lines_.empty(); }

 private:
  void Take(const char* bytes, std::size_t count);
  void EndLine();

  Io& io_;
  std::size_t longest_;
  std::deque<InputLine> lines_;
  InputLine begun_{1, "", false};
  bool is_closed_ = false;
};

}  // namespace plsc::cli
