// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/isolated.hpp"

#include <algorithm>
#include <cmath>

#include "optimization/fit/quantile.hpp"

namespace torquewright::identification {
namespace {

using optimization::nearest_quantile;

/// Fewer samples do not tell what is usual.
constexpr std::size_t kFewestForIsolated = 30;
/// The excursion must be this many times what 90 % of all samples deviate from their neighbours'
/// mean: in a quiet channel and in a noisy one alike. Smaller: the tails of noise are cut off.
constexpr double kTimesUsual = 8.0;
/// And this many times what 90 % of those around it do: a channel may be quiet for most of the run
/// and rough in one part.
constexpr double kTimesLocal = 6.0;
constexpr std::size_t kAround = 50;  ///< Samples on either side.
/// And this share of the channel's range: the last digit of a still sensor is no fault.
constexpr double kShareOfRange = 0.05;
/// And this many times the usual change from sample to sample, where there is one: a sensor of few
/// digits flickers between neighbouring values.
constexpr double kTimesChange = 3.0;
/// Before and after it the channel must agree within this share of the excursion: else it is an
/// edge, and edges are signal.
constexpr double kAgreement = 0.5;
constexpr std::size_t kFewestOfCrowd = 5;

/// How far each inner sample lies from the mean of its neighbours.
std::vector<double> deviations(const std::vector<double>& values, const Circle& circle) {
  std::vector<double> result(values.size() - 2);
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    const double before = circle.difference(values[i], values[i - 1]);
    const double after = circle.difference(values[i], values[i + 1]);
    result[i - 1] = std::abs(0.5 * (before + after));
  }
  return result;
}

/// The range without the outermost hundredth on both sides.
double usual_range(const std::vector<double>& values) {
  return nearest_quantile(values, 0.99) - nearest_quantile(values, 0.01);
}

/// The median of the changes from sample to sample that are not zero; 0 if all are.
double usual_change(const std::vector<double>& values, const Circle& circle) {
  std::vector<double> changes;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double change = std::abs(circle.difference(values[i - 1], values[i]));
    if (change > 0.0) changes.push_back(change);
  }
  return changes.empty() ? 0.0 : optimization::median(std::move(changes));
}

/// How far samples [begin, begin + length) lie outside of what stands before and after them, on one
/// side of it; 0 where they do not, or where these two disagree.
double excursion(const std::vector<double>& values, const Circle& circle, std::size_t begin,
                 std::size_t length) {
  const double before = values[begin - 1];
  const double step = circle.difference(before, values[begin + length]);
  double above = HUGE_VAL;
  double below = HUGE_VAL;
  for (std::size_t i = begin; i < begin + length; ++i) {
    const double off = circle.difference(before, values[i]);
    above = std::min(above, off - std::max(0.0, step));
    below = std::min(below, std::min(0.0, step) - off);
  }
  const double distance = std::max({above, below, 0.0});
  return std::abs(step) <= kAgreement * distance ? distance : 0.0;
}

double local_scale(const std::vector<double>& deviation, std::size_t at) {
  const std::size_t begin = at > kAround ? at - kAround : 0;
  const std::size_t end = std::min(deviation.size(), at + kAround);
  return nearest_quantile({deviation.begin() + static_cast<std::ptrdiff_t>(begin),
                           deviation.begin() + static_cast<std::ptrdiff_t>(end)},
                          0.9);
}

}  // namespace

double Circle::difference(double from, double to) const {
  return circumference > 0.0 ? std::remainder(to - from, circumference) : to - from;
}

IsolatedSamples find_isolated(const std::vector<double>& values, const Circle& circle) {
  IsolatedSamples found;
  if (values.size() < kFewestForIsolated) return found;
  const std::vector<double> deviation = deviations(values, circle);
  const double least =
      std::max({kTimesUsual * nearest_quantile(deviation, 0.9), kShareOfRange * usual_range(values),
                kTimesChange * usual_change(values, circle)});
  std::size_t count = 0;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    for (std::size_t length = 1; length <= 2 && i + length < values.size(); ++length) {
      const double distance = excursion(values, circle, i, length);
      if (distance <= least || distance == 0.0) continue;
      if (distance <= kTimesLocal * local_scale(deviation, i - 1)) continue;
      found.places.push_back({i, length});
      count += length;
      i += length;  // what follows is the return
      break;
    }
  }
  const auto most = static_cast<std::size_t>(kMostIsolated * static_cast<double>(values.size()));
  found.is_crowd = count > std::max(most, kFewestOfCrowd);
  return found;
}

void replace_isolated(const IsolatedSamples& isolated, const Circle& circle,
                      std::vector<double>& values) {
  for (const auto& [begin, length] : isolated.places) {
    const double before = values[begin - 1];
    const double step = circle.difference(before, values[begin + length]);
    for (std::size_t i = 0; i < length; ++i) {
      values[begin + i] =
          before + step * static_cast<double>(i + 1) / static_cast<double>(length + 1);
    }
  }
}

}  // namespace torquewright::identification
