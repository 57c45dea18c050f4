// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/window_load.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kRoundOff = 1e-12;
constexpr double kSameInstant = 1e-9;  // of the window: the rounding of its two ends

class Windows {
 public:
  Windows(const LoadSignal& signal, double window_s)
      : signal_(signal), window_s_(window_s), slack_s_(kSameInstant * window_s) {
    const Index samples = signal.values.size();
    integral_.setZero(samples);
    impulse_.setZero(samples + 1);
    doubt_.setZero(samples);
    bend_.setZero(samples);
    for (Index i = 0; i < samples; ++i) {
      impulse_[i + 1] = impulse_[i] + signal.impulses[i];
      if (i == 0) continue;
      integral_[i] =
          integral_[i - 1] + 0.5 * length_s(i - 1) * (signal.values[i - 1] + signal.values[i]);
      doubt_[i] = doubt_[i - 1] + signal.doubts[i];
      bend_[i] = bend_[i - 1] + signal.bends[i];
    }
  }

  WindowLoad greatest() {
    const std::vector<double> begins_s = begins();
    for (std::size_t i = 0; i < begins_s.size(); ++i) {
      note(begins_s[i]);
      if (i > 0) note_between(begins_s[i - 1], begins_s[i]);
    }
    return load_;
  }

 private:
  double time_s(Index sample) const { return signal_.times_s[static_cast<std::size_t>(sample)]; }
  double length_s(Index interval) const { return time_s(interval + 1) - time_s(interval); }

  /// The interval that holds the time, which is not before the first sample; at most the last one.
  Index interval_of(double time) const {
    const auto above = std::upper_bound(signal_.times_s.begin(), signal_.times_s.end(), time);
    return std::clamp<Index>(above - signal_.times_s.begin() - 1, 0, signal_.values.size() - 2);
  }

  double value_at(Index interval, double time) const {
    const double share = (time - time_s(interval)) / length_s(interval);
    return signal_.values[interval] + share * slope(interval) * length_s(interval);
  }

  double slope(Index interval) const {
    const double length = length_s(interval);
    return length > 0.0 ? (signal_.values[interval + 1] - signal_.values[interval]) / length : 0.0;
  }

  double integral_until(double time) const {
    const Index interval = interval_of(time);
    const double inside_s = std::min(time - time_s(interval), length_s(interval));
    return integral_[interval] + inside_s * signal_.values[interval] +
           0.5 * inside_s * inside_s * slope(interval);
  }

  /// Where windows begin or end at a sample, ascending; between them nothing bends.
  std::vector<double> begins() const {
    const double last_s = signal_.times_s.back() - window_s_;
    std::vector<double> begins_s;
    std::ptrdiff_t at_samples = 0;
    for (const double before_s : {0.0, window_s_}) {
      at_samples = static_cast<std::ptrdiff_t>(begins_s.size());
      for (const double time : signal_.times_s) {
        const double begin_s = time - before_s;
        if (begin_s >= signal_.times_s.front() && begin_s <= last_s) begins_s.push_back(begin_s);
      }
    }
    std::inplace_merge(begins_s.begin(), begins_s.begin() + at_samples, begins_s.end());
    begins_s.push_back(std::max(signal_.times_s.front(), last_s));
    return begins_s;
  }

  /// The integral is extreme where both ends have one value.
  void note_between(double from_s, double until_s) {
    if (until_s - from_s <= slack_s_) return;
    const double middle_s = 0.5 * (from_s + until_s);
    const Index begin = interval_of(middle_s);
    const Index end = interval_of(middle_s + window_s_);
    const double gap = value_at(end, middle_s + window_s_) - value_at(begin, middle_s);
    const double rate = slope(end) - slope(begin);
    if (rate == 0.0) return;
    const double extreme_s = middle_s - gap / rate;
    if (extreme_s > from_s && extreme_s < until_s) note(extreme_s);
  }

  void note(double begin_s) {
    const double end_s = begin_s + window_s_;
    const auto& times_s = signal_.times_s;
    // First sample in the window and first after it, both ends counting as inside.
    const Index first =
        std::lower_bound(times_s.begin(), times_s.end(), begin_s - slack_s_) - times_s.begin();
    const Index after =
        std::upper_bound(times_s.begin(), times_s.end(), end_s + slack_s_) - times_s.begin();
    const double steady = std::abs(integral_until(end_s) - integral_until(begin_s)) / window_s_;
    const double mean = steady + (impulse_[after] - impulse_[first]) / window_s_;
    const double doubt = doubt_of(begin_s, end_s, first, after) / window_s_;
    if (mean > load_.mean * (1.0 + kRoundOff) || !has_any_) {  // the first of those alike
      load_.mean = mean;
      load_.time_s = begin_s;
      load_.without_impulses = steady;
      load_.doubt = doubt;
    }
    load_.least = std::max(load_.least, mean - doubt);
    load_.most = std::max(load_.most, mean + doubt);
    has_any_ = true;
  }

  /// What lies in it whole adds up; of what it cuts, all may lie on either side.
  double doubt_of(double begin_s, double end_s, Index first, Index after) const {
    const auto whole = [&](Index interval) {
      return std::abs(signal_.doubts[interval]) + signal_.bends[interval];
    };
    if (after <= first) return whole(after);  // between two samples
    double doubt = std::abs(doubt_[after - 1] - doubt_[first]) + bend_[after - 1] - bend_[first];
    if (begin_s < time_s(first) - slack_s_) doubt += whole(first);
    if (end_s > time_s(after - 1) + slack_s_) doubt += whole(after);
    return doubt;
  }

  const LoadSignal& signal_;
  double window_s_;
  double slack_s_;
  Eigen::VectorXd integral_;
  Eigen::VectorXd impulse_;  ///< Before a sample.
  Eigen::VectorXd doubt_;
  Eigen::VectorXd bend_;
  WindowLoad load_;
  bool has_any_ = false;
};

}  // namespace

WindowLoad greatest_window(const LoadSignal& signal, double window_s) {
  const double duration_s = signal.times_s.back() - signal.times_s.front();
  if (duration_s > 0.0) return Windows(signal, std::min(window_s, duration_s)).greatest();
  WindowLoad load;
  load.time_s = signal.times_s.front();
  load.mean = load.without_impulses = signal.values.cwiseAbs().maxCoeff();
  load.least = load.most = load.mean;
  return load;
}

}  // namespace torquewright::hopper
