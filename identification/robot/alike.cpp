// SPDX-License-Identifier: Apache-2.0
#include "identification/robot/alike.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "actuator/heat/temperature_laws.hpp"
#include "actuator/region/torque_at.hpp"
#include "identification/rollout/windows.hpp"

namespace torquewright::identification {
namespace {

using Of = FreeValue::Of;

constexpr std::size_t kLeastAlike = 3;
constexpr double kUnlikeSigmas = 5.0;
constexpr std::array<double, 3> kPlaces = {0.05, 0.5, 0.95};
constexpr double kBump = 1e-4;  ///< Of a value's size, between two evaluations.

/// A number of a joint as a function of the robot's model.
using Number = std::function<double(const RobotModel&)>;

double dry_friction_Nm(const actuator::Actuator& drive, double position_rad) {
  actuator::Instant at = actuator::at_winding_temperature(drive, drive.motor.winding_temperature_K);
  at.direction = 1.0;
  at.output_angle_rad = position_rad;
  return -actuator::drag_Nm(drive, at);
}

/// With the error that the covariance of the joint's own values leaves.
JointNumber evaluated(const ValueFit& fit, std::size_t joint, const Number& number) {
  JointNumber found{joint, number(fit.model), 0.0};
  std::vector<Eigen::Index> own;
  std::vector<double> slopes;
  for (std::size_t k = 0; k < fit.values.size(); ++k) {
    const FreeValue& which = fit.values[k].which;
    if (which.joint != joint || which.is_of_all()) continue;
    RobotModel moved = fit.model;
    const double step = kBump * which.size;
    set_value(moved, which, fit.values[k].value + step);
    own.push_back(static_cast<Eigen::Index>(k));
    slopes.push_back((number(moved) - found.value) / step);
  }
  double variance = 0.0;
  for (std::size_t a = 0; a < own.size(); ++a) {
    for (std::size_t b = 0; b < own.size(); ++b) {
      variance += slopes[a] * slopes[b] * fit.covariance(own[a], own[b]);
    }
  }
  found.standard_error = std::sqrt(std::max(variance, 0.0));
  return found;
}

struct Pooled {
  double value = 0.0, standard_error = 0.0;
};

/// Weighted by their errors; the error is at least what their differences say.
Pooled pooled(const std::vector<JointNumber>& numbers) {
  double weights = 0.0, sum = 0.0;
  for (const JointNumber& each : numbers) {
    const double weight = 1.0 / std::max(each.standard_error * each.standard_error, 1e-30);
    weights += weight;
    sum += weight * each.value;
  }
  const double mean = sum / weights;
  double square = 0.0;
  for (const JointNumber& each : numbers) square += (each.value - mean) * (each.value - mean);
  const auto count = static_cast<double>(numbers.size());
  const double scatter = count > 1.0 ? std::sqrt(square / (count - 1.0) / count) : 0.0;
  return {mean, std::max(std::sqrt(1.0 / weights), scatter)};
}

/// Its distance from the nearest of its sisters, beyond all of them, over their range; 0: within.
double outside(const JointNumber& one, const std::vector<JointNumber>& sisters) {
  const auto [least, most] = std::minmax_element(
      sisters.begin(), sisters.end(),
      [](const JointNumber& a, const JointNumber& b) { return a.value < b.value; });
  const double beyond = std::max(least->value - one.value, one.value - most->value);
  const double range = most->value - least->value;
  if (beyond <= 0.0) return 0.0;
  return range > 0.0 ? beyond / range : 1e9;
}

void find_unlike(AlikeNumber& number) {
  std::vector<JointNumber> alike;
  for (const JointNumber& one : number.joints) {
    std::vector<JointNumber> sisters;
    double weights = 0.0;
    for (const JointNumber& other : number.joints) {
      if (other.joint == one.joint) continue;
      sisters.push_back(other);
      weights += 1.0 / std::max(other.standard_error * other.standard_error, 1e-30);
    }
    const double error = std::hypot(one.standard_error, std::sqrt(1.0 / weights));
    const double sigmas = std::abs(one.value - pooled(sisters).value) / error;
    if (sigmas > kUnlikeSigmas && outside(one, sisters) > 1.0) {
      number.unlike.push_back({one, sigmas});
    } else {
      alike.push_back(one);
    }
  }
  const Pooled common = pooled(alike.empty() ? number.joints : alike);
  number.value = common.value;
  number.standard_error = common.standard_error;
}

std::vector<double> places_of(const Log& log, const std::vector<std::size_t>& group) {
  std::vector<double> all;
  for (const Run& run : log.runs) {
    for (const std::size_t joint : group) {
      const std::vector<double>& position = run.joints[joint][Quantity::kOutputPosition];
      all.insert(all.end(), position.begin(), position.end());
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<double> places;
  for (const double share : kPlaces) {
    places.push_back(all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))]);
  }
  return places;
}

AlikeNumber compared(const ValueFit& fit, const std::vector<std::size_t>& group, std::string name,
                     const std::function<Number(std::size_t joint)>& number) {
  AlikeNumber one;
  one.name = std::move(name);
  for (const std::size_t joint : group) {
    one.joints.push_back(evaluated(fit, joint, number(joint)));
  }
  find_unlike(one);
  return one;
}

/// Whether a joint's value is one to be compared as it stands; dry friction is compared by place.
bool is_compared(const FreeValue& which) {
  return which.of == Of::kRotor ||
         (which.of == Of::kEffect && which.name.find("coulomb") == std::string::npos);
}

bool has_value(const ValueFit& fit, std::size_t joint, const FreeValue& like) {
  return std::any_of(fit.values.begin(), fit.values.end(), [&](const FittedValue& each) {
    return each.which.of == like.of && each.which.joint == joint &&
           each.which.effect == like.effect && each.which.parameter == like.parameter;
  });
}

void compare_group(const Log& log, const ValueFit& fit, const std::vector<std::size_t>& group,
                   std::vector<AlikeNumber>& found) {
  for (const FittedValue& each : fit.values) {
    if (each.which.joint != group.front() || !is_compared(each.which)) continue;
    const bool is_in_all = std::all_of(group.begin(), group.end(), [&](std::size_t joint) {
      return has_value(fit, joint, each.which);
    });
    if (!is_in_all) continue;
    found.push_back(compared(fit, group, each.which.name, [&](std::size_t joint) {
      FreeValue which = each.which;
      which.joint = joint;
      return [which](const RobotModel& model) { return value_in(model, which); };
    }));
  }
  const bool varies = std::any_of(group.begin(), group.end(), [&](std::size_t joint) {
    return has_wave_of_friction(fit.model.drives[joint]);
  });
  for (const double place_rad : places_of(log, group)) {
    const std::string name =
        varies ? fmt::format("dry_friction_Nm at {:.2f} rad", place_rad) : "dry_friction_Nm";
    found.push_back(compared(fit, group, name, [&](std::size_t joint) {
      return [joint, place_rad](const RobotModel& model) {
        return dry_friction_Nm(model.drives[joint], place_rad);
      };
    }));
    if (!varies) return;
  }
}

}  // namespace

std::vector<AlikeNumber> compare_alike(const Log& log, const ValueFit& fit,
                                       const std::vector<std::vector<std::size_t>>& groups) {
  std::vector<AlikeNumber> found;
  if (fit.values.empty() || fit.covariance.size() == 0) return found;
  for (const std::vector<std::size_t>& group : groups) {
    if (group.size() >= kLeastAlike) compare_group(log, fit, group, found);
  }
  return found;
}

}  // namespace torquewright::identification
