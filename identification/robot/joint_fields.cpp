// SPDX-License-Identifier: Apache-2.0
#include "identification/robot/joint_fields.hpp"

#include <algorithm>

#include "actuator/effects/every_effect.hpp"
#include "actuator/effects/library.hpp"

namespace torquewright::identification {
namespace {

using Of = FreeValue::Of;

constexpr std::size_t kFieldRounds = 5;

/// A drive with nothing but what a joint's fields hold.
void keep_fields(actuator::Actuator& drive) {
  std::erase_if(drive.effects, [](const actuator::Effect& each) {
    return each.kind != &actuator::effects::viscous_friction &&
           each.kind != &actuator::effects::coulomb_friction &&
           each.kind != &actuator::effects::parallel_spring;
  });
}

/// Holds rotors that end at a bound, of which nothing is told, at what is stated; whether there is
/// one.
bool hold_untold_rotors(const RobotModel& stated, const ValueFit& fit, RobotModel& model,
                        RobotModel& begin, std::vector<FreeValue>& values) {
  bool holds = false;
  for (const FittedValue& each : fit.values) {
    if (each.which.of != Of::kRotor || !each.is_at_bound) continue;
    const double value = value_in(stated, each.which);
    set_value(model, each.which, value);
    set_value(begin, each.which, value);
    std::erase_if(values, [&](const FreeValue& one) {
      return one.of == Of::kRotor && one.joint == each.which.joint;
    });
    holds = true;
  }
  return holds;
}

std::vector<FreeValue> drive_values(const RobotModel& model) {
  std::vector<FreeValue> values = free_values(model);
  for (FreeValue& each : controller_values(model)) values.push_back(std::move(each));
  return values;
}

}  // namespace

std::vector<std::vector<std::size_t>> groups_without_unlike(
    const RobotStudy& study, const std::vector<std::vector<std::size_t>>& alike) {
  std::vector<std::vector<std::size_t>> groups = alike;
  for (std::vector<std::size_t>& group : groups) {
    std::erase_if(group, [&](std::size_t joint) {
      return std::any_of(study.alike.begin(), study.alike.end(), [&](const AlikeNumber& number) {
        return std::any_of(number.unlike.begin(), number.unlike.end(),
                           [&](const UnlikeJoint& each) { return each.own.joint == joint; });
      });
    });
  }
  std::erase_if(groups, [](const auto& group) { return group.empty(); });
  return groups;
}

std::vector<LoadReading> certain_errors(const LoadErrors& load) {
  std::vector<LoadReading> certain;
  for (const LoadError& each : load.errors) {
    if (each.readings.size() == 1) certain.push_back(each.readings.front());
  }
  return certain;
}

ValueFit fit_of_groups(const Log& log, const RobotModel& stated, const RobotStudy& study,
                       const std::vector<std::vector<std::size_t>>& groups,
                       const std::function<void(double share)>& on_progress) {
  RobotModel model = study.fit.model;
  // A wave of one joint's friction is its sisters' too.
  for (const std::vector<std::size_t>& group : groups) {
    const bool varies = std::any_of(group.begin(), group.end(), [&](std::size_t joint) {
      return has_wave_of_friction(model.drives[joint]);
    });
    for (const std::size_t joint : group) {
      if (varies && !has_wave_of_friction(model.drives[joint]))
        add_wave_of_friction(model.drives[joint]);
    }
  }
  ValueFitOptions options;
  options.most_rounds = kFieldRounds;
  options.on_progress = on_progress;
  options.begin = model;
  model.load = stated.load;
  std::vector<FreeValue> values = drive_values(model);
  tie(groups, values);
  for (const FreeValue& each : values) set_value(*options.begin, each, value_in(model, each));
  options.begin->load = stated.load;
  return fit_values(log, model, values, options);
}

ValueFit fit_of_fields(const Log& log, const RobotModel& stated, const RobotStudy& study,
                       const std::vector<std::vector<std::size_t>>& groups,
                       const std::function<void(double share)>& on_progress) {
  RobotModel model = study.fit.model;
  model.load = stated.load;
  model.offset_rad.assign(model.offset_rad.size(), 0.0);
  for (actuator::Actuator& drive : model.drives) keep_fields(drive);
  add_plain_friction(model);
  for (const LoadReading& each : certain_errors(study.load)) {
    set_value(model, each.which, value_in(model, each.which) + each.change);
  }
  std::vector<FreeValue> values = drive_values(model);
  std::erase_if(values, [](const FreeValue& each) { return each.of == Of::kOffset; });
  tie(groups, values);
  ValueFitOptions options;
  options.most_rounds = kFieldRounds;
  options.on_progress = on_progress;
  options.begin = model;
  for (const FreeValue& each : values) set_value(*options.begin, each, value_in(model, each));
  ValueFit fit = fit_values(log, model, values, options);
  options.begin = fit.model;
  if (!hold_untold_rotors(stated, fit, model, *options.begin, values)) return fit;
  return fit_values(log, model, values, options);
}

}  // namespace torquewright::identification
