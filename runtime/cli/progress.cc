#include "runtime/cli/progress.h"

#include <fmt/format.h>

#include <cmath>
#include <ostream>

namespace plsc::cli {

namespace {

// Fast enough to look alive, slow enough to cost nothing.
constexpr double kRedraw = 0.2;  // s

std::string SpeedText(const std::optional<double>& fitness) {
  constexpr double kCentimetres = 100;  // the paper's unit of Speed
  return fitness ? fmt::format("{:.2f}", kCentimetres * *fitness) : "none";
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
                         double seconds) {
  std::string text = fmt::format("generation {}/{}  evaluations {}/{}",
                                 progress.generation + 1, generations,
                                 progress.evaluations, progress.total);
  if (progress.evaluations > 0 && seconds > 0) {
    const double rate = static_cast<double>(progress.evaluations) / seconds;
    const auto left =
        static_cast<double>(progress.total - progress.evaluations);
    text += fmt::format("  {:.1f}/s  {} left", rate, DurationText(left / rate));
  }
  text += fmt::format("  {}/{} busy", progress.busy_workers, progress.workers);
  if (!progress.seasons.empty()) text += "  best";
  for (const SeasonProgress& season : progress.seasons)
    text += fmt::format(" {} {}", season.season, SpeedText(season.best));
  if (!progress.seasons.empty()) text += " cm/s";
  return text;
}

ProgressLine::ProgressLine(std::ostream& out, bool is_terminal, int generations)
    : out_(out),
      is_terminal_(is_terminal),
      generations_(generations),
      begin_(std::chrono::steady_clock::now()) {}

double ProgressLine::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                       begin_)
      .count();
}

void ProgressLine::Show(const Progress& progress) {
  const double now = seconds();
  if (is_terminal_) {
    const bool is_last = progress.evaluations == progress.total;
    if (!is_last && shown_at_ >= 0 && now - shown_at_ < kRedraw) return;
    const std::string text = ProgressText(progress, generations_, now);
    // Blanks wipe what is left of a longer line.
    const std::size_t width = std::max(shown_width_, text.size());
    out_ << fmt::format("\r{:<{}}", text, width) << std::flush;
    shown_width_ = text.size();
  } else {
    if (progress.generation == shown_generation_) return;
    out_ << ProgressText(progress, generations_, now) << std::endl;
    shown_generation_ = progress.generation;
  }
  shown_at_ = now;
}

void ProgressLine::Finish() {
  if (is_terminal_ && shown_at_ >= 0) out_ << std::endl;
}

}  // namespace plsc::cli
