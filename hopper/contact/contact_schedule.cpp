// SPDX-License-Identifier: Apache-2.0
#include "hopper/contact/contact_schedule.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/point.hpp"
#include "hopper/motion/rounding_steps.hpp"
#include "hopper/motion/slopes.hpp"
#include "hopper/motion/smoothing.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A touch-down takes at least this much of the speed of approach within one step,
constexpr double kStopped = 0.5;
/// and changes it so many times more than the steps beside it do: else it is a smooth motion.
constexpr double kSharp = 3.0;

/// A point that lets go for a shorter time chatters on soft ground.
constexpr double kChatter_s = 0.01;

template <typename Take>
void for_each_point(const Robot& robot, const Motion& motion, bool with_velocity,
                    const Take& take) {
  dynamics::TreeState state(robot.tree);
  const VectorXd rest = VectorXd::Zero(robot.tree.velocity_size());
  for (Index sample = 0; sample < motion.samples(); ++sample) {
    if (with_velocity) {
      state.set(motion.positions.col(sample), motion.velocities.col(sample));
    } else {
      state.set(motion.positions.col(sample), rest);
    }
    for (std::size_t i = 0; i < robot.contacts.size(); ++i) {
      take(static_cast<Index>(i), sample, state, touching_point(robot.contacts[i], state));
    }
  }
}

MatrixXd heights(const Robot& robot, const Motion& motion, double ground_m) {
  MatrixXd heights_m(robot.contacts.size(), motion.samples());
  for_each_point(robot, motion, false,
                 [&](Index i, Index sample, const dynamics::TreeState& state,
                     const dynamics::BodyPoint& point) {
                   const Eigen::Vector3d place_m = dynamics::point_position_m(state, point);
                   heights_m(i, sample) =
                       place_m.z() - ground_m - motion.ground.height_m(place_m.x());
                 });
  return heights_m;
}

MatrixXd vertical_speeds(const Robot& robot, const Motion& motion) {
  MatrixXd speeds_m_s(robot.contacts.size(), motion.samples());
  for_each_point(robot, motion, true,
                 [&](Index i, Index sample, const dynamics::TreeState& state,
                     const dynamics::BodyPoint& point) {
                   speeds_m_s(i, sample) = dynamics::point_velocity_m_s(state, point).z();
                 });
  return speeds_m_s;
}

/// What approached the ground and leaves it within an impact, between two rows of one time, was
/// thrown back by it: it touches at the second of them, however fast it leaves.
void stop_at_bounces(const Motion& motion, MatrixXd& speeds_m_s) {
  for (Index sample = 1; sample < motion.samples(); ++sample) {
    if (motion.step_s(sample - 1) > 0.0) continue;
    for (Index i = 0; i < speeds_m_s.rows(); ++i) {
      if (speeds_m_s(i, sample - 1) < 0.0 && speeds_m_s(i, sample) > 0.0) {
        speeds_m_s(i, sample) = 0.0;
      }
    }
  }
}

/// Speed of approach just before and just after a sample begins, from the heights alone where no
/// velocity is given.
struct Approach {
  double before_m_s;
  double after_m_s;
};

Approach approach_at(const Motion& motion, const MatrixXd& heights_m, const MatrixXd& speeds_m_s,
                     Index contact, Index sample) {
  if (speeds_m_s.size() > 0) {
    return {-speeds_m_s(contact, sample - 1), -speeds_m_s(contact, sample)};
  }
  const auto slope = [&](Index from) {
    return (heights_m(contact, from + 1) - heights_m(contact, from)) / motion.step_s(from);
  };
  const Index last = motion.samples() - 1;
  return {-slope(std::max<Index>(sample - 2, 0)), sample < last ? -slope(sample) : 0.0};
}

/// Of heights alone: an impact bends their slope at the two samples around it and nowhere beside.
bool is_sharp_bend(const Motion& motion, const MatrixXd& heights_m, Index contact, Index sample) {
  const auto bend = [&](Index at) {
    if (at < 1 || at + 1 >= motion.samples()) return 0.0;
    if (motion.step_s(at - 1) == 0.0 || motion.step_s(at) == 0.0) return 0.0;
    return (heights_m(contact, at + 1) - heights_m(contact, at)) / motion.step_s(at) -
           (heights_m(contact, at) - heights_m(contact, at - 1)) / motion.step_s(at - 1);
  };
  const double inside = std::abs(bend(sample - 1) + bend(sample));
  const double beside = std::max(std::abs(bend(sample - 2)), std::abs(bend(sample + 1)));
  return inside > kSharp * beside;
}

