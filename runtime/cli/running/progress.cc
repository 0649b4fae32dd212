// One line that fits, whatever the terminal: pieces have ranks, and where the
// line is too long it is first written briefly and then loses its pieces from
// the least important on. Redrawn at most five times a second; in a file, a
// line a generation or a minute. Clock and width are handed in, so that tests
// draw without waiting.

#include "runtime/cli/running/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <vector>

#include "grammar/shown_line.h"
#include "runtime/life/season_result.h"

namespace plsc::cli {

namespace {

// Fast enough to look alive, slow enough to cost nothing.
constexpr double kRedraw = 0.2;  // s

// Who looks at a log file wants to see that the run lives.
constexpr double kLogPause = 60;  // s

struct Piece {
  std::string text;
  std::string brief;  // where the whole line is too long
  int rank = 0;       // the highest is left out first; 0: never
};

// Seasons and their medians are left out from the last to the first, but the
// first season stays longer than most.
constexpr int kFirstSeason = 100;
constexpr int kFirstMedian = 1000;
constexpr int kBusy = 10'000;

void AddSeasons(const Progress& progress, std::vector<Piece>& pieces) {
  for (std::size_t i = 0; i < progress.seasons.size(); ++i) {
    const SeasonProgress& season = progress.seasons[i];
    const std::string name = Escaped(season.season);
    const bool is_own = progress.has_own_fitness;
    const std::string best = FitnessText(season.best, is_own);
    const std::string median = FitnessText(season.median, is_own);
    const int place = static_cast<int>(i);
    pieces.push_back({fmt::format("{} best {}", name, best),
                      fmt::format("{} {}", name, best),
                      i == 0 ? 2 : kFirstSeason + place});
    pieces.push_back({"median " + median, "med " + median,
                      i == 0 ? 4 : kFirstMedian + place});
  }
  const bool has_speeds =
      !progress.has_own_fitness &&
      std::any_of(progress.seasons.begin(), progress.seasons.end(),
                  [](const SeasonProgress& season) {
                    return IsSpeed(season.best) || IsSpeed(season.median);
                  });
  if (has_speeds) pieces.push_back({"cm/s", "cm/s", 2});
}

std::vector<Piece> PiecesOf(const Progress& progress, int generations,
                            const Pace& pace) {
  const auto counted = [](std::int64_t done, std::int64_t all) {
    return fmt::format("{}/{}", done, all);
  };
  const std::string generation = counted(progress.generation + 1, generations);
  const std::string robots = counted(progress.evaluations, progress.total);
  std::vector<Piece> pieces = {
      {"generation " + generation, "gen " + generation, 0},
      {robots + " evaluations", robots, 3}};
  const auto add = [&](const std::string& number, const char* unit,
                       const char* brief_unit, int rank) {
    pieces.push_back({number + unit, number + brief_unit, rank});
  };
  if (pace.evaluations_per_second)
    add(fmt::format("{:.1f}", *pace.evaluations_per_second), "/s", "/s", 1);
  if (pace.seconds_left)
    add(DurationText(*pace.seconds_left), " left", " left", 0);
  if (pace.times_real)
    add(fmt::format("{:.3g}", *pace.times_real), "x real time", "x real", 6);
  if (pace.looked_up_share)
    add(fmt::format("{:.0f}", 100 * *pace.looked_up_share), " % looked up",
        "% cached", 5);
  add(counted(progress.busy_workers, progress.workers), " busy", " busy",
      kBusy);
  AddSeasons(progress, pieces);
  return pieces;
}

std::string Join(const std::vector<Piece>& pieces, bool is_brief) {
  std::string text;
  for (const Piece& piece : pieces) {
    if (!text.empty()) text += "  ";
    text += is_brief ? piece.brief : piece.text;
  }
  return text;
}

}  // namespace

std::string DurationText(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  const long long hours = whole / 3600;
  const long long minutes = whole / 60 % 60;
  if (hours > 0)
    return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
  return fmt::format("{}:{:02}", minutes, whole % 60);
}

std::string ProgressText(const Progress& progress, int generations,
                         const Pace& pace, int width) {
  std::vector<Piece> pieces = PiecesOf(progress, generations, pace);
  const auto limit = static_cast<std::size_t>(std::max(0, width));
  std::string text = Join(pieces, false);
  if (limit == 0 || text.size() <= limit) return text;
  while ((text = Join(pieces, true)).size() > limit) {
    const int worst = std::max_element(pieces.begin(), pieces.end(),
                                       [](const Piece& a, const Piece& b) {
                                         return a.rank < b.rank;
                                       })
                          ->rank;
    if (worst == 0) return text.substr(0, limit);
    std::erase_if(pieces, [&](const Piece& one) { return one.rank == worst; });
  }
  return text;
}

int TerminalWidth() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    return size.ws_col;
  constexpr int kUsual = 80;
  const char* columns = std::getenv("COLUMNS");
  const int width = columns == nullptr ? 0 : std::atoi(columns);
  return width > 0 ? width : kUsual;
}

std::function<double()> Stopwatch() {
  using Clock = std::chrono::steady_clock;
  return [begin = Clock::now()] {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
}

ProgressLine::ProgressLine(std::ostream& out, bool is_terminal, int generations,
                           std::int64_t evaluations_before)
    : out_(out),
      is_terminal_(is_terminal),
      generations_(generations),
      clock_(Stopwatch()),
      width_(TerminalWidth),
      meter_(evaluations_before) {}

void ProgressLine::SetWorld(std::function<double()> clock,
                            std::function<int()> width) {
  clock_ = std::move(clock);
  width_ = std::move(width);
}

void ProgressLine::Report(const Progress& progress) {
  const double now = clock_();
  meter_.Add(now, progress);
  last_ = progress;
  has_progress_ = true;
  is_drawn_ = false;
  if (IsDue(now, progress.generation != drawn_generation_)) Draw(now);
}

void ProgressLine::Tick() {
  if (!has_progress_) return;
  const double now = clock_();
  if (IsDue(now, false)) Draw(now);
}

bool ProgressLine::IsDue(double now, bool is_new_generation) const {
  if (drawn_at_ < 0) return true;
  if (!is_terminal_) return is_new_generation || now - drawn_at_ >= kLogPause;
  return now - drawn_at_ >= kRedraw;
}

void ProgressLine::Draw(double now) {
  const Pace pace = meter_.At(now);
  if (is_terminal_) {
    // The last column stays free: some terminals go to the next line there.
    const int width = std::max(1, width_() - 1);
    const std::string text = ProgressText(last_, generations_, pace, width);
    // Blanks wipe what is left of a longer line, unless it got too narrow.
    const std::size_t wiped = std::min(std::max(drawn_width_, text.size()),
                                       static_cast<std::size_t>(width));
    out_ << fmt::format("\r{:<{}}", text, wiped) << std::flush;
    drawn_width_ = text.size();
  } else {
    out_ << ProgressText(last_, generations_, pace, 0) << std::endl;
  }
  drawn_generation_ = last_.generation;
  drawn_at_ = now;
  is_drawn_ = true;
}

void ProgressLine::Finish() {
  if (!has_progress_) return;
  if (!is_drawn_) Draw(clock_());
  if (is_terminal_) out_ << std::endl;
  has_progress_ = false;
}

}  // namespace plsc::cli
