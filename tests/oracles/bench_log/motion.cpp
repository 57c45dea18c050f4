// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/bench_log/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace torquewright::oracles {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

double time_s(std::size_t knot) { return kTick_s * static_cast<double>(knot); }

Knots to_peak_of_one(Knots knots) {
  double peak = 0.0;
  for (const double value : knots) peak = std::max(peak, std::abs(value));
  return peak > 0.0 ? scaled(std::move(knots), 1.0 / peak) : knots;
}

}  // namespace

std::size_t knot_count(double duration_s) {
  return static_cast<std::size_t>(std::lround(duration_s / kTick_s)) + 1;
}

Knots multisine(Chance& chance, std::size_t count, double least_Hz, double most_Hz, int sines) {
  Knots knots(count, 0.0);
  for (int sine = 0; sine < sines; ++sine) {
    const double share = (sine + chance.between(0.2, 0.8)) / sines;
    const double rate = kTurn * least_Hz * std::pow(most_Hz / least_Hz, share);
    const double phase = chance.phase();
    const double weight = 1.0 / (1.0 + share);
    for (std::size_t k = 0; k < count; ++k) {
      knots[k] += weight * std::sin(rate * time_s(k) + phase);
    }
  }
  return to_peak_of_one(std::move(knots));
}

Knots chirp(std::size_t count, double first_Hz, double last_Hz) {
  Knots knots(count);
  const double length_s = time_s(count - 1);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = time_s(k);
    knots[k] = std::sin(kTurn * (first_Hz * t + 0.5 * (last_Hz - first_Hz) * t * t / length_s));
  }
  return knots;
}

Knots triangle(Chance& chance, std::size_t count, double period_s) {
  Knots knots(count);
  const double start = chance.share();
  for (std::size_t k = 0; k < count; ++k) {
    const double turn = start + time_s(k) / period_s;
    knots[k] = 4.0 * std::abs(turn - std::floor(turn) - 0.5) - 1.0;
  }
  return knots;
}

Knots sine(Chance& chance, std::size_t count, double frequency_Hz) {
  Knots knots(count);
  const double phase = chance.phase();
  for (std::size_t k = 0; k < count; ++k) {
    knots[k] = std::sin(kTurn * frequency_Hz * time_s(k) + phase);
  }
  return knots;
}

Knots steps(Chance& chance, std::size_t count, double hold_s) {
  Knots knots(count);
  constexpr double kEdge_s = 0.06;
  double from = 0.0;
  double to = chance.between(-1.0, 1.0);
  double since_s = 0.0;
  double hold_now_s = hold_s * chance.between(0.5, 1.5);
  for (std::size_t k = 0; k < count; ++k, since_s += kTick_s) {
    if (since_s >= hold_now_s) {
      from = to;
      to = chance.between(-1.0, 1.0);
      since_s = 0.0;
      hold_now_s = hold_s * chance.between(0.5, 1.5);
    }
    const double share = std::min(1.0, since_s / kEdge_s);
    knots[k] = from + (to - from) * 0.5 * (1.0 - std::cos(std::numbers::pi * share));
  }
  return knots;
}

Knots constant(std::size_t count, double level) { return Knots(count, level); }

Knots scaled(Knots knots, double factor, double offset) {
  for (double& value : knots) value = factor * value + offset;
  return knots;
}

Knots sum(Knots a, const Knots& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] += b[k];
  return a;
}

ImposedMotion::ImposedMotion(Knots speed_rad_s, double start_rad)
    : speed_(std::move(speed_rad_s)), slope_(speed_.size()), position_(speed_.size()) {
  const std::size_t last = speed_.size() - 1;
  for (std::size_t k = 0; k <= last; ++k) {
    const std::size_t before = k == 0 ? 0 : k - 1;
    const std::size_t after = k == last ? last : k + 1;
    slope_[k] = (speed_[after] - speed_[before]) / static_cast<double>(after - before);
  }
  position_[0] = start_rad;
  for (std::size_t k = 0; k < last; ++k) {
    // The integral of the cubic between two knots.
    const double mean = 0.5 * (speed_[k] + speed_[k + 1]) + (slope_[k] - slope_[k + 1]) / 12.0;
    position_[k + 1] = position_[k] + kTick_s * mean;
  }
}

ImposedMotion::Point ImposedMotion::at(std::size_t knot, double share) const {
  const std::size_t last = speed_.size() - 1;
  if (knot >= last) return {position_[last], speed_[last], slope_[last] / kTick_s};
  // w(s) = w0 + m0 s + c2 s² + c3 s³, s in ticks.
  const double rise = speed_[knot + 1] - speed_[knot];
  const double m0 = slope_[knot];
  const double m1 = slope_[knot + 1];
  const double c2 = 3.0 * rise - 2.0 * m0 - m1;
  const double c3 = m0 + m1 - 2.0 * rise;
  const double s = share;
  return {position_[knot] +
              kTick_s * s * (speed_[knot] + s * (m0 / 2.0 + s * (c2 / 3.0 + s * c3 / 4.0))),
          speed_[knot] + s * (m0 + s * (c2 + s * c3)),
          (m0 + s * (2.0 * c2 + 3.0 * c3 * s)) / kTick_s};
}

}  // namespace torquewright::oracles
