// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/signal.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "optimization/fit/quantile.hpp"

namespace torquewright::identification {
namespace {

constexpr double kPassesAllAbove = 0.45;  ///< Of the sampling rate.
constexpr double kMadToDeviation = 1.4826;
constexpr std::size_t kLeastOfNoise = 16;       ///< Samples.
constexpr double kFifthDifferenceNorm = 252.0;  ///< Sum of the squares of 1 5 10 10 5 1.

constexpr std::size_t kOfDifference = 6;  ///< Samples of a fifth difference.
constexpr double kEven = 1e-6;            ///< Of a step: times that differ by less are even.
/// Of the distance of the two samples around a time: the next on either side are no nearer.
constexpr double kNextSample = 0.5;

double linear_at(std::span<const double> time_s, std::span<const double> signal, std::size_t at,
                 double t_s) {
  const double share = std::clamp((t_s - time_s[at]) / (time_s[at + 1] - time_s[at]), 0.0, 1.0);
  return signal[at] + share * (signal[at + 1] - signal[at]);
}

/// The samples of a cubic between `at` and the next; nothing next to an end.
std::optional<std::array<std::size_t, 4>> four_around(std::span<const double> time_s,
                                                      std::size_t at) {
  const double apart_s = kNextSample * (time_s[at + 1] - time_s[at]);
  std::size_t before = at, after = at + 1;
  while (before > 0 && (before == at || time_s[at] - time_s[before] < apart_s)) --before;
  while (after + 1 < time_s.size() &&
         (after == at + 1 || time_s[after] - time_s[at + 1] < apart_s)) {
    ++after;
  }
  if (time_s[at] - time_s[before] < apart_s || time_s[after] - time_s[at + 1] < apart_s) return {};
  return std::array{before, at, at + 1, after};
}

double lagrange(std::span<const double> time_s, std::span<const double> signal,
                const std::array<std::size_t, 4>& four, double t_s) {
  double value = 0.0;
  for (const std::size_t i : four) {
    double weight = 1.0;
    for (const std::size_t j : four) {
      if (j != i) weight *= (t_s - time_s[j]) / (time_s[i] - time_s[j]);
    }
    value += weight * signal[i];
  }
  return value;
}

bool are_even(std::span<const double> time_s) {
  const double step_s = (time_s.back() - time_s.front()) / static_cast<double>(time_s.size() - 1);
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    if (std::abs(time_s[i] - time_s[i - 1] - step_s) > kEven * step_s) return false;
  }
  return true;
}

/// Fifth difference of six samples over the norm of its weights.
double even_difference(std::span<const double> six) {
  return (six[5] - 5.0 * six[4] + 10.0 * six[3] - 10.0 * six[2] + 5.0 * six[1] - six[0]) /
         std::sqrt(kFifthDifferenceNorm);
}

double divided_difference(std::span<const double> time_s, std::span<const double> six) {
  double difference = 0.0, square = 0.0;
  const double span_s = time_s.back() - time_s.front();
  for (std::size_t i = 0; i < six.size(); ++i) {
    double weight = 1.0;
    for (std::size_t j = 0; j < six.size(); ++j) {
      if (j != i) weight *= span_s / (time_s[i] - time_s[j]);
    }
    difference += weight * six[i];
    square += weight * weight;
  }
  return difference / std::sqrt(square);
}

double deviation_of(std::vector<double> differences) {
  for (double& each : differences) each = std::abs(each);
  return kMadToDeviation * optimization::median(std::move(differences));
}

}  // namespace

LowPass::LowPass(double cutoff_Hz, double rate_Hz) : rate_Hz_(rate_Hz) {
  if (cutoff_Hz >= kPassesAllAbove * rate_Hz) {
    passes_all_ = true;
    return;
  }
  const double k = std::tan(std::numbers::pi * cutoff_Hz / rate_Hz);
  bent_cutoff_ = k;
  const double norm = 1.0 / (1.0 + std::numbers::sqrt2 * k + k * k);
  b0_ = k * k * norm;
  b1_ = 2.0 * b0_;
  b2_ = b0_;
  a1_ = 2.0 * (k * k - 1.0) * norm;
  a2_ = (1.0 - std::numbers::sqrt2 * k + k * k) * norm;
  // The poles' envelope is exp(-2 pi f t / sqrt 2); it falls to 1 % in about this time.
  settling_ = static_cast<std::size_t>(std::ceil(1.1 * rate_Hz / cutoff_Hz));
}

double LowPass::gain(double frequency_Hz) const {
  if (frequency_Hz >= 0.5 * rate_Hz_) return 0.0;
  if (passes_all_) return 1.0;
  const double bent = std::tan(std::numbers::pi * frequency_Hz / rate_Hz_) / bent_cutoff_;
  return 1.0 / (1.0 + bent * bent * bent * bent);
}

