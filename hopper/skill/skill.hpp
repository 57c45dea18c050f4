// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "hopper/policy/policy_document.hpp"
#include "hopper/skill/phase_times.hpp"
#include "hopper/skill/senses.hpp"
#include "hopper/skill/target_law.hpp"

namespace torquewright::hopper {

/// How a policy is joined to a robot: what it sees, and what its actions do. Vectors by joint are
/// of the bodies after the base.
struct Skill {
  std::string file;  ///< For messages.
  std::vector<PolicyInput> inputs;
  std::vector<PolicyOutput> outputs;
  std::vector<Eigen::Index> acted;  ///< By output, the joint whose target it is.
  TargetGains gains;
  Eigen::VectorXd hold_rad;  ///< Targets before the first action, and of joints without one.
  PhaseTimes phase;
  double control_period_s = 0.01;
};

/// Returns the joint (of the bodies after the base) whose target each output is, by its name:
/// JOINT_target_rad. io::SpecError, with the nearest, where the robot has no such joint.
std::vector<Eigen::Index> joints_of_outputs(const Robot& robot,
                                            const std::vector<PolicyOutput>& outputs,
                                            const std::string& file);

/// A skill while it is used: the same in training and in a replay. Robot and skill must outlive it.
class ActingSkill {
 public:
  ActingSkill(const Robot& robot, const Skill& skill);

  void start(const Command& command);
  /// Notes what is seen when an action is due, `time_s` after the begin.
  void see(double time_s, const Observation& seen);
  void write(Eigen::Ref<Eigen::VectorXd> inputs) const { senses_.write(inputs); }
  /// Sets the targets by an action (outputs x 1). They may lie beyond a joint's range: a PD law
  /// gives a torque there only for a target far off, and what a drive has no torque for is cut off.
  void act(const Eigen::Ref<const Eigen::VectorXd>& action);
  /// Torques at the drives' outputs that the targets ask for now.
  void torque(const Observation& seen, Eigen::VectorXd& drive_Nm) const;

 private:
  const Skill& skill_;
  Senses senses_;
  TargetLaw law_;
  Command command_;
  Eigen::VectorXd target_rad_;
  long period_ = 0;  ///< Control periods since the begin, when it last saw.
};

}  // namespace torquewright::hopper