/// Whether the velocities change far more into a sample than in the steps before and after.
bool is_sharp(const Motion& motion, const MatrixXd& heights_m, const MatrixXd& speeds_m_s,
              Index contact, Index sample) {
  if (speeds_m_s.size() == 0) return is_sharp_bend(motion, heights_m, contact, sample);
  const auto rate = [&](Index to) {
    if (to < 1 || to >= motion.samples() || motion.step_s(to - 1) == 0.0) return 0.0;
    return std::abs(speeds_m_s(contact, to) - speeds_m_s(contact, to - 1)) / motion.step_s(to - 1);
  };
  return rate(sample) > kSharp * std::max(rate(sample - 1), rate(sample + 1));
}

/// By how much the approach may seem to change at a sample because of the steps to which positions
/// or velocities are rounded, (points x samples); empty where they are not.
MatrixXd rounding_of_approach(const Robot& robot, const Motion& motion) {
  if (motion.steps.isZero(0.0)) return {};
  MatrixXd most_m_s(robot.contacts.size(), motion.samples());
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, motion.steps.size());
  for_each_point(robot, motion, false,
                 [&](Index i, Index sample, const dynamics::TreeState& state,
                     const dynamics::BodyPoint& point) {
                   jacobian.setZero();
                   dynamics::point_jacobian(state, point, jacobian);
                   most_m_s(i, sample) = 0.5 * jacobian.row(2).cwiseAbs().dot(motion.steps);
                 });
  if (has_given_velocity(motion)) return 2.0 * most_m_s;  // of either velocity
  // Of both ends of either slope.
  for (Index sample = 1; sample < motion.samples(); ++sample) {
    most_m_s.col(sample) *= 4.0 / std::max(motion.step_s(sample - 1), 1e-300);
  }
  return most_m_s;
}

