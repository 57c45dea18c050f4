// SPDX-License-Identifier: Apache-2.0
#include "identification/rollout/free_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "actuator/effects/every_effect.hpp"
#include "actuator/effects/library.hpp"

namespace torquewright::identification {
namespace {

using actuator::Acts;
using actuator::Effect;
using actuator::EffectKind;
using Of = FreeValue::Of;

constexpr double kCalibration_rad = 0.02;  ///< What a calibration of an encoder leaves.
constexpr double kHung_rad = 0.1;          ///< How level a robot hangs that was hung level.
constexpr double kWeighed = 0.1;           ///< Of a mass: cables, covers, screws.
constexpr double kCentred_m = 0.01;
constexpr double kPacket_s = 0.02;  ///< Of commands: what one may be late.
constexpr double kLatest_s = 0.5;
constexpr double kTurned_rad = 0.6;  ///< More would have been stated.
/// Changes that show, in a joint of a leg or an arm.
constexpr double kInertia_kg_m2 = 0.01;
constexpr double kEffect = 0.1;
constexpr double kNothing = 1e-9;  ///< Of a rotor, which needs some inertia.

const Effect* find_effect_of(const actuator::Actuator& drive, const std::string& name) {
  for (const Effect& each : drive.effects) {
    if (each.kind->name == name) return &each;
  }
  return nullptr;
}

const dynamics::Body& body_of(const RobotModel& model, std::size_t joint) {
  return model.load.robot->tree.bodies[model.load.robot->bodies[joint]];
}

/// Whether a fit may move its numbers: laws of torque without a memory, apart from waves.
bool is_free(const EffectKind& kind) {
  const bool acts = kind.acts == Acts::kDrag || kind.acts == Acts::kLoadFriction ||
                    kind.acts == Acts::kInertialTorque || kind.acts == Acts::kTorqueFactor;
  return acts && !kind.has_harmonics && kind.state_rate == nullptr &&
         kind.in_train == actuator::TrainPart::kNone;
}

Effect* find_effect_of(actuator::Actuator& drive, const std::string& name) {
  return const_cast<Effect*>(find_effect_of(std::as_const(drive), name));
}

/// A sin(order angle + phase) = cosine cos(order angle) + sine sin(order angle).
std::array<double, 2> parts_of(const actuator::Harmonic& wave) {
  return {wave.amplitude * std::sin(wave.phase_rad), wave.amplitude * std::cos(wave.phase_rad)};
}

void set_part(actuator::Harmonic& wave, std::size_t part, double value) {
  std::array<double, 2> parts = parts_of(wave);
  parts[part] = value;
  wave.amplitude = std::hypot(parts[0], parts[1]);
  wave.phase_rad = wave.amplitude > 0.0 ? std::atan2(parts[0], parts[1]) : 0.0;
}

/// Whether a stated law is this one, or holds it.
bool has_law(const actuator::Actuator& drive, const EffectKind& kind) {
  return std::any_of(drive.effects.begin(), drive.effects.end(), [&](const Effect& each) {
    const auto& contains = each.kind->contains;
    return each.kind == &kind ||
           std::find(contains.begin(), contains.end(), kind.name) != contains.end();
  });
}

void add_of_waves(const Effect& effect, std::size_t joint, std::vector<FreeValue>& values) {
  for (std::size_t part = 0; part < 2 * effect.harmonics.size(); ++part) {
    FreeValue one;
    one.of = Of::kWave;
    one.joint = joint;
    one.effect = std::string(effect.kind->name);
    one.parameter = part;
    one.name = fmt::format("order {:g}, {} part_Nm", effect.harmonics[part / 2].order,
                           part % 2 == 0 ? "cosine" : "sine");
    one.lowest = -std::numeric_limits<double>::infinity();
    one.size = kEffect;
    values.push_back(one);
  }
}

void add_of_effect(const Effect& effect, std::size_t joint, std::vector<FreeValue>& values) {
  if (actuator::is_wave_of_friction(effect.kind->name)) add_of_waves(effect, joint, values);
  if (!is_free(*effect.kind)) return;
  for (std::size_t p = 0; p < effect.values.size(); ++p) {
    const actuator::Parameter& parameter = effect.kind->parameters[p];
    if (!std::isfinite(effect.values[p])) continue;
    FreeValue one;
    one.of = Of::kEffect;
    one.joint = joint;
    one.effect = std::string(effect.kind->name);
    one.parameter = p;
    one.name = std::string(parameter.name);
    one.lowest = parameter.lowest;
    one.highest = parameter.highest;
    one.size = parameter.is_scale ? std::abs(effect.values[p]) : kEffect;
    values.push_back(one);
  }
}

}  // namespace

double value_in(const RobotModel& model, const FreeValue& which) {
  switch (which.of) {
    case Of::kRotor:
      return model.drives[which.joint].motor.rotor_inertia_kg_m2;
    case Of::kEffect:
      return find_effect_of(model.drives[which.joint], which.effect)->values[which.parameter];
    case Of::kWave: {
      const Effect& effect = *find_effect_of(model.drives[which.joint], which.effect);
      return parts_of(effect.harmonics[which.parameter / 2])[which.parameter % 2];
    }
    case Of::kOffset:
      return model.offset_rad[which.joint];
    case Of::kRoll:
      return model.load.roll_rad;
    case Of::kPitch:
      return model.load.pitch_rad;
    case Of::kMass:
      return body_of(model, which.joint).inertia.mass_kg;
    case Of::kCenter:
      return body_of(model, which.joint)
          .inertia.center_of_mass_m[static_cast<Eigen::Index>(which.parameter)];
    case Of::kStiffness:
      return model.controllers[which.joint].law.stiffness_Nm_rad;
    case Of::kDamping:
      return model.controllers[which.joint].law.damping_Nm_s_rad;
    case Of::kDelay:
      return model.controllers[which.joint].delay_s;
  }
  return 0.0;
}

bool FreeValue::is_of(std::size_t one) const {
  return is_of_all() || joint == one ||
         std::find(sisters.begin(), sisters.end(), one) != sisters.end();
}

void set_value(RobotModel& model, const FreeValue& which, double value) {
  for (const std::size_t sister : which.sisters) {
    FreeValue own = which;
    own.sisters.clear();
    own.joint = sister;
    set_value(model, own, value);
  }
  const auto change_body = [&](auto&& change) {
    auto robot = std::make_shared<RobotLoad>(*model.load.robot);
    change(robot->tree.bodies[robot->bodies[which.joint]].inertia);
    model.load.robot = std::move(robot);
  };
  switch (which.of) {
    case Of::kRotor:
      model.drives[which.joint].motor.rotor_inertia_kg_m2 = value;
      break;
    case Of::kEffect:
      find_effect_of(model.drives[which.joint], which.effect)->values[which.parameter] = value;
      break;
    case Of::kWave:
      set_part(
          find_effect_of(model.drives[which.joint], which.effect)->harmonics[which.parameter / 2],
          which.parameter % 2, value);
      break;
    case Of::kOffset:
      model.offset_rad[which.joint] = value;
      break;
    case Of::kRoll:
      model.load.roll_rad = value;
      break;
    case Of::kPitch:
      model.load.pitch_rad = value;
      break;
    case Of::kMass:
      change_body([&](dynamics::RigidInertia& inertia) { inertia.mass_kg = value; });
      break;
    case Of::kCenter:
      change_body([&](dynamics::RigidInertia& inertia) {
        inertia.center_of_mass_m[static_cast<Eigen::Index>(which.parameter)] = value;
      });
      break;
    case Of::kStiffness:
      model.controllers[which.joint].law.stiffness_Nm_rad = value;
      break;
    case Of::kDamping:
      model.controllers[which.joint].law.damping_Nm_s_rad = value;
      break;
    case Of::kDelay:
      for (JointController& each : model.controllers) {
        if (each.finds_delay) each.delay_s = value;
      }
      break;
  }
}

void tie(const std::vector<std::vector<std::size_t>>& alike, std::vector<FreeValue>& values) {
  const auto may_be_tied = [](const FreeValue& which) {
    return which.of == Of::kRotor || which.of == Of::kEffect || which.of == Of::kWave ||
           which.of == Of::kStiffness || which.of == Of::kDamping;
  };
  for (const std::vector<std::size_t>& group : alike) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (group.empty() || values[k].joint != group.front() || !may_be_tied(values[k])) continue;
      const FreeValue first = values[k];
      const auto is_same = [&](const FreeValue& other) {
        return other.of == first.of && other.joint != first.joint && other.effect == first.effect &&
               other.parameter == first.parameter &&
               std::find(group.begin(), group.end(), other.joint) != group.end();
      };
      for (const FreeValue& each : values) {
        if (is_same(each)) values[k].sisters.push_back(each.joint);
      }
      std::erase_if(values, is_same);
    }
  }
}

