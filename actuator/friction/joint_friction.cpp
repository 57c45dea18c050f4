// SPDX-License-Identifier: Apache-2.0
#include "actuator/friction/joint_friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/effects/harmonics.hpp"
#include "actuator/heat/temperature_laws.hpp"
#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"

namespace torquewright::actuator {
namespace {

constexpr int kFrictionSpeeds = 400;   // over which laws are fitted and compared
constexpr double kOwnRounding = 1e-9;  // of a law's own torque
constexpr double kMoving_rad_s = 1;    // bristles slip at any speed alike

/// Friction with a state of its own, on one side of the train: it slips at a level.
bool has_bristles(const Effect& effect) {
  const EffectKind& kind = *effect.kind;
  return kind.acts == Acts::kDynamics && kind.state_rate != nullptr && !kind.follows_torque &&
         kind.in_train == TrainPart::kNone;
}

/// At the state at which its rate is none. Rates are linear in their state.
double slipping_Nm(const Effect& effect, Instant at) {
  at.speed_rad_s = at.direction * kMoving_rad_s;
  at.state = 0.0;
  const double rate = effect.kind->state_rate(effect, at);
  at.state = 1.0;
  const double slope = effect.kind->state_rate(effect, at) - rate;
  at.state = slope < 0.0 ? -rate / slope : 0.0;
  return -effect.kind->law(effect, at) * at.direction;
}

bool is_friction(const Effect& effect) {
  return effect.kind->acts == Acts::kDrag || has_bristles(effect);
}

/// Against the motion, before the factors on all drag.
double friction_of_Nm(const Effect& effect, Instant at, double speed_rad_s, double direction) {
  at.speed_rad_s = speed_rad_s;
  at.direction = direction;
  if (has_bristles(effect)) return slipping_Nm(effect, at);
  const bool is_even = effect.kind->acts == Acts::kDrag && !effect.kind->has_harmonics;
  return is_even ? -effect.kind->law(effect, at) * direction : 0.0;
}

/// The mean of both ways.
double both_ways_Nm(const Effect& effect, const Instant& at, double speed_rad_s) {
  return 0.5 * (friction_of_Nm(effect, at, speed_rad_s, 1.0) +
                friction_of_Nm(effect, at, -speed_rad_s, -1.0));
}

double held_Nm(const JointFriction& friction, double speed_rad_s) {
  return friction.coulomb_Nm + friction.viscous_Nm_s_rad * std::abs(speed_rad_s);
}

/// The greatest difference of a law to what is held in its place, over both ways.
struct Misfit {
  double torque_Nm = 0.0;
  double speed_rad_s = 0.0;
};
Misfit misfit(const Effect& effect, const Instant& at, const JointFriction& held,
              double end_rad_s) {
  Misfit worst;
  for (int i = -kFrictionSpeeds; i <= kFrictionSpeeds; ++i) {
    if (i == 0) continue;
    const double speed_rad_s = end_rad_s * i / kFrictionSpeeds;
    const double own_Nm = friction_of_Nm(effect, at, speed_rad_s, i > 0 ? 1.0 : -1.0);
    const double off_Nm = std::abs(own_Nm - held_Nm(held, speed_rad_s));
    if (off_Nm > worst.torque_Nm) worst = {off_Nm, speed_rad_s};
  }
  return worst;
}

/// c + b w by least squares, neither below zero.
JointFriction least_squares(const Effect& effect, const Instant& at, double end_rad_s) {
  double torques = 0.0;
  double moments = 0.0;
  double speeds = 0.0;
  double squares = 0.0;
  for (int i = 1; i <= kFrictionSpeeds; ++i) {
    const double speed_rad_s = end_rad_s * i / kFrictionSpeeds;
    const double torque_Nm = both_ways_Nm(effect, at, speed_rad_s);
    torques += torque_Nm;
    moments += torque_Nm * speed_rad_s;
    speeds += speed_rad_s;
    squares += speed_rad_s * speed_rad_s;
  }
  const double viscous = (kFrictionSpeeds * moments - speeds * torques) /
                         (kFrictionSpeeds * squares - speeds * speeds);
  const double coulomb_Nm = (torques - viscous * speeds) / kFrictionSpeeds;
  if (viscous < 0.0) return {std::max(0.0, torques / kFrictionSpeeds), 0.0, 0.0};
  if (coulomb_Nm < 0.0) return {0.0, 0.0, std::max(0.0, moments / squares)};
  return {coulomb_Nm, 0.0, viscous};
}

/// One effect as dry and viscous friction.
JointFriction held(const Effect& effect, const Instant& at, double end_rad_s) {
  const double rest_Nm = both_ways_Nm(effect, at, 0.0);
  JointFriction line{rest_Nm, rest_Nm, both_ways_Nm(effect, at, 1.0) - rest_Nm};
  const double greatest_Nm = std::max(rest_Nm, both_ways_Nm(effect, at, end_rad_s));
  bool is_line = line.viscous_Nm_s_rad >= 0.0;
  for (int i = 1; i <= kFrictionSpeeds && is_line; ++i) {
    const double speed_rad_s = end_rad_s * i / kFrictionSpeeds;
    const double off_Nm = both_ways_Nm(effect, at, speed_rad_s) - held_Nm(line, speed_rad_s);
    is_line = std::abs(off_Nm) <= kOwnRounding * greatest_Nm;
  }
  if (!is_line) line = least_squares(effect, at, end_rad_s);
  line.breakaway_Nm = std::max(rest_Nm, line.coulomb_Nm);
  return line;
}

double factor(const Actuator& actuator, const Instant& at) { return drag_factor(actuator, at); }

void say_misfits(const Actuator& actuator, const Instant& at, double end_rad_s, bool has_breakaway,
                 std::vector<std::string>& said) {
  const double drag = factor(actuator, at);
  for (const Effect& effect : actuator.effects) {
    if (!is_friction(effect)) continue;
    const JointFriction joint = held(effect, at, end_rad_s);
    const Misfit worst = misfit(effect, at, joint, end_rad_s);
    if (drag * worst.torque_Nm > kOwnRounding * (1.0 + held_Nm(joint, end_rad_s))) {
      said.push_back(
          fmt::format("{}: the joint has {:.6g} Nm and {:.6g} Nm s/rad in its place, off by up to "
                      "{:.4g} Nm (at "
                      "{:.4g} rad/s)",
                      effect.kind->name, drag * joint.coulomb_Nm, drag * joint.viscous_Nm_s_rad,
                      drag * worst.torque_Nm, worst.speed_rad_s));
    }
    const double excess_Nm = drag * (joint.breakaway_Nm - joint.coulomb_Nm);
    if (excess_Nm > kOwnRounding && !has_breakaway) {
      said.push_back(fmt::format("{}: at rest it holds {:.4g} Nm more than the joint",
                                 effect.kind->name, excess_Nm));
    }
  }
}

void say_histories(const Actuator& actuator, const Instant& at, std::vector<std::string>& said) {
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->has_harmonics && effect.kind->acts == Acts::kDrag) {
      const HarmonicRange range = harmonic_range(effect.harmonics);
      said.push_back(fmt::format("{}: off by up to {:.4g} Nm at some angles", effect.kind->name,
                                 std::max(std::abs(range.smallest), std::abs(range.largest))));
    }
    if (!has_bristles(effect)) continue;
    Instant forward = at;
    forward.direction = 1.0;
    const double level_Nm = factor(actuator, at) * slipping_Nm(effect, forward);
    const double stiffness =
        effect.kind->stiffness_Nm_rad ? effect.kind->stiffness_Nm_rad(effect) : kUnlimited;
    if (level_Nm == 0.0 || !std::isfinite(stiffness)) continue;
    said.push_back(
        fmt::format("{}: the joint slips at once; the drive gives way first, and is off by up to "
                    "{:.4g} Nm over "
                    "some {:.3g} rad behind each reversal",
                    effect.kind->name, 2.0 * level_Nm, 2.0 * level_Nm / stiffness));
  }
}

