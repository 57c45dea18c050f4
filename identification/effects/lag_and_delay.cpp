// SPDX-License-Identifier: Apache-2.0
// Torque that follows late, and channels that are late.
#include <algorithm>
#include <cmath>

#include "identification/effects/families.hpp"
#include "identification/signal.hpp"

namespace torquewright::identification {
namespace {

/// What a first-order lag takes away of the driven torque.
void fill_lag(const Balance& balance, double lag_s, const Signals& signals,
              std::vector<double>& out) {
  const double share = signals.step_s > 0.0 ? std::exp(-signals.step_s / lag_s) : 0.0;
  double state = 0.0;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    const double input = balance.driven_Nm(signals, i);
    if (i == 0) state = input;
    // Exact for an input that is straight between samples.
    if (i > 0 && signals.step_s > 0.0) {
      const double before = balance.driven_Nm(signals, i - 1);
      const double slope = (input - before) / signals.step_s;
      state = input - slope * lag_s + (state - before + slope * lag_s) * share;
    }
    // With a motor-side target what is needed leads: the mirror image in time.
    out[i] = balance.is_sensor() ? balance.gain(signals, i) * (state - input) : state - input;
  }
}

void add_lag(DictionaryBuilder& builder) {
  for (const double lag_s : {0.002, 0.004, 0.008, 0.016, 0.032, 0.064}) {
    const std::size_t column = builder.add_stretch(
        "lag",
        [balance = builder.balance(), lag_s](const Signals& signals, std::vector<double>& out) {
          fill_lag(*balance, lag_s, signals, out);
        });
    builder.variant("torque_lag", {one(column, 0.0, 1.5)}).shape = {{lag_s}};
  }
}

/// To first order a delay is the prediction's slope.
void fill_delay(const Balance& balance, const Signals& signals, std::vector<double>& out) {
  for (std::size_t i = 0; i < signals.size(); ++i) out[i] = balance.predicted_Nm(signals, i);
  if (signals.step_s == 0.0 || signals.size() < 5) {
    std::fill(out.begin(), out.end(), 0.0);
    return;
  }
  const std::vector<double> slope = derivative(out, signals.step_s);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = balance.is_sensor() ? -slope[i] : slope[i];
  }
}

}  // namespace

void add_lag_and_delay(DictionaryBuilder& builder) {
  const Bench& bench = builder.bench();
  if (bench.load_side == LoadSide::kSensor || bench.drive == Drive::kTorque ||
      bench.drive == Drive::kCurrent) {
    add_lag(builder);
  }
  const std::size_t column = builder.add_stretch(
      "delay", [balance = builder.balance()](const Signals& signals, std::vector<double>& out) {
        fill_delay(*balance, signals, out);
      });
  builder.variant("channel_delay", {one(column, -0.2, 0.2)}, EffectFamily::kLog);
}

}  // namespace torquewright::identification