void add_touch_downs(const ContactThresholds& rule, const MatrixXd& heights_m,
                     const MatrixXd& speeds_m_s, const MatrixXd& rounding_m_s, Motion& motion) {
  std::vector<Index> found = motion.breaks;
  for (Index sample = 1; sample < motion.samples(); ++sample) {
    if (motion.step_s(sample - 1) == 0.0) continue;              // stated already
    if (!found.empty() && found.back() == sample - 1) continue;  // its slope before holds that one
    for (Index i = 0; i < heights_m.rows(); ++i) {
      if (heights_m(i, sample) > rule.height_m) continue;
      const Approach approach = approach_at(motion, heights_m, speeds_m_s, i, sample);
      if (approach.before_m_s <= rule.speed_m_s ||
          approach.after_m_s > (1.0 - kStopped) * approach.before_m_s ||
          (rounding_m_s.size() > 0 &&
           approach.before_m_s - approach.after_m_s <= rounding_m_s(i, sample)) ||
          !is_sharp(motion, heights_m, speeds_m_s, i, sample)) {
        continue;
      }
      found.push_back(sample);
      break;
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  motion.breaks = std::move(found);
}

/// A point that lets go for a moment chatters: it may press at any time in between.
void close_gaps(const Motion& motion, Touching& presses) {
  for (Index i = 0; i < presses.rows(); ++i) {
    Index last = -1;
    for (Index sample = 0; sample < motion.samples(); ++sample) {
      if (motion.is_break(sample)) last = -1;
      if (!presses(i, sample)) continue;
      const bool is_gap = last >= 0 && last < sample - 1;
      if (is_gap && motion.time_s(sample) - motion.time_s(last) < kChatter_s) {
        presses.row(i).segment(last, sample - last).setConstant(true);
      }
      last = sample;
    }
  }
}

void derive_smoothed(const Robot& robot, Motion& motion) {
  if (motion.reach > 0) return derive_rates(robot.tree, motion, motion.reach);
  const bool lacks_some =
      motion.velocity_origin != Origin::kGiven || motion.acceleration_origin != Origin::kGiven;
  if (!lacks_some) return;
  const Smoothing smoothing = smoothing_of(robot.tree, motion);
  motion.acceleration_noise = smoothing.acceleration_noise;
  motion.acceleration_doubt = smoothing.acceleration_doubt;
  derive_rates(robot.tree, motion, smoothing.reach);
}

}  // namespace

ContactThresholds ContactRule::thresholds() const {
  const ContactThresholds usual;
  return {height_m.value_or(usual.height_m), speed_m_s.value_or(usual.speed_m_s)};
}

Touching touching_by(const ContactThresholds& thresholds, const ContactSchedule& schedule) {
  return schedule.height_m.array() <= thresholds.height_m &&
         schedule.speed_m_s.array().abs() <= thresholds.speed_m_s;
}

Touching pressing(const Touching& touches, const Motion& motion) {
  if (motion.acceleration_origin != Origin::kDerived) return touches;
  Touching presses = touches;
  close_gaps(motion, presses);
  // One more: what touches between two samples may show at neither.
  for (Index step = 0; step <= motion.reach; ++step) {
    const Touching before = presses;
    for (Index sample = 1; sample < motion.samples(); ++sample) {
      if (motion.is_break(sample)) continue;
      presses.col(sample) = presses.col(sample) || before.col(sample - 1);
      presses.col(sample - 1) = presses.col(sample - 1) || before.col(sample);
    }
  }
  return presses;
}

void guide_by_forces(const Motion& motion, ContactSchedule& schedule) {
  if (!motion.forces_guide) return;
  schedule.guide_N = spread_as_accelerations(motion, motion.forces_N);
  schedule.guide_doubt_N.setZero(schedule.touches.rows(), motion.samples());
  for (Index sample = 0; sample < motion.samples(); ++sample) {
    const Index last = std::min(sample + motion.reach, motion.samples() - 1);
    for (Index to = std::max<Index>(1, sample - motion.reach + 1); to <= last; ++to) {
      const VectorXd jump = motion.forces_N.col(to) - motion.forces_N.col(to - 1);
      for (Index i = 0; i < schedule.touches.rows(); ++i) {
        double& doubt_N = schedule.guide_doubt_N(i, sample);
        doubt_N = std::max(doubt_N, 0.5 * jump.segment<3>(3 * i).norm());
      }
    }
  }
}

ContactSchedule schedule_contacts(const Robot& robot, const ContactRule& rule, Motion& motion) {
  ContactSchedule schedule;
  const auto contacts = static_cast<Index>(robot.contacts.size());
  schedule.touches.setConstant(contacts, motion.samples(), false);
  if (!motion.has_base) {
    derive_rates(robot.tree, motion);
    return schedule;
  }
  schedule.thresholds = rule.thresholds();
  schedule.near_ground_m = schedule.thresholds.height_m;
  schedule.height_m = heights(robot, motion, rule.ground_height_m);
  const bool has_velocity = motion.velocity_origin == Origin::kGiven;
  if (motion.steps.size() == 0) motion.steps = rounding_steps(robot.tree, motion);
  add_touch_downs(schedule.thresholds, schedule.height_m,
                  has_velocity ? vertical_speeds(robot, motion) : MatrixXd(),
                  rounding_of_approach(robot, motion), motion);
  derive_smoothed(robot, motion);
  if (motion.has_forces) {
    schedule.origin = Origin::kGiven;
    for (Index i = 0; i < contacts; ++i) {
      schedule.touches.row(i) =
          (motion.forces_N.middleRows(3 * i, 3).colwise().squaredNorm().array() > 0.0);
    }
  } else if (motion.has_touching) {
    schedule.origin = Origin::kGiven;
    schedule.touches = motion.touching.array() != 0.0;
  } else {
    schedule.speed_m_s = vertical_speeds(robot, motion);
    stop_at_bounces(motion, schedule.speed_m_s);
    schedule.touches = touching_by(schedule.thresholds, schedule);
  }
  schedule.presses = pressing(schedule.touches, motion);
  motion.forces_guide = motion.has_forces && motion.acceleration_origin == Origin::kDerived;
  guide_by_forces(motion, schedule);
  return schedule;
}

}  // namespace torquewright::hopper