void say_load(const Actuator& actuator, double greatest_Nm, std::vector<std::string>& said) {
  const double driving = after_mesh_Nm(actuator, 1.0, 1.0);
  const double braking = after_mesh_Nm(actuator, 1.0, -1.0);
  if (std::abs(driving - 1.0) > kOwnRounding) {
    said.push_back(fmt::format(
        "losses in proportion to load, driving: {:.4g} of the motor's torque arrives, the joint "
        "gets "
        "all of a command below the limits; off by up to {:.4g} Nm at half of {:.4g} Nm",
        driving, 0.5 * greatest_Nm * std::abs(1.0 - driving), greatest_Nm));
  }
  if (std::abs(braking - 1.0) > kOwnRounding) {
    said.push_back(fmt::format(
        "losses in proportion to load, braking: the drive holds {:.4g} of the motor's torque, the "
        "joint a command below the limits; off by up to {:.4g} Nm at half of {:.4g} Nm",
        braking, 0.5 * greatest_Nm * std::abs(braking - 1.0), greatest_Nm));
  }
}

}  // namespace

std::string_view name_of(FrictionPlace place) {
  return place == FrictionPlace::kJoint ? "joint" : "limits";
}

JointFriction joint_friction(const Actuator& actuator, double temperature_K, double end_rad_s) {
  const Instant at = at_winding_temperature(actuator, temperature_K);
  const double drag = factor(actuator, at);
  JointFriction sum;
  for (const Effect& effect : actuator.effects) {
    if (!is_friction(effect)) continue;
    const JointFriction one = held(effect, at, end_rad_s);
    sum.coulomb_Nm += drag * one.coulomb_Nm;
    sum.breakaway_Nm += drag * one.breakaway_Nm;
    sum.viscous_Nm_s_rad += drag * one.viscous_Nm_s_rad;
  }
  return sum;
}

