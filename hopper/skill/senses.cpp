// SPDX-License-Identifier: Apache-2.0
#include "hopper/skill/senses.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hopper/verdict/turn.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/nearest.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Rows of a frame: the base's, then four of each joint, then phase and command.
constexpr Index kBase = 10;
constexpr Index kOfJoint = 4;
constexpr Index kLast = 6;

Index joints_of(const Robot& robot) { return static_cast<Index>(robot.tree.bodies.size()) - 1; }

/// Rate in the base's axes.
Eigen::Vector3d base_rate_rad_s(const dynamics::Tree& tree, const VectorXd& velocity) {
  if (tree.base == dynamics::BaseKind::kPlanar) return velocity[2] * Eigen::Vector3d::UnitY();
  if (tree.base == dynamics::BaseKind::kFixed) return Eigen::Vector3d::Zero();
  return velocity.segment<3>(3);
}

io::Fault fault_of(const PolicyInput& input, std::size_t place, const std::string& file,
                   const std::vector<PolicyInput>& known) {
  std::vector<std::string> names;
  for (const PolicyInput& one : known) names.push_back(one.name);
  const auto nearest = io::nearest(input.name, names);
  return {file, fmt::format("/inputs/{}/name", place),
          fmt::format("\"{}\" in {} is nothing that this robot's sensors see{}", input.name,
                      input.unit, nearest ? fmt::format(" (did you mean \"{}\"?)", *nearest) : "")};
}

}  // namespace

std::vector<PolicyInput> every_sense(const Robot& robot) {
  std::vector<PolicyInput> all{{"gravity_x", "1"},
                               {"gravity_y", "1"},
                               {"gravity_z", "1"},
                               {"base_pitch_sin", "1"},
                               {"base_pitch_cos", "1"},
                               {"base_pitch_rad", "rad"},
                               {"base_rate_x_rad_s", "rad/s"},
                               {"base_rate_y_rad_s", "rad/s"},
                               {"base_rate_z_rad_s", "rad/s"},
                               {"base_pitch_rate_rad_s", "rad/s"}};
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    const std::string& joint = robot.tree.bodies[body].joint.name;
    all.push_back({joint + "_rad", "rad"});
    all.push_back({joint + "_rad_s", "rad/s"});
    all.push_back({joint + "_target_rad", "rad"});
    all.push_back({joint + "_error_rad", "rad"});
  }
  for (const char* phase : {"phase_sin", "phase_cos", "phase_flight", "phase_landing"}) {
    all.push_back({phase, "1"});
  }
  all.push_back({"command_forward_m_s", "m/s"});
  all.push_back({"command_yaw_rad_s", "rad/s"});
  return all;
}

Senses::Senses(const Robot& robot, const std::vector<PolicyInput>& inputs, const PhaseTimes& phase,
               const std::string& file)
    : robot_(robot), phase_(phase) {
  const std::vector<PolicyInput> known = every_sense(robot);
  std::vector<io::Fault> faults;
  int longest = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto found = std::find_if(known.begin(), known.end(), [&](const PolicyInput& one) {
      return one.name == inputs[i].name && one.unit == inputs[i].unit;
    });
    if (found == known.end()) {
      faults.push_back(fault_of(inputs[i], i, file, known));
      continue;
    }
    from_.push_back({static_cast<Index>(found - known.begin()), inputs[i].delay_steps});
    longest = std::max(longest, inputs[i].delay_steps);
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
  frames_.setZero(static_cast<Index>(known.size()), longest + 1);
}

void Senses::start() {
  is_first_ = true;
  newest_ = 0;
}

void Senses::note_base(const Observation& seen, Eigen::Ref<VectorXd> frame) const {
  const Eigen::Matrix3d attitude = base_attitude(robot_.tree, seen.position);
  const Eigen::Vector3d down = -attitude.row(2).transpose();
  frame.head<3>() = down;
  // About +y alone: where the base's z leans towards +x the sine is positive.
  const double lean = std::hypot(attitude(0, 2), attitude(2, 2));
  frame[3] = lean > 0.0 ? attitude(0, 2) / lean : 0.0;
  frame[4] = lean > 0.0 ? attitude(2, 2) / lean : 1.0;
  frame[5] = std::atan2(frame[3], frame[4]);
  frame.segment<3>(6) = base_rate_rad_s(robot_.tree, seen.velocity);
  frame[9] = frame[7];
}

void Senses::note_phase(double time_s, Eigen::Ref<VectorXd> frame) const {
  const Index at = frame.size() - kLast;
  const bool repeats = phase_.period_s > 0.0;
  // What happens once goes half around, so that its end is not its begin.
  const double angle_rad = repeats ? 2.0 * std::numbers::pi * time_s / phase_.period_s
                           : phase_.end_s > 0.0
                               ? std::numbers::pi * std::min(1.0, time_s / phase_.end_s)
                               : 0.0;
  frame[at] = std::sin(angle_rad);
  frame[at + 1] = std::cos(angle_rad);
  const bool is_once = phase_.landing_s > 0.0;
  frame[at + 2] = is_once && time_s >= phase_.take_off_s && time_s < phase_.landing_s ? 1.0 : 0.0;
  frame[at + 3] = is_once && time_s >= phase_.landing_s ? 1.0 : 0.0;
}

void Senses::note(double time_s, const Observation& seen, const VectorXd& target_rad,
                  const Command& command) {
  if (!is_first_) newest_ = (newest_ + 1) % frames_.cols();
  auto frame = frames_.col(newest_);
  note_base(seen, frame);
  const Index joints = joints_of(robot_);
  for (Index joint = 0; joint < joints; ++joint) {
    const double position_rad = seen.position.tail(joints)[joint];
    const Index at = kBase + kOfJoint * joint;
    frame[at] = position_rad;
    frame[at + 1] = seen.velocity.tail(joints)[joint];
    frame[at + 2] = target_rad[joint];
    frame[at + 3] = target_rad[joint] - position_rad;
  }
  note_phase(time_s, frame);
  frame[frame.size() - 2] = command.forward_m_s;
  frame[frame.size() - 1] = command.yaw_rad_s;
  if (is_first_) {
    for (Index column = 1; column < frames_.cols(); ++column) frames_.col(column) = frames_.col(0);
  }
  is_first_ = false;
}

void Senses::write(Eigen::Ref<VectorXd> out) const {
  const Index remembered = frames_.cols();
  for (std::size_t i = 0; i < from_.size(); ++i) {
    const Index column = (newest_ + remembered - from_[i].delay) % remembered;
    out[static_cast<Index>(i)] = frames_(from_[i].quantity, column);
  }
}

}  // namespace torquewright::hopper
