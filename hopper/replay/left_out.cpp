// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/left_out.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hopper/replay/free_rotors.hpp"
#include "robot/model/whole_body.hpp"
#include "simulation/joint/elastic_train.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Effect;

bool changes_inertia(const Effect& effect) {
  if (effect.kind->acts != actuator::Acts::kInertialTorque) return false;
  return effect.kind->law(effect, {.acceleration_rad_s2 = 1.0}) != 0.0;
}

constexpr char kInJoints[] =
    "the robot's joints state the inertia of its rotor (reflected_inertia_kg_m2), and how much of "
    "it is this rotor's is not known; without that the actuator's own counts";
constexpr char kWeighsNothing[] =
    "its rotor weighs nothing, so that nothing moves in the gap or on the spring: "
    "/motor/rotor_inertia_kg_m2 states it";
constexpr char kNoSpring[] =
    "it acts by the twist of a spring between motor and output, and none that gives way is stated "
    "beside it (torsional compliance)";

bool is_spring(const Effect& effect) {
  return effect.kind->in_train == actuator::TrainPart::kSpring &&
         simulation::makes_train_elastic(effect);
}

/// Why an effect does not act; empty: it does.
std::string reason_against(const Robot& robot, const Drivetrain& drivetrain, std::size_t actuator,
                           const Effect& effect) {
  if (drivetrain.joints_state_rotors && changes_inertia(effect)) return kInJoints;
  const bool is_hysteresis = effect.kind->in_train == actuator::TrainPart::kHysteresis;
  const std::vector<Effect>& beside = drivetrain.actuators[actuator].effects;
  if (is_hysteresis && std::none_of(beside.begin(), beside.end(), is_spring)) return kNoSpring;
  const bool is_part_of_train = is_hysteresis || simulation::makes_train_elastic(effect);
  if (!is_part_of_train || is_rotor_free(robot, drivetrain, actuator)) return "";
  return rotors_stay_in_tree(drivetrain) ? kInJoints : kWeighsNothing;
}

}  // namespace

std::vector<EffectLeftOut> effects_left_out(const Robot& robot) {
  std::vector<EffectLeftOut> left_out;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
      for (const Effect& effect : drivetrain.actuators[i].effects) {
        const std::string reason = reason_against(robot, drivetrain, i, effect);
        if (reason.empty()) continue;
        left_out.push_back({drivetrain.actuator_names[i], std::string(effect.kind->name), reason});
      }
    }
  }
  return left_out;
}

void leave_open(const std::vector<EffectLeftOut>& effects, ReplayResult& result) {
  for (const EffectLeftOut& one : effects) {
    Finding& finding = result.findings.emplace_back();
    finding.rule = "effect-left-out";
    finding.severity = actuator::Severity::kWarning;
    finding.joint = one.drive;
    finding.sentence = fmt::format("{}: {} is left out: {}", one.drive, one.effect, one.reason);
  }
  if (effects.empty() || result.outcome.verdict == ReplayVerdict::kUnfinished) return;
  const std::string as_it_went = result.outcome.verdict == ReplayVerdict::kStands
                                     ? std::string("it does the motion and stands")
                                     : result.outcome.reason;
  result.outcome.verdict = ReplayVerdict::kUndecided;
  result.outcome.reason = fmt::format("{} of {} is left out; without it {}", effects.front().effect,
                                      effects.front().drive, as_it_went);
}

}  // namespace torquewright::hopper
