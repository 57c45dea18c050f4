// SPDX-License-Identifier: Apache-2.0
#include "identification/robot/robot_study.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "identification/reading/robot_commands.hpp"
#include "identification/rollout/rollout.hpp"
#include "identification/rollout/servo_start.hpp"

namespace torquewright::identification {
namespace {

using Of = FreeValue::Of;

constexpr double kVaries = 5.0;   ///< Standard errors.
constexpr double kMatters = 0.1;  ///< Of the friction in the middle.
constexpr std::size_t kFirstRounds = 3, kLastRounds = 5;
constexpr double kGainWindow_s = 5.0;  ///< Of the trials of where gains begin.
constexpr std::size_t kGainWindows = 24;
/// Seconds of one joint's simulation in one round: what a user waits for.
constexpr double kMostJoint_s = 12000.0;
constexpr double kLeast_s = 10.0, kMost_s = 60.0;

bool is_uncertain_in(const Rig& rig, const std::string& pointer) {
  return std::find(rig.uncertain.begin(), rig.uncertain.end(), pointer) != rig.uncertain.end();
}

/// Nothing is told of a joint that does not move.
std::vector<FreeValue> all_values(const Rig& rig, const Log& log, const RobotModel& model) {
  std::vector<FreeValue> values = free_values(model);
  for (FreeValue& each : controller_values(model)) values.push_back(std::move(each));
  for (FreeValue& each : body_values(model)) values.push_back(std::move(each));
  for (FreeValue& each : base_values()) {
    if (is_uncertain_in(rig, "/load/" + each.name)) values.push_back(std::move(each));
  }
  const std::vector<bool> moves = moving_joints(rig, log);
  std::erase_if(values,
                [&](const FreeValue& each) { return !each.is_of_all() && !moves[each.joint]; });
  return values;
}

/// As much of the training runs as the values leave time for.
double simulated_s(const RobotModel& model, const std::vector<FreeValue>& values) {
  double joints = 0.0;
  for (const Limb& limb : limbs_of(model.load)) {
    const auto size = static_cast<double>(limb.joints.size());
    for (const FreeValue& each : values) {
      const bool is_in = each.is_of_all() || std::find(limb.joints.begin(), limb.joints.end(),
                                                       each.joint) != limb.joints.end();
      if (is_in) joints += size;
    }
  }
  return std::clamp(kMostJoint_s / std::max(joints, 1.0), kLeast_s, kMost_s);
}

/// Places of the values in a fit that make a joint's dry friction, constant + cosine + sine of its
/// angle; none where one of them is not there.
std::vector<Eigen::Index> friction_values(const ValueFit& fit, std::size_t joint) {
  std::vector<Eigen::Index> places(3, -1);
  for (std::size_t k = 0; k < fit.values.size(); ++k) {
    const FreeValue& which = fit.values[k].which;
    if (which.joint != joint) continue;
    if (which.name == "coulomb_Nm") places[0] = static_cast<Eigen::Index>(k);
    if (which.of == Of::kWave && which.parameter < 2)
      places[1 + which.parameter] = static_cast<Eigen::Index>(k);
  }
  if (std::find(places.begin(), places.end(), -1) != places.end()) return {};
  return places;
}

/// The 5th, 50th and 95th of 100 positions of a joint.
Eigen::Vector3d places_rad(const Log& log, std::size_t joint) {
  std::vector<double> all;
  for (const Run& run : log.runs) {
    const std::vector<double>& position_rad = run.joints[joint][Quantity::kOutputPosition];
    all.insert(all.end(), position_rad.begin(), position_rad.end());
  }
  std::sort(all.begin(), all.end());
  const auto last = static_cast<double>(all.size() - 1);
  const auto at = [&](double share) { return all[static_cast<std::size_t>(share * last)]; };
  return {at(0.05), at(0.5), at(0.95)};
}

/// Whether a joint's dry friction differs between its places by more than its error, and by a
/// share of itself that matters: from end to end, or in the middle from the ends.
bool does_vary(const Log& log, const ValueFit& fit, std::size_t joint) {
  const std::vector<Eigen::Index> own = friction_values(fit, joint);
  if (own.empty()) return false;
  const Eigen::Vector3d place = places_rad(log, joint);
  Eigen::Matrix3d law, covariance;
  Eigen::Vector3d values;
  law << Eigen::Vector3d::Ones(), place.array().cos().matrix(), place.array().sin().matrix();
  for (Eigen::Index a = 0; a < 3; ++a) {
    const Eigen::Index k = own[static_cast<std::size_t>(a)];
    values[a] = fit.values[static_cast<std::size_t>(k)].value;
    for (Eigen::Index b = 0; b < 3; ++b)
      covariance(a, b) = fit.covariance(k, own[static_cast<std::size_t>(b)]);
  }
  const double level_Nm = std::abs((law * values)[1]);
  for (const Eigen::RowVector3d& difference :
       {Eigen::RowVector3d(-1.0, 0.0, 1.0), Eigen::RowVector3d(-0.5, 1.0, -0.5)}) {
    const Eigen::RowVector3d slope = difference * law;
    const double change_Nm = std::abs(slope.dot(values));
    const double error_Nm = std::sqrt(std::max(0.0, (slope * covariance * slope.transpose())(0)));
    if (change_Nm > kVaries * error_Nm && change_Nm > kMatters * level_Nm) return true;
  }
  return false;
}

std::vector<bool> joints_that_vary(const Log& log, const ValueFit& fit) {
  std::vector<bool> varies;
  for (std::size_t joint = 0; joint < fit.model.drives.size(); ++joint) {
    varies.push_back(does_vary(log, fit, joint));
  }
  return varies;
}

void erase_waves_but(const std::vector<bool>& varies, const RobotModel& stated, RobotModel& model) {
  for (std::size_t joint = 0; joint < varies.size(); ++joint) {
    if (varies[joint] || has_wave_of_friction(stated.drives[joint])) continue;
    erase_waves_of_friction(model.drives[joint]);
  }
}

bool finds_gains(const RobotModel& model) {
  return std::any_of(model.controllers.begin(), model.controllers.end(),
                     [](const JointController& each) { return each.finds_stiffness; });
}

/// A gain with what scales with it, so many times as large, and another share of the delay.
RobotModel scaled(RobotModel model, double times, double share_of_delay) {
  for (const FreeValue& each : free_values(model)) {
    const bool scales = each.of == Of::kRotor || each.of == Of::kEffect;
    if (!scales || !model.controllers[each.joint].finds_stiffness) continue;
    set_value(model, each, std::clamp(times * value_in(model, each), each.lowest, each.highest));
  }
  for (JointController& each : model.controllers) {
    if (each.finds_stiffness) each.law.stiffness_Nm_rad *= times;
    if (each.finds_delay) each.delay_s *= share_of_delay;
  }
  return model;
}

/// Where the fit of gains begins: inverse dynamics see the bodies' torques through noise, which
/// makes gains too small, and a late law for friction; what the simulation itself follows best.
RobotModel begin_of_gains(const Log& log, const RobotModel& model) {
  const RobotModel start = servo_start(log, model);
  RobotModel best = start;
  double least_rad = std::numeric_limits<double>::infinity();
  for (const double times : {1.0, 2.0, 4.0}) {
    for (const double share : {1.0, 0.5, 0.0}) {
      RobotModel tried = scaled(start, times, share);
      const Rollout rollout = roll_out(log, tried, {kGainWindow_s, 0.0, kGainWindows, false});
      const bool is_better = rollout.train.diverged == 0 && rollout.train.windows > 0 &&
                             rollout.train.all_rad < least_rad;
      if (!is_better) continue;
      least_rad = rollout.train.all_rad;
      best = std::move(tried);
    }
  }
  return best;
}

/// The fit of gains was held to where it began; what documents state of them is told as such.
void tell_stated_gains(const RobotModel& stated, ValueFit& fit) {
  for (FittedValue& value : fit.values) {
    const bool is_gain = value.which.of == FreeValue::Of::kStiffness ||
                         value.which.of == FreeValue::Of::kDamping ||
                         value.which.of == FreeValue::Of::kDelay;
    if (!is_gain) continue;
    const bool is_unknown = value.which.of == FreeValue::Of::kStiffness &&
                            !stated.controllers[value.which.joint].states_stiffness;
    if (!is_unknown) value.stated = value_in(stated, value.which);
  }
}

}  // namespace

RobotStudy study_robot(const Rig& rig, const Log& log, const RobotModel& stated,
                       const std::vector<std::vector<std::size_t>>& alike,
                       const std::function<void(double share)>& on_progress) {
  RobotStudy study;
  RobotModel model = stated;
  add_plain_friction(model);
  for (actuator::Actuator& drive : model.drives) {
    if (!has_wave_of_friction(drive)) add_wave_of_friction(drive);
  }
  ValueFitOptions options;
  if (finds_gains(model)) {
    options.begin = begin_of_gains(log, model);
    model.controllers = options.begin->controllers;
  }
  options.most_rounds = kFirstRounds;
  const std::vector<FreeValue> first = all_values(rig, log, model);
  options.most_simulated_s = simulated_s(model, first);
  options.on_progress = [&](double share) {
    if (on_progress) on_progress(0.5 * share);
  };
  study.fit = fit_values(log, model, first, options);
  study.varies.assign(stated.drives.size(), false);
  if (study.fit.values.empty()) return study;
  study.varies = joints_that_vary(log, study.fit);
  options.begin = study.fit.model;
  erase_waves_but(study.varies, stated, model);
  erase_waves_but(study.varies, stated, *options.begin);
  options.most_rounds = kLastRounds;
  options.on_progress = [&](double share) {
    if (on_progress) on_progress(0.5 + 0.5 * share);
  };
  const double before_rad = study.fit.rms_before_rad;
  study.fit = fit_values(log, model, all_values(rig, log, model), options);
  study.fit.rms_before_rad = before_rad;
  tell_of(log, stated, alike, study);
  return study;
}

void tell_of(const Log& log, const RobotModel& stated,
             const std::vector<std::vector<std::size_t>>& alike, RobotStudy& study) {
  study.alike = compare_alike(log, study.fit, alike);
  study.load = load_errors(stated, study.fit);
  study.base = base_motion(log, study.fit.model);
  study.trade_offs = find_trade_offs(study.fit);
  tell_stated_gains(stated, study.fit);
}

}  // namespace torquewright::identification