double sliding_friction_Nm(const Actuator& actuator, double speed_rad_s, double direction,
                           double temperature_K) {
  const Instant at = at_winding_temperature(actuator, temperature_K);
  double sum_Nm = 0.0;
  for (const Effect& effect : actuator.effects) {
    sum_Nm += friction_of_Nm(effect, at, speed_rad_s, direction);
  }
  return factor(actuator, at) * sum_Nm;
}

double presliding_level_Nm(const Actuator& actuator, double direction, double temperature_K) {
  const Instant at = at_winding_temperature(actuator, temperature_K);
  double sum_Nm = 0.0;
  for (const Effect& effect : actuator.effects) {
    if (has_bristles(effect)) sum_Nm += friction_of_Nm(effect, at, 0.0, direction);
  }
  return factor(actuator, at) * sum_Nm;
}

Actuator without_friction(const Actuator& actuator) {
  Actuator free = actuator;
  std::erase_if(free.effects, [](const Effect& effect) {
    return is_friction(effect) || effect.kind->acts == Acts::kDragFactor;
  });
  return free;
}

Actuator without_losses(const Actuator& actuator) {
  Actuator free = without_friction(actuator);
  std::erase_if(free.effects, [](const Effect& effect) {
    const Acts acts = effect.kind->acts;
    const bool is_wave = effect.kind->has_harmonics &&
                         (acts == Acts::kMotorSideTorque || acts == Acts::kOutputTorque);
    return acts == Acts::kLoadFriction || is_wave;
  });
  free.transmission.forward_efficiency = 1.0;
  free.transmission.backward_efficiency = 1.0;
  free.transmission.peak_torque_Nm = kUnlimited;
  return free;
}

bool locks_itself(const Actuator& actuator) {
  return !std::isfinite(after_mesh_Nm(actuator, 1.0, -1.0));
}

std::vector<std::string> friction_not_held(const Actuator& actuator, double temperature_K,
                                           double end_rad_s, bool has_breakaway,
                                           double greatest_Nm) {
  const Instant at = at_winding_temperature(actuator, temperature_K);
  std::vector<std::string> said;
  say_misfits(actuator, at, end_rad_s, has_breakaway, said);
  say_histories(actuator, at, said);
  say_load(actuator, greatest_Nm, said);
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->acts != Acts::kDragFactor) continue;
    said.push_back(fmt::format("{}: the joint has it at a winding of {:.6g} K, a factor of {:.4g}",
                               effect.kind->name, temperature_K, effect.kind->law(effect, at)));
  }
  return said;
}

}  // namespace torquewright::actuator
