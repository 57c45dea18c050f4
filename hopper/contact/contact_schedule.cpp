// SPDX-License-Identifier: Apache-2.0
#include "hopper/contact/contact_schedule.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/point.hpp"
#include "hopper/motion/slopes.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A touch-down takes at least this much of the speed of approach within one step,
constexpr double kStopped = 0.5;
/// and changes it so many times more than the steps beside it do: else it is a smooth motion.
constexpr double kSharp = 3.0;

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
      take(static_cast<Index>(i), sample, state, robot.contacts[i].point);
    }
  }
}

MatrixXd heights(const Robot& robot, const Motion& motion, double ground_m) {
  MatrixXd heights_m(robot.contacts.size(), motion.samples());
  for_each_point(robot, motion, false,
                 [&](Index i, Index sample, const dynamics::TreeState& state,
                     const dynamics::BodyPoint& point) {
                   heights_m(i, sample) = dynamics::point_position_m(state, point).z() - ground_m;
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

/// Whether the velocities change far more into a sample than in the steps before and after.
bool is_sharp(const Motion& motion, const MatrixXd& speeds_m_s, Index contact, Index sample) {
  if (speeds_m_s.size() == 0) return true;  // heights alone do not tell
  const auto rate = [&](Index to) {
    if (to < 1 || to >= motion.samples() || motion.step_s(to - 1) == 0.0) return 0.0;
    return std::abs(speeds_m_s(contact, to) - speeds_m_s(contact, to - 1)) / motion.step_s(to - 1);
  };
  return rate(sample) > kSharp * std::max(rate(sample - 1), rate(sample + 1));
}

void add_touch_downs(const ContactRule& rule, const MatrixXd& heights_m, const MatrixXd& speeds_m_s,
                     Motion& motion) {
  std::vector<Index> found = motion.breaks;
  for (Index sample = 1; sample < motion.samples(); ++sample) {
    if (motion.step_s(sample - 1) == 0.0) continue;              // stated already
    if (!found.empty() && found.back() == sample - 1) continue;  // its slope before holds that one
    for (Index i = 0; i < heights_m.rows(); ++i) {
      if (heights_m(i, sample) > rule.height_m) continue;
      const Approach approach = approach_at(motion, heights_m, speeds_m_s, i, sample);
      if (approach.before_m_s <= rule.speed_m_s ||
          approach.after_m_s > (1.0 - kStopped) * approach.before_m_s ||
          !is_sharp(motion, speeds_m_s, i, sample)) {
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

}  // namespace

ContactSchedule schedule_contacts(const Robot& robot, const ContactRule& rule, Motion& motion) {
  ContactSchedule schedule;
  const auto contacts = static_cast<Index>(robot.contacts.size());
  schedule.touches.setConstant(contacts, motion.samples(), false);
  if (!motion.has_base) {
    derive_rates(robot.tree, motion);
    return schedule;
  }
  schedule.near_ground_m = rule.height_m;
  schedule.height_m = heights(robot, motion, rule.ground_height_m);
  const bool has_velocity = motion.velocity_origin == Origin::kGiven;
  add_touch_downs(rule, schedule.height_m,
                  has_velocity ? vertical_speeds(robot, motion) : MatrixXd(), motion);
  derive_rates(robot.tree, motion);
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
    const MatrixXd speeds_m_s = vertical_speeds(robot, motion);
    schedule.touches =
        schedule.height_m.array() <= rule.height_m && speeds_m_s.array().abs() <= rule.speed_m_s;
  }
  return schedule;
}

}  // namespace torquewright::hopper
