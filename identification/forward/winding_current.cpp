// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/winding_current.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "actuator/heat/temperature_laws.hpp"
#include "actuator/region/torque_at.hpp"
#include "actuator/region/winding.hpp"
#include "identification/preparation/winding_channels.hpp"
#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

using actuator::Actuator;
using actuator::Instant;

/// What the bridge keeps of a voltage, through the low-pass of the channels.
struct DeadBand {
  std::vector<double>
      kept;  ///< Of the dead time's voltage, -1 to 1; between them no current flows.
  std::vector<double> open;  ///< Share of the time in which current flows.
};

double dead_voltage_V(const Actuator& actuator) {
  Instant forward;
  forward.current_A = 1.0;
  return std::abs(actuator::winding_voltage_change_V(actuator, forward));
}

double back_emf_V(const Actuator& actuator, const actuator::Winding& winding, const Instant& at) {
  return winding.back_emf_V_s_rad * actuator::flux_factor(actuator, at) *
         actuator.transmission.ratio * at.speed_rad_s;
}

/// Between the samples of a smooth signal, and beside its ends.
double smooth_at(const std::vector<double>& values, std::size_t index, double share) {
  if (index + 1 >= values.size()) return values.back();
  if (index == 0 || index + 2 >= values.size()) {
    return (1.0 - share) * values[index] + share * values[index + 1];
  }
  return cubic_between({&values[index - 1], 4}, share);
}

/// The drop at the log's own samples: what varies slowly, between the signals' samples, and the
/// voltage's fast part.
std::vector<double> fast_drop_V(const std::vector<double>& drop_V, const Signals& signals,
                                double late_s) {
  if (signals.fast_voltage_V.empty()) return drop_V;
  const auto step = static_cast<double>(signals.raw_per_sample);
  std::vector<double> fast_V = signals.fast_voltage_V;
  if (late_s != 0.0) fast_V = advanced(fast_V, late_s, signals.step_s / step);
  for (std::size_t k = 0; k < fast_V.size(); ++k) {
    const std::size_t within = k % signals.raw_per_sample;
    fast_V[k] += smooth_at(drop_V, k / signals.raw_per_sample, static_cast<double>(within) / step);
  }
  return fast_V;
}

/// Of values at the log's own samples, at the signals'.
std::vector<double> as_the_signals(std::vector<double> raw, const Signals& signals) {
  const double step_s = signals.step_s / static_cast<double>(signals.raw_per_sample);
  if (signals.cutoff_Hz > 0.0 && !signals.fast_voltage_V.empty()) {
    LowPass(signals.cutoff_Hz, 1.0 / step_s).apply(raw);
  }
  for (std::size_t i = 0; i < signals.size(); ++i) raw[i] = raw[i * signals.raw_per_sample];
  raw.resize(signals.size());
  return raw;
}

DeadBand dead_band(const std::vector<double>& drop_V, double dead_V, const Signals& signals,
                   double late_s) {
  DeadBand band;
  if (dead_V == 0.0) {
    band.kept.assign(drop_V.size(), 0.0);
    band.open.assign(drop_V.size(), 1.0);
    return band;
  }
  for (const double fast_V : fast_drop_V(drop_V, signals, late_s)) {
    band.kept.push_back(std::clamp(fast_V / dead_V, -1.0, 1.0));
    band.open.push_back(std::abs(fast_V) > dead_V ? 1.0 : 0.0);
  }
  band.kept = as_the_signals(std::move(band.kept), signals);
  band.open = as_the_signals(std::move(band.open), signals);
  return band;
}

}  // namespace

Currents winding_currents(const Bench& bench, const Actuator& actuator, const Signals& signals,
                          const std::vector<double>& voltage_V, const std::vector<Instant>& at,
                          double late_s) {
  const actuator::Winding winding = actuator::winding_of(actuator);
  const bool is_sag_unknown = signals.bus_V.empty() && bench.drive_channel == Quantity::kDuty;
  Instant unit;
  unit.bus_current_A = 1.0;
  const double sag_ohm = is_sag_unknown ? -actuator::bus_voltage_change_V(actuator, unit) *
                                              bus_amperes_per_ampere(actuator)
                                        : 0.0;
  const std::size_t n = signals.size();
  std::vector<double> drop_V(n);
  for (std::size_t i = 0; i < n; ++i) {
    drop_V[i] = voltage_V[i] - back_emf_V(actuator, winding, at[i]);
  }
  const double dead_V = dead_voltage_V(actuator);
  const DeadBand band = dead_band(drop_V, dead_V, signals, late_s);
  Currents currents;
  for (std::size_t i = 0; i < n; ++i) {
    const double duty = voltage_V[i] / actuator.drive.bus_voltage_V;
    const double resistance_ohm =
        actuator::resistance_ohm(actuator, winding, at[i]) + sag_ohm * duty * duty;
    const double current_A = (drop_V[i] - dead_V * band.kept[i]) / resistance_ohm;
    currents.current_A.push_back(current_A);
    // The sag grows with the duty's square.
    const double sag_ohm_V = 2.0 * sag_ohm * duty / actuator.drive.bus_voltage_V;
    currents.per_unit.push_back(band.open[i] * (1.0 - sag_ohm_V * current_A) / resistance_ohm);
  }
  return currents;
}

}  // namespace torquewright::identification
