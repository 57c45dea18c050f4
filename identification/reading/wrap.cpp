// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/wrap.hpp"

#include <algorithm>
#include <cmath>

#include "optimization/fit/quantile.hpp"

namespace torquewright::identification {
namespace {

/// Isolated samples may lie anywhere; so many of the outermost are not looked at, on each side.
constexpr double kOutermost = 0.002;
/// Of a turn: sensors that reach a little beyond it.
constexpr double kSlack = 0.01;
/// Of a turn: what starts anew comes near both its ends.
constexpr double kLeastRange = 0.9;

}  // namespace

WrapEvidence::WrapEvidence(std::size_t most_values, double turn)
    : turn_(turn), upper_(most_values, 1.0 - kOutermost), lower_(most_values, 1.0 - kOutermost) {}

void WrapEvidence::add(const std::vector<double>& values) {
  for (const double value : values) {
    jumps_ = jumps_ || (upper_.count() > 0 && std::abs(value - previous_) > 0.5 * turn_);
    previous_ = value;
    upper_.add(value);
    lower_.add(-value);
  }
}

bool WrapEvidence::is_wrapped() const {
  if (!jumps_) return false;
  const double range = upper_.quantile(1.0 - kOutermost) + lower_.quantile(1.0 - kOutermost);
  return range > kLeastRange * turn_ && range < (1.0 + kSlack) * turn_;
}

bool is_wrapped(const std::vector<double>& values, double turn) {
  bool jumps = false;
  for (std::size_t i = 1; i < values.size() && !jumps; ++i) {
    jumps = std::abs(values[i] - values[i - 1]) > 0.5 * turn;
  }
  if (!jumps) return false;
  const double range = optimization::nearest_quantile(values, 1.0 - kOutermost) -
                       optimization::nearest_quantile(values, kOutermost);
  return range > kLeastRange * turn && range < (1.0 + kSlack) * turn;
}

std::vector<std::size_t> unwrap(std::vector<double>& values, double turn) {
  std::vector<std::size_t> jumps;
  double turns = 0.0;
  double previous = values.front();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = values[i];
    const double jumped = std::round((value - previous) / turn);
    if (jumped != 0.0) jumps.push_back(i);
    turns -= jumped;
    previous = value;
    values[i] = value + turns * turn;
  }
  return jumps;
}

std::optional<std::size_t> find_ambiguous_step(const std::vector<double>& values, double turn) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (std::abs(std::remainder(values[i] - values[i - 1], turn)) > 0.25 * turn) return i;
  }
  return std::nullopt;
}

}  // namespace torquewright::identification
