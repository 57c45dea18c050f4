// SPDX-License-Identifier: Apache-2.0
#include "hopper/record/step_window.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kAlike = 1e-12;       // of a mean: rounding
constexpr double kSameInstant = 1e-9;  // of the window: the rounding of its two ends

class StepWindows {
 public:
  StepWindows(const StepSignal& signal, double window_s)
      : signal_(signal), window_s_(window_s), slack_s_(kSameInstant * window_s) {
    const Index steps = signal.values.size();
    integral_.setZero(steps + 1);
    impulse_.setZero(steps + 1);
    for (Index k = 0; k < steps; ++k) {
      integral_[k + 1] = integral_[k] + signal.values[k] * (time_s(k + 1) - time_s(k));
      impulse_[k + 1] = impulse_[k] + signal.impulses[k];
    }
  }

  /// The integral is straight in the window's begin but where an end of it passes a step's: the
  /// greatest is among those.
  WindowLoad greatest() {
    // A window as long as the run, rounded, would begin before it.
    const double last_s = std::max(signal_.times_s.front(), signal_.times_s.back() - window_s_);
    for (const double before_s : {0.0, window_s_}) {
      begin_ = end_ = 0;
      for (const double time : signal_.times_s) {
        const double begin_s = time - before_s;
        if (begin_s >= signal_.times_s.front() - slack_s_ && begin_s <= last_s + slack_s_) {
          note(std::clamp(begin_s, signal_.times_s.front(), last_s));
        }
      }
    }
    load_.least = load_.most = load_.mean;
    return load_;
  }

 private:
  double time_s(Index at) const { return signal_.times_s[static_cast<std::size_t>(at)]; }

  /// The step that holds the time, not before the one that held the last: they ascend.
  void advance(Index& step, double time) const {
    while (step + 1 < signal_.values.size() && time_s(step + 1) <= time) ++step;
  }
  double integral_until(Index step, double time) const {
    return integral_[step] + signal_.values[step] * (time - time_s(step));
  }
  /// Of the impulses that come no later.
  double impulses_until(Index step, double time) const {
    return time_s(step + 1) <= time ? impulse_[step + 1] : impulse_[step];
  }

  void note(double begin_s) {
    const double end_s = begin_s + window_s_;
    advance(begin_, begin_s - slack_s_);
    const double before = impulse_[begin_];
    const double from = integral_until(begin_, begin_s);
    advance(end_, end_s + slack_s_);
    const double impulses = impulses_until(end_, end_s + slack_s_) - before;
    const double steady = std::abs(integral_until(end_, end_s) - from) / window_s_;
    const double mean = steady + impulses / window_s_;
    const bool is_alike = std::abs(mean - load_.mean) <= kAlike * load_.mean;
    if (has_any_ && (is_alike ? begin_s >= load_.time_s : mean < load_.mean)) return;
    load_.mean = mean;
    load_.time_s = begin_s;
    load_.without_impulses = steady;
    has_any_ = true;
  }

  const StepSignal& signal_;
  double window_s_;
  double slack_s_;
  Eigen::VectorXd integral_;  ///< Until a step begins,
  Eigen::VectorXd impulse_;   ///< impulses at that instant included.
  Index begin_ = 0;           ///< The steps of the window's two ends.
  Index end_ = 0;
  WindowLoad load_;
  bool has_any_ = false;
};

}  // namespace

WindowLoad greatest_step_window(const StepSignal& signal, double window_s) {
  const double duration_s = signal.times_s.back() - signal.times_s.front();
  return StepWindows(signal, std::min(window_s, duration_s)).greatest();
}

}  // namespace torquewright::hopper
