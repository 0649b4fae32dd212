// A rate over a window that is long enough to have whole generations in it: at
// the end of a generation workers wait for its last robots, and a shorter
// window would jump between too fast and too slow. So it reaches back a minute,
// or to the beginning of the generation before this one, whichever is longer.
// Samples are kept at most ten a second.

#include "runtime/cli/running/pace.h"

#include <algorithm>

namespace plsc::cli {

namespace {

constexpr double kWindow = 60;  // s

// Closer samples change no rate that people could see.
constexpr double kSpacing = 0.1;  // s

}  // namespace

PaceMeter::PaceMeter(std::int64_t evaluations_before) {
  samples_.push_back({0, 0, evaluations_before, 0});
}

void PaceMeter::Add(double seconds, const Progress& progress) {
  if (progress.generation != last_.generation) {
    previous_begin_ = generation_begin_;
    generation_begin_ = seconds;
  }
  last_ = progress;
  const Sample sample = {seconds, progress.generation, progress.evaluations,
                         progress.simulated_seconds};
  if (samples_.size() > 1 && samples_.back().generation == sample.generation &&
      seconds - samples_[samples_.size() - 2].seconds < kSpacing)
    samples_.back() = sample;
  else
    samples_.push_back(sample);
  const double begin = WindowBegin(seconds);
  while (samples_.size() > 2 && samples_[1].seconds <= begin)
    samples_.pop_front();
}

double PaceMeter::WindowBegin(double seconds) const {
  return std::max(0.0, std::min(seconds - kWindow, previous_begin_));
}

Pace PaceMeter::At(double seconds) const {
  Pace pace;
  const Sample& first = samples_.front();
  const double window = seconds - first.seconds;
  const auto evaluations =
      static_cast<double>(last_.evaluations - first.evaluations);
  if (samples_.size() > 1 && window > 0 && evaluations > 0) {
    const double rate = evaluations / window;
    pace.evaluations_per_second = rate;
    pace.times_real =
        (last_.simulated_seconds - first.simulated_seconds) / window;
    pace.seconds_left =
        static_cast<double>(last_.total - last_.evaluations) / rate;
  }
  const auto seasons = static_cast<double>(last_.simulations + last_.looked_up);
  if (seasons > 0)
    pace.looked_up_share = static_cast<double>(last_.looked_up) / seasons;
  return pace;
}

}  // namespace plsc::cli
