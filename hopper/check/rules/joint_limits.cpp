// SPDX-License-Identifier: Apache-2.0
// Ranges, speeds and torques that the robot's document states of its joints.
#include <fmt/format.h>

#include <cmath>

#include "hopper/check/rules/every_rule.hpp"
#include "hopper/demand/drive_reports.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kLimitRoundOff = 1e-9;  // relative to the limit, or to 1

struct Words {
  const char* rule;
  const char* what;
  const char* unit;
};

/// The sample that lies furthest beyond a limit, if any does.
struct Beyond {
  double excess = 0.0;
  double value = 0.0;
  double limit = 0.0;
  double time_s = 0.0;
  Index samples = 0;

  void note(double value_now, double limit_now, double excess_now, double time_now_s) {
    if (!(excess_now > kLimitRoundOff * std::max(1.0, std::abs(limit_now)))) return;
    ++samples;
    if (excess_now <= excess) return;
    *this = {excess_now, value_now, limit_now, time_now_s, samples};
  }
};

void add(const std::string& joint, const Words& words, const Beyond& beyond, Index all,
         std::vector<Finding>& findings) {
  if (beyond.samples == 0) return;
  findings.push_back(
      {actuator::Severity::kViolation, words.rule, joint, beyond.time_s, beyond.value, beyond.limit,
       words.unit,
       fmt::format("{}: {} of {:.6g} {} at t = {} s, limit {:.6g} {} ({} of {} samples beyond)",
                   joint, words.what, beyond.value, words.unit, io::time_text(beyond.time_s),
                   beyond.limit, words.unit, beyond.samples, all)});
}

/// Those of the dynamics have the rotors' torque, which is a joint's too.
bool counts_file(const CheckedMotion& checked) {
  if (checked.options.torques == TorqueSource::kDynamics) return false;
  return !drive_torques(checked).adds_rotors;
}

}  // namespace

std::vector<Finding> joint_limits(const CheckedMotion& checked) {
  std::vector<Finding> findings;
  const bool trusts_file = !checked.demand.has_dynamics || counts_file(checked);
  const Motion& motion = checked.motion;
  const Index joints = static_cast<Index>(checked.robot.tree.bodies.size()) - 1;
  for (Index i = 0; i < joints; ++i) {
    const dynamics::Joint& joint = checked.robot.tree.bodies[static_cast<std::size_t>(i) + 1].joint;
    const bool turns = joint.kind == dynamics::JointKind::kRevolute;
    const auto positions = motion.positions.row(motion.positions.rows() - joints + i);
    const auto speeds = motion.velocities.row(motion.velocities.rows() - joints + i);
    Beyond position;
    Beyond speed;
    Beyond effort;
    for (Index sample = 0; sample < motion.samples(); ++sample) {
      const double time_s = motion.time_s(sample);
      const double at = positions[sample];
      position.note(at, joint.limits.position_min, joint.limits.position_min - at, time_s);
      position.note(at, joint.limits.position_max, at - joint.limits.position_max, time_s);
      const double rate = speeds[sample];
      speed.note(rate, joint.limits.speed_max, std::abs(rate) - joint.limits.speed_max, time_s);
      const bool is_of_file = motion.has_effort[static_cast<std::size_t>(i)] && trusts_file;
      if (!is_of_file && !checked.demand.has_dynamics) continue;
      const double torque =
          is_of_file ? motion.efforts(i, sample) : checked.demand.joint_effort(i, sample);
      effort.note(torque, joint.limits.effort_max, std::abs(torque) - joint.limits.effort_max,
                  time_s);
    }
    add(joint.name, {"joint-range", "position", turns ? "rad" : "m"}, position, motion.samples(),
        findings);
    add(joint.name, {"joint-speed", "speed", turns ? "rad/s" : "m/s"}, speed, motion.samples(),
        findings);
    add(joint.name, {"joint-torque", turns ? "torque" : "force", turns ? "Nm" : "N"}, effort,
        motion.samples(), findings);
  }
  return findings;
}

}  // namespace torquewright::hopper