void add_plain_friction(RobotModel& model) {
  for (actuator::Actuator& drive : model.drives) {
    for (const EffectKind* kind :
         {&actuator::effects::viscous_friction, &actuator::effects::coulomb_friction}) {
      if (!has_law(drive, *kind)) drive.effects.push_back(actuator::neutral(*kind));
    }
  }
}

void add_wave_of_friction(actuator::Actuator& drive) {
  Effect wave = actuator::neutral(actuator::effects::position_dependent_friction);
  wave.harmonics = {{1.0, 0.0, 0.0}};
  drive.effects.push_back(wave);
}

void erase_waves_of_friction(actuator::Actuator& drive) {
  std::erase_if(drive.effects,
                [](const Effect& each) { return actuator::is_wave_of_friction(each.kind->name); });
}

bool has_wave_of_friction(const actuator::Actuator& drive) {
  return std::any_of(drive.effects.begin(), drive.effects.end(), [](const Effect& each) {
    return actuator::is_wave_of_friction(each.kind->name);
  });
}

std::vector<FreeValue> free_values(const RobotModel& model) {
  std::vector<FreeValue> values;
  for (std::size_t joint = 0; joint < model.drives.size(); ++joint) {
    const actuator::Actuator& drive = model.drives[joint];
    const double square = drive.transmission.ratio * drive.transmission.ratio;
    FreeValue rotor;
    rotor.joint = joint;
    rotor.name = "rotor_inertia_kg_m2";
    rotor.lowest = kNothing;
    rotor.size = kInertia_kg_m2 / square;
    values.push_back(rotor);
    for (const Effect& effect : drive.effects) add_of_effect(effect, joint, values);
    FreeValue offset;
    offset.of = Of::kOffset;
    offset.joint = joint;
    offset.name = "encoder_offset_rad";
    offset.lowest = -kTurned_rad;
    offset.highest = kTurned_rad;
    offset.size = offset.deviation = kCalibration_rad;
    values.push_back(offset);
  }
  return values;
}

