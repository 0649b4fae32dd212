#include "runtime/cli/running/lives_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <utility>

#include "grammar/shown_line.h"
#include "runtime/cli/running/progress.h"

namespace plsc::cli {

namespace {

constexpr double kTerminalPause = 0.2;  // s
constexpr double kFilePause = 60;       // s

}  // namespace

LivesLine::LivesLine(std::ostream& out, bool is_terminal, bool is_quiet)
    : out_(out),
      is_terminal_(is_terminal),
      is_quiet_(is_quiet),
      clock_(Stopwatch()),
      width_(TerminalWidth) {}

void LivesLine::SetWorld(std::function<double()> clock,
                         std::function<int()> width) {
  clock_ = std::move(clock);
  width_ = std::move(width);
}

std::string LivesLine::TextAt(double now) const {
  std::string text;
  if (last_.runs > 1)
    text = fmt::format("run {}/{} ", last_.run + 1, last_.runs);
  text += fmt::format("{}  {}/{} lives", Escaped(last_.label), last_.done,
                      last_.total);
  const auto lived = static_cast<double>(before_ + last_.done);
  if (lived == 0 || now <= 0) return text;
  const double rate = lived / now;
  const auto runs_left = static_cast<double>(last_.runs - last_.run - 1);
  const double left = static_cast<double>(last_.total - last_.done) +
                      runs_left * static_cast<double>(last_.total);
  return text +
         fmt::format("  {:.1f}/s  {} left", rate, DurationText(left / rate));
}

void LivesLine::Report(const LivesProgress& progress) {
  if (progress.run != last_.run) before_ += last_.done;
  last_ = progress;
  if (is_quiet_) return;
  const double now = clock_();
  const double pause = is_terminal_ ? kTerminalPause : kFilePause;
  if (drawn_at_ >= 0 && now - drawn_at_ < pause) return;
  drawn_at_ = now;
  std::string text = TextAt(now);
  if (!is_terminal_) {
    out_ << text << std::endl;
    return;
  }
  // The last column stays free: some terminals go to the next line there.
  const auto width = static_cast<std::size_t>(std::max(1, width_() - 1));
  if (text.size() > width) text.resize(width);
  const std::size_t wiped =
      std::min(std::max(drawn_width_, text.size()), width);
  out_ << fmt::format("\r{:<{}}", text, wiped) << std::flush;
  drawn_width_ = text.size();
}

void LivesLine::Finish() {
  if (is_terminal_ && drawn_width_ > 0)
    out_ << fmt::format("\r{:<{}}\r", "", drawn_width_) << std::flush;
  drawn_width_ = 0;
}

}  // namespace plsc::cli
