// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "actuator/effects/library.hpp"

namespace torquewright::identification {
namespace {

using actuator::StandsFor;

constexpr double kErrorsOfScale = 3.0;
constexpr double kAsPromised = 1.05;   ///< The rig's own uncertain values are as stated.
constexpr double kOfNoiseFloor = 0.2;  ///< What that may change besides.
constexpr double kMost = 0.5;          ///< Of the squares that are left.
constexpr double kNoise = 1.58;        ///< Floors, up to which a simulation's error is noise.

/// Whether a number in it is a torque, or an inertia: what scales with the torque constant.
bool holds_a_torque(const FoundParameters& parameters) {
  const std::vector<const FoundNumber*> numbers = parameters.every_number();
  return std::any_of(numbers.begin(), numbers.end(), [](const FoundNumber* each) {
    return each->name.find("_Nm") != std::string::npos ||
           each->name.find("_kg_m2") != std::string::npos;
  });
}

bool is_torque_scale(const std::string& effect) {
  return actuator::stands_for(effect, StandsFor::kTorqueScale);
}

bool is_constant_in_doubt(const EquationResult& result) {
  return std::any_of(result.confounded.begin(), result.confounded.end(), [](const auto& group) {
    return std::any_of(group.effects.begin(), group.effects.end(), is_torque_scale);
  });
}

/// The standard error of a number; zero where the log does not determine it.
double error_of(const NamedEffect& effect, const char* parameter) {
  const double error = effect.parameters.standard_error(parameter);
  return std::isnan(error) ? 0.0 : error;
}

/// Along which a law that is another one would leave its error; empty: it has none of its own.
std::string_view own_coordinate(const NamedEffect& named) {
  const actuator::EffectKind* kind = actuator::find_effect(named.effect);
  if (kind == nullptr || kind->has_harmonics) return "";
  switch (kind->acts) {
    case actuator::Acts::kDrag:
      return "output_velocity_rad_s";
    case actuator::Acts::kLoadFriction:
      return "load_torque_Nm";
    default:
      return "";
  }
}

NamedEffect* sure_one(StandsFor what, EquationResult& result) {
  for (NamedEffect& each : result.added) {
    if (actuator::stands_for(each.effect, what) && is_certain(result, each.effect)) return &each;
  }
  return nullptr;
}

void doubt_certain_of_actuator(const std::string& why, EquationResult& result) {
  for (NamedEffect& each : result.added) {
    if (each.family != EffectFamily::kActuator || !is_certain(result, each.effect)) continue;
    each.doubt = why;
    each.is_refuted = true;
  }
}

}  // namespace

double Left::floors() const { return noise > 0.0 ? std::sqrt((squares + noise) / noise) : 0.0; }

std::string doubt_beside(const Left& left, double squares, double most_floors) {
  if (left.floors() <= most_floors || squares >= left.squares) return "";
  return fmt::format(
      "{:.2g} noise floors are left beside it, more than it takes: what is missing may take its "
      "place",
      left.floors());
}

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

void doubt_what_goes_along(double noise_floors, EquationResult& result) {
  const double floor = result.noise_floor_rms;
  if (!(floor > 0.0 && result.after.train_rms > noise_floors * floor)) return;
  for (const ResidualStructure& left : result.structure_after) {
    if (!is_significant(left) || left.share <= kMost) continue;
    for (NamedEffect& each : result.added) {
      if (own_coordinate(each) != left.coordinate || !each.doubt.empty()) continue;
      each.doubt = fmt::format(
          "of the {:.2g} noise floors that are left beside it {:.0f} % of the square still goes "
          "along {}: it is another law of it",
          result.after.train_rms / floor, 100.0 * left.share, left.coordinate);
    }
  }
}

void doubt_what_fails_held_out(double times, EquationResult& result) {
  const double fitted = std::max(result.after.train_rms, result.noise_floor_rms);
  if (!(fitted > 0.0 && result.after.holdout_rms > times * fitted)) return;
  for (NamedEffect& each : result.added) {
    if (each.family != EffectFamily::kActuator || !each.doubt.empty()) continue;
    each.doubt = fmt::format(
        "the runs that no fit saw leave {:.3g} {} where the fitted ones leave {:.3g}: there it is "
        "another law, or not the only one",
        result.after.holdout_rms, result.unit, result.after.train_rms);
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
    if (!is_torque_scale(each.effect) || result.quantity != "winding_voltage_V") continue;
    each.doubt +=
        "; so it is the back-EMF constant that is another: /motor/back_emf_constant_V_s_rad "
        "states it apart from the torque constant";
  }
}

void doubt_what_goes_with_scale(const EquationResult& velocity, EquationResult& torque) {
  for (const NamedEffect& each : velocity.added) {
    if (each.effect != "velocity_mismatch") continue;
    const double scale = each.parameters.value("scale", 0.0);
    if (std::abs(scale - 1.0) <= kErrorsOfScale * error_of(each, "scale")) continue;
    for (NamedEffect& inertia : torque.added) {
      const bool is_inertia = actuator::stands_for(inertia.effect, StandsFor::kLoadInertia);
      if (!is_inertia || !inertia.doubt.empty()) continue;
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

void doubt_what_one_factor_explains(double inertia_kg_m2, double before_gears_kg_m2,
                                    EquationResult& torque) {
  NamedEffect* constant = sure_one(StandsFor::kTorqueScale, torque);
  NamedEffect* inertia = sure_one(StandsFor::kLoadInertia, torque);
  if (constant == nullptr || inertia == nullptr) return;
  const double factor = constant->parameters.value("factor", 0.0);
  const double factor_error = error_of(*constant, "factor");
  const double more_kg_m2 = inertia->parameters.value("inertia_kg_m2", 0.0);
  const double more_error_kg_m2 = error_of(*inertia, "inertia_kg_m2");
  const auto agrees = [&](double expected_kg_m2, double slope_kg_m2) {
    const double error_kg_m2 = std::hypot(more_error_kg_m2, slope_kg_m2 * factor_error);
    return std::abs(more_kg_m2 - expected_kg_m2) <= kErrorsOfScale * error_kg_m2;
  };
  std::string other;
  if (agrees((factor - 1.0) * inertia_kg_m2, inertia_kg_m2)) {
    other = "the torque sensor's gain would: calibrate it, or log the winding's voltage";
  } else if (agrees((factor * factor - 1.0) * before_gears_kg_m2,
                    2.0 * factor * before_gears_kg_m2)) {
    other = "a gear ratio that is off by it would: count the teeth, or log the motor's position";
  } else {
    return;
  }
  constant->doubt =
      fmt::format("one factor, {:.4g}, explains it and the inertia together, as {}", factor, other);
  inertia->doubt = fmt::format("it goes with {} by one factor", constant->effect);
  constant->is_refuted = inertia->is_refuted = true;
}

}  // namespace torquewright::identification
