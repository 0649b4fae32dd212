#pragma once

// The line that shows how far lives that are lived again are: drawn anew on a
// terminal, one a minute elsewhere.

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>

namespace plsc::cli {

struct LivesProgress {
  std::size_t run = 0;  ///< from 0, of so many:
  std::size_t runs = 1;
  std::string label;
  std::int64_t done = 0;  ///< lives of this run, of those to be lived now
  std::int64_t total = 0;
};

class LivesLine {
 public:
  LivesLine(std::ostream& out, bool is_terminal, bool is_quiet);

  void Report(const LivesProgress& progress);
  /// Goes to the next line, if there is one.
  void Finish();

  /// For tests.
  void SetWorld(std::function<double()> clock, std::function<int()> width);

 private:
  /// "run 2/4 plastic/2  74/200 lives  12.3/s  0:32 left". What is left is of
  /// all runs, those to come taken to need as many lives as this one.
  std::string TextAt(double now) const;

  std::ostream& out_;
  bool is_terminal_;
  bool is_quiet_;
  std::function<double()> clock_;
  std::function<int()> width_;
  LivesProgress last_;
  std::int64_t before_ = 0;  // lives of the runs before this one
  double drawn_at_ = -1;
  std::size_t drawn_width_ = 0;
};

}  // namespace plsc::cli
