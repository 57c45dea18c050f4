// SPDX-License-Identifier: Apache-2.0
#include "simulation/stepper/stepper.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/sign.hpp"
#include "simulation/stepper/sticking.hpp"
#include "simulation/stepper/stops.hpp"

namespace torquewright::simulation {
namespace {

constexpr int kMostParts = 6;      ///< Stops and starts within one step; the last goes to its end.
constexpr int kStopRounds = 8;     ///< Of approaching a stop.
constexpr double kStopped = 1e-6;  ///< Of the time to it.

/// From `from` to `to` after a time, with the speeds of `rates` and the motion's accelerations.
void move(PlantState& to, const PlantState& from, const PlantState& rates,
          const PlantMotion& motion, double step_s) {
  for (std::size_t j = 0; j < to.joints.size(); ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    const JointState& a = from.joints[j];
    JointState& b = to.joints[j];
    b.position_rad = a.position_rad + step_s * rates.joints[j].speed_rad_s;
    b.speed_rad_s = a.speed_rad_s + step_s * motion.acceleration_rad_s2[row];
    b.motor_position_rad = a.motor_position_rad + step_s * rates.joints[j].motor_speed_rad_s;
    b.motor_speed_rad_s = a.motor_speed_rad_s + step_s * motion.motor_acceleration_rad_s2[row];
  }
}

}  // namespace

void Stepper::add_work(const PlantState& middle, const PlantMotion& motion, double step_s,
                       WorkAccount& work) const {
  work.add(middle, motion, equations_.models(), equations_.is_imposed(), step_s);
}

void Stepper::midpoint(const PlantState& from, const std::vector<double>& directions,
                       const std::vector<DriveNow>& drive, double step_s, Part& part) {
  const PlantMotion first = equations_.motion(from, directions, drive, nullptr);
  move(part.middle, from, from, first, 0.5 * step_s);
  stop_reversed(part.middle, directions, equations_.models());
  part.motion = equations_.motion(part.middle, directions, drive, nullptr);
  move(part.end, from, part.middle, part.motion, step_s);
}

void Stepper::advance(PlantState& state, const std::vector<DriveNow>& drive, double step_s,
                      WorkAccount& work) {
  double left_s = step_s;
  for (int number = 0; number < kMostParts && left_s > 0.0; ++number) {
    const std::vector<double> ways = directions_of(equations_, state, drive);
    Part& part = part_;
    part.middle = state;
    part.end = state;
    midpoint(state, ways, drive, left_s, part);
    double part_s = left_s;
    if (number + 1 < kMostParts && share_to_stop(state, part.end, ways) < 1.0) {
      // The earliest stop within the part ends it there. The rates on the way to it differ from
      // those of the whole part, so it is approached.
      for (int round = 0; round < kStopRounds; ++round) {
        const double share = share_to_stop(state, part.end, ways);
        if (std::abs(share - 1.0) < kStopped) break;
        part_s = std::min(left_s, part_s * share);
        midpoint(state, ways, drive, part_s, part);
      }
      stop_slowed(state, part.end, equations_.models());
    } else {
      stop_reversed(part.end, ways, equations_.models());
    }
    add_work(part.middle, part.motion, part_s, work);
    state = part.end;
    left_s -= part_s;
  }
}

double Stepper::advance_rigid_imposed(PlantState& state, const std::vector<DriveNow>& drive,
                                      double step_s, const ImposedStep& imposed,
                                      WorkAccount& work) {
  PlantState at = state;
  JointState& half = at.joints[0];
  half.position_rad = half.motor_position_rad = imposed.middle_position_rad;
  half.speed_rad_s = half.motor_speed_rad_s = imposed.middle_speed_rad_s;
  const Eigen::VectorXd acceleration =
      Eigen::VectorXd::Constant(1, imposed.middle_acceleration_rad_s2);
  const PlantMotion motion =
      equations_.motion(at, {sign_of(imposed.middle_speed_rad_s)}, drive, &acceleration);
  add_work(at, motion, step_s, work);
  JointState& joint = state.joints[0];
  joint.position_rad = joint.motor_position_rad = imposed.end_position_rad;
  joint.speed_rad_s = joint.motor_speed_rad_s = imposed.end_speed_rad_s;
  return motion.torque_Nm[0];
}

double Stepper::advance_imposed(PlantState& state, const std::vector<DriveNow>& drive,
                                double step_s, const ImposedStep& imposed, WorkAccount& work) {
  if (!equations_.models()[0].is_elastic()) {
    return advance_rigid_imposed(state, drive, step_s, imposed, work);
  }
  const Eigen::VectorXd acceleration =
      Eigen::VectorXd::Constant(1, imposed.middle_acceleration_rad_s2);
  const std::vector<double> ways = directions_of(equations_, state, drive);
  const PlantMotion first = equations_.motion(state, ways, drive, &acceleration);
  JointState& joint = state.joints[0];
  PlantState at = state;
  JointState& half = at.joints[0];
  half.position_rad = imposed.middle_position_rad;
  half.speed_rad_s = imposed.middle_speed_rad_s;
  half.motor_position_rad += 0.5 * step_s * joint.motor_speed_rad_s;
  half.motor_speed_rad_s += 0.5 * step_s * first.motor_acceleration_rad_s2[0];
  if (half.motor_speed_rad_s * ways[0] <= 0.0) half.motor_speed_rad_s = 0.0;
  const PlantMotion motion = equations_.motion(at, ways, drive, &acceleration);
  add_work(at, motion, step_s, work);
  joint.motor_position_rad += step_s * half.motor_speed_rad_s;
  const double speed = joint.motor_speed_rad_s + step_s * motion.motor_acceleration_rad_s2[0];
  joint.motor_speed_rad_s = ways[0] == 0.0 || speed * ways[0] < 0.0 ? 0.0 : speed;
  joint.position_rad = imposed.end_position_rad;
  joint.speed_rad_s = imposed.end_speed_rad_s;
  return motion.torque_Nm[0];
}

}  // namespace torquewright::simulation