std::vector<FreeValue> base_values() {
  FreeValue roll;
  roll.of = Of::kRoll;
  roll.name = "roll_rad";
  roll.lowest = -kTurned_rad;
  roll.highest = kTurned_rad;
  roll.size = kCalibration_rad;
  roll.deviation = kHung_rad;
  FreeValue pitch = roll;
  pitch.of = Of::kPitch;
  pitch.name = "pitch_rad";
  return {roll, pitch};
}

std::vector<FreeValue> controller_values(const RobotModel& model) {
  std::vector<FreeValue> values;
  bool finds_delay = false;
  const auto add = [&](Of of, std::size_t joint, const char* name, double size) {
    FreeValue one;
    one.of = of;
    one.joint = joint;
    one.name = name;
    one.size = one.deviation = size;
    values.push_back(one);
  };
  for (std::size_t joint = 0; joint < model.controllers.size(); ++joint) {
    const JointController& own = model.controllers[joint];
    // Nothing is known of a gain but its order of magnitude.
    if (own.finds_stiffness && own.law.stiffness_Nm_rad > 0.0)
      add(Of::kStiffness, joint, "controller_stiffness_Nm_rad", own.law.stiffness_Nm_rad);
    if (own.finds_damping)
      add(Of::kDamping, joint, "controller_damping_Nm_s_rad",
          std::max(own.law.damping_Nm_s_rad, kEffect));
    if (own.finds_delay && !finds_delay) {
      finds_delay = true;
      add(Of::kDelay, joint, "command_delay_s", kPacket_s);
      values.back().highest = kLatest_s;
    }
  }
  return values;
}

std::vector<FreeValue> body_values(const RobotModel& model) {
  std::vector<FreeValue> values;
  for (std::size_t joint = 0; joint < model.drives.size(); ++joint) {
    const double mass_kg = body_of(model, joint).inertia.mass_kg;
    if (!(mass_kg > 0.0)) continue;
    FreeValue mass;
    mass.of = Of::kMass;
    mass.joint = joint;
    mass.name = "mass_kg";
    mass.size = mass.deviation = kWeighed * mass_kg;
    values.push_back(mass);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      FreeValue center;
      center.of = Of::kCenter;
      center.joint = joint;
      center.parameter = axis;
      center.name = std::string("center_of_mass_") + "xyz"[axis] + "_m";
      center.lowest = -std::numeric_limits<double>::infinity();
      center.size = center.deviation = kCentred_m;
      values.push_back(center);
    }
  }
  return values;
}

}  // namespace torquewright::identification