template <typename Iterator>
void LowPass::pass(Iterator begin, Iterator end) const {
  // Starts as if the first value had stood for ever.
  double x1 = *begin, x2 = x1, y1 = x1, y2 = x1;
  for (Iterator value = begin; value != end; ++value) {
    const double x = *value;
    const double y = b0_ * x + b1_ * x1 + b2_ * x2 - a1_ * y1 - a2_ * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    *value = y;
  }
}

void LowPass::apply(std::vector<double>& signal) const {
  if (passes_all_ || signal.size() < 2) return;
  const std::size_t pad = std::min(settling_, signal.size() - 1);
  std::vector<double> padded;
  padded.reserve(signal.size() + 2 * pad);
  for (std::size_t i = pad; i > 0; --i) padded.push_back(2.0 * signal.front() - signal[i]);
  padded.insert(padded.end(), signal.begin(), signal.end());
  const std::size_t last = signal.size() - 1;
  for (std::size_t i = 1; i <= pad; ++i) padded.push_back(2.0 * signal[last] - signal[last - i]);
  pass(padded.begin(), padded.end());
  pass(padded.rbegin(), padded.rend());
  std::copy_n(padded.begin() + static_cast<std::ptrdiff_t>(pad), signal.size(), signal.begin());
}

std::vector<double> derivative(std::span<const double> signal, double step_s) {
  const std::size_t n = signal.size();
  std::vector<double> slope(n);
  for (std::size_t i = 2; i + 2 < n; ++i) {
    slope[i] = (signal[i - 2] - 8.0 * signal[i - 1] + 8.0 * signal[i + 1] - signal[i + 2]) /
               (12.0 * step_s);
  }
  const auto one_sided = [&](std::size_t i, std::size_t j, std::size_t k, double sign) {
    return sign * (-3.0 * signal[i] + 4.0 * signal[j] - signal[k]) / (2.0 * step_s);
  };
  slope[0] = one_sided(0, 1, 2, 1.0);
  slope[1] = one_sided(1, 2, 3, 1.0);
  slope[n - 1] = one_sided(n - 1, n - 2, n - 3, -1.0);
  slope[n - 2] = one_sided(n - 2, n - 3, n - 4, -1.0);
  return slope;
}

std::vector<double> resampled_linearly(std::span<const double> time_s,
                                       std::span<const double> signal, double start_s,
                                       double step_s, std::size_t count) {
  std::vector<double> values(count);
  std::size_t at = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double t_s = start_s + static_cast<double>(k) * step_s;
    while (at + 2 < time_s.size() && time_s[at + 1] < t_s) ++at;
    values[k] = linear_at(time_s, signal, at, t_s);
  }
  return values;
}

std::vector<double> resampled(std::span<const double> time_s, std::span<const double> signal,
                              double start_s, double step_s, std::size_t count) {
  std::vector<double> values(count);
  std::size_t at = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double t_s = start_s + static_cast<double>(k) * step_s;
    while (at + 2 < time_s.size() && time_s[at + 1] < t_s) ++at;
    const auto four = four_around(time_s, at);
    values[k] = four ? lagrange(time_s, signal, *four, t_s) : linear_at(time_s, signal, at, t_s);
  }
  return values;
}

double cubic_between(std::span<const double> four, double share) {
  const std::array<double, 4> weight = cubic_weights(share);
  return weight[0] * four[0] + weight[1] * four[1] + weight[2] * four[2] + weight[3] * four[3];
}

std::array<double, 4> cubic_weights(double share) {
  const double s = share, b = s - 1.0, c = s - 2.0, a = s + 1.0;
  return {-s * b * c / 6.0, a * b * c / 2.0, -(a * s * c) / 2.0, a * s * b / 6.0};
}

std::vector<double> advanced(std::span<const double> signal, double delay_s, double step_s) {
  const double steps = delay_s / step_s;
  const double last = static_cast<double>(signal.size() - 1);
  std::vector<double> values(signal.size());
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const double place = std::clamp(static_cast<double>(i) + steps, 0.0, last);
    const auto below = std::min(static_cast<std::size_t>(place), signal.size() - 2);
    const double share = place - static_cast<double>(below);
    values[i] = below > 0 && below + 2 < signal.size()
                    ? cubic_between(signal.subspan(below - 1, 4), share)
                    : signal[below] + share * (signal[below + 1] - signal[below]);
  }
  return values;
}

double noise_level(std::span<const double> signal) {
  if (signal.size() < kLeastOfNoise) return 0.0;
  std::vector<double> differences(signal.size() - kOfDifference + 1);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    differences[i] = even_difference(signal.subspan(i, kOfDifference));
  }
  return deviation_of(std::move(differences));
}

double noise_level(std::span<const double> time_s, std::span<const double> signal) {
  if (signal.size() < kLeastOfNoise) return 0.0;
  std::vector<double> differences(signal.size() - kOfDifference + 1);
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const auto times_s = time_s.subspan(i, kOfDifference);
    const auto six = signal.subspan(i, kOfDifference);
    differences[i] = are_even(times_s) ? even_difference(six) : divided_difference(times_s, six);
  }
  return deviation_of(std::move(differences));
}

}  // namespace torquewright::identification
