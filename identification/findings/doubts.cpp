// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace torquewright::identification {
namespace {

using Parameters = decltype(NamedEffect::parameters);

constexpr double kErrorsOfScale = 3.0;
constexpr double kAsPromised = 1.05;   ///< The rig's own uncertain values are as stated.
constexpr double kOfNoiseFloor = 0.2;  ///< What that may change besides.
constexpr double kNoise = 1.58;        ///< Floors, up to which a simulation's error is noise.

/// Whether a number in it is a torque, or an inertia: what scales with the torque constant.
bool holds_a_torque(const Parameters& parameters) {
  if (!parameters.is_structured()) return false;
  for (const auto& [key, value] : parameters.items()) {
    const bool is_torque =
        key.find("_Nm") != std::string::npos || key.find("_kg_m2") != std::string::npos;
    if (is_torque || holds_a_torque(value)) return true;
  }
  return false;
}

bool is_constant_in_doubt(const EquationResult& result) {
  return std::any_of(result.confounded.begin(), result.confounded.end(), [](const auto& group) {
    return std::find(group.effects.begin(), group.effects.end(), "torque_constant_error") !=
           group.effects.end();
  });
}

void doubt_certain_of_actuator(const std::string& why, EquationResult& result) {
  for (NamedEffect& each : result.added) {
    if (each.family != EffectFamily::kActuator || !is_certain(result, each.effect)) continue;
    each.doubt = why;
    each.is_refuted = true;
  }
}

}  // namespace

void append_doubts(EquationResult& result) {
  for (NamedEffect& each : result.added) {
    if (each.holdout_rms_after > each.holdout_rms_before) {
      each.doubt =
          fmt::format("it raises the error of the runs that no fit saw, {:.4g} -> {:.4g} {}",
                      each.holdout_rms_before, each.holdout_rms_after, result.unit);
      each.is_refuted = true;
    } else if (is_constant_in_doubt(result) && holds_a_torque(each.parameters) &&
               is_certain(result, each.effect)) {
      each.doubt = "its size goes with the torque constant's, which is not told apart from others";
    }
  }
}

void doubt_what_does_harm(EquationResult& result) {
  if (!(result.with_certain.holdout_rms > result.before.holdout_rms)) return;
  doubt_certain_of_actuator(
      fmt::format("all that is sure together raises the error of the runs that no fit saw, {:.4g} "
                  "-> {:.4g} {}",
                  result.before.holdout_rms, result.with_certain.holdout_rms, result.unit),
      result);
}

bool breaks_promise(const Errors& promised, const Errors& came_out, double noise_floor_rms) {
  const auto breaks = [&](double promise, double rms) {
    return rms > kAsPromised * promise + kOfNoiseFloor * noise_floor_rms;
  };
  return breaks(promised.train_rms, came_out.train_rms) ||
         breaks(promised.holdout_rms, came_out.holdout_rms);
}

void doubt_what_harms_another(const EquationResult& harmed, const Errors& came_out,
                              EquationResult& result) {
  for (NamedEffect& each : result.added) {
    const bool is_sure = each.family == EffectFamily::kActuator && is_certain(result, each.effect);
    const bool is_shared =
        std::any_of(harmed.added.begin(), harmed.added.end(),
                    [&](const NamedEffect& other) { return other.effect == each.effect; });
    if (!is_sure || is_shared) continue;
    each.is_refuted = true;
    each.doubt = fmt::format("in {} it raises the error, {:.4g} -> {:.4g} {}", harmed.quantity,
                             harmed.with_certain.train_rms, came_out.train_rms, harmed.unit);
    if (each.effect != "torque_constant_error" || result.quantity != "winding_voltage_V") continue;
    each.doubt +=
        "; so it is the back-EMF constant that is another: /motor/back_emf_constant_V_s_rad "
        "states it apart from the torque constant";
  }
}

void doubt_what_goes_with_scale(const EquationResult& velocity, EquationResult& torque) {
  for (const NamedEffect& each : velocity.added) {
    if (each.effect != "velocity_mismatch") continue;
    const double scale = each.parameters.value("scale", 1.0);
    const double error =
        each.standard_error.contains("scale") && each.standard_error["scale"].is_number()
            ? each.standard_error["scale"].get<double>()
            : 0.0;
    if (std::abs(scale - 1.0) <= kErrorsOfScale * error) continue;
    for (NamedEffect& inertia : torque.added) {
      if (inertia.effect != "reflected_inertia" || !inertia.doubt.empty()) continue;
      inertia.is_refuted = true;
      inertia.doubt = fmt::format(
          "{} and position differ by a scale of {:.4g}: times, angles or speeds of the log are off "
          "by as much, and accelerations with them",
          velocity.quantity, scale);
    }
  }
}

void doubt_what_follows_worse(const Errors& stated, const Errors& certain, double noise_floor_rms,
                              EquationResult& result) {
  const bool is_held_out = stated.holdout_rms > 0.0;
  const double before = is_held_out ? stated.holdout_rms : stated.train_rms;
  const double after = is_held_out ? certain.holdout_rms : certain.train_rms;
  if (!(after > std::max(before, kNoise * noise_floor_rms))) return;
  doubt_certain_of_actuator(
      fmt::format("simulated with what is sure the log is followed worse, {:.4g} -> {:.4g}", before,
                  after),
      result);
}

}  // namespace torquewright::identification
