// SPDX-License-Identifier: Apache-2.0
#include "identification/draft/numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "optimization/fit/quantile.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kLeastRows = 10;
constexpr double kLeastEvenShare = 0.9;
constexpr double kLeastRate_Hz = 5.0;
constexpr double kMostRate_Hz = 1e5;
constexpr double kOfATurn = 0.1;  ///< By which a jump may miss a whole turn.
constexpr double kSameToA = 1e-3;

std::vector<double> steps_of(const Series& series) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < series.size(); ++i) {
    const double step = series[i] - series[i - 1];
    if (std::isfinite(step)) steps.push_back(step);
  }
  return steps;
}

/// Sums of a straight line through points, about their means.
class Line {
 public:
  void add(double x, double y) {
    ++count_;
    x_ += x;
    y_ += y;
    xx_ += x * x;
    xy_ += x * y;
    yy_ += y * y;
  }
  std::size_t count() const { return count_; }
  double varying_x() const { return xx_ - x_ * x_ / static_cast<double>(count_); }
  double varying_y() const { return yy_ - y_ * y_ / static_cast<double>(count_); }
  double common() const { return xy_ - x_ * y_ / static_cast<double>(count_); }

 private:
  std::size_t count_ = 0;
  double x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;
};

/// Jumps by a whole turn; none where other steps are greater than a quarter of one.
std::size_t jumps_by(const std::vector<double>& steps, double turn) {
  std::size_t jumps = 0;
  for (const double step : steps) {
    const bool is_jump = std::abs(std::abs(step) - turn) < kOfATurn * turn;
    if (is_jump) ++jumps;
    if (!is_jump && std::abs(step) > 0.25 * turn) return 0;
  }
  return jumps;
}

}  // namespace

bool looks_like_time(const Series& series) {
  const std::vector<double> steps = steps_of(series);
  if (steps.size() < kLeastRows || steps.size() + 1 < series.size()) return false;
  if (*std::min_element(steps.begin(), steps.end()) <= 0.0) return false;
  const double median = optimization::lower_quantile(steps, 0.5);
  const auto even = std::count_if(steps.begin(), steps.end(), [&](double step) {
    return std::abs(step - median) <= 0.5 * median;
  });
  return static_cast<double>(even) >= kLeastEvenShare * static_cast<double>(steps.size());
}

std::vector<std::size_t> falls_of(const Series& series) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 1; i < series.size(); ++i) {
    if (series[i] < series[i - 1]) rows.push_back(i);
  }
  return rows;
}

std::optional<io::Unit> unit_of_time(const Series& time) {
  std::vector<double> steps = steps_of(time);
  std::erase_if(steps, [](double step) { return step <= 0.0; });
  if (steps.empty()) return std::nullopt;
  const double median = optimization::lower_quantile(steps, 0.5);
  for (const char* name : {"s", "ms", "us", "ns"}) {
    const std::optional<io::Unit> unit = io::find_unit(name);
    const double rate_Hz = 1.0 / (median * unit->in_SI);
    if (rate_Hz >= kLeastRate_Hz && rate_Hz <= kMostRate_Hz) return unit;
  }
  return std::nullopt;
}

std::optional<io::Unit> unit_by_turns(const Series& angle) {
  const std::vector<double> steps = steps_of(angle);
  for (const char* name : {"rad", "deg", "rev"}) {
    const std::optional<io::Unit> unit = io::find_unit(name);
    if (jumps_by(steps, 2.0 * std::numbers::pi / unit->in_SI) >= 2) return unit;
  }
  return std::nullopt;
}

std::optional<Slope> slope_between(const Series& time_s, const Series& position,
                                   const Series& velocity) {
  Line line;
  for (std::size_t i = 1; i + 1 < time_s.size(); ++i) {
    const double step_s = time_s[i + 1] - time_s[i - 1];
    const double rate = (position[i + 1] - position[i - 1]) / step_s;
    if (step_s > 0.0 && std::isfinite(rate) && std::isfinite(velocity[i])) {
      line.add(rate, velocity[i]);
    }
  }
  if (line.count() < kLeastRows || !(line.varying_x() > 0.0) || !(line.varying_y() > 0.0)) {
    return std::nullopt;
  }
  return Slope{line.common() / line.varying_x(),
               line.common() / std::sqrt(line.varying_x() * line.varying_y())};
}

bool is_multiple(const Series& one, const Series& other) {
  double squares = 0.0, products = 0.0, other_squares = 0.0;
  std::size_t rows = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (!std::isfinite(one[i]) || !std::isfinite(other[i])) continue;
    ++rows;
    squares += one[i] * one[i];
    products += one[i] * other[i];
    other_squares += other[i] * other[i];
  }
  if (rows < kLeastRows || squares == 0.0 || other_squares == 0.0) return false;
  // What the best factor leaves of the one, as a share of its size.
  const double left = squares - products * products / other_squares;
  return left <= kSameToA * kSameToA * squares;
}

}  // namespace torquewright::identification
