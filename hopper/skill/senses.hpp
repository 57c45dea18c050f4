// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "hopper/policy/policy_document.hpp"
#include "hopper/skill/phase_times.hpp"
#include "hopper/tracking/controller.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// What a policy is asked for while it acts.
struct Command {
  double forward_m_s = 0.0;  ///< Velocity of the base along the world's x.
  double yaw_rad_s = 0.0;    ///< About the world's z.
};

/// Quantities of a robot that a policy may see, by name: gravity_x, gravity_y, gravity_z (its
/// direction in the base's axes, 1), base_pitch_sin, base_pitch_cos, base_pitch_rad (about +y,
/// within half a turn), base_rate_x_rad_s and so on in the base's axes, base_pitch_rate_rad_s (the
/// same as about y), of every joint JOINT_rad, JOINT_rad_s, JOINT_target_rad (the target that held
/// when it was seen) and JOINT_error_rad (target less position), phase_sin, phase_cos,
/// phase_flight, phase_landing (1 then, else 0), command_forward_m_s, command_yaw_rad_s.
std::vector<PolicyInput> every_sense(const Robot& robot);

/// What a policy sees, control step by control step, with its past. Before the first step it was
/// as in the first. The robot must outlive it.
class Senses {
 public:
  /// io::SpecError, with the nearest name, where an input is none of every_sense() or has another
  /// unit. `file` is what the message names.
  Senses(const Robot& robot, const std::vector<PolicyInput>& inputs, const PhaseTimes& phase,
         const std::string& file);

  void start();
  /// Notes a control step: what was seen `time_s` after the begin, while these targets held (joints
  /// x 1, of the bodies after the base).
  void note(double time_s, const Observation& seen, const Eigen::VectorXd& target_rad,
            const Command& command);
  /// Writes the inputs (inputs x 1). Requires a noted step.
  void write(Eigen::Ref<Eigen::VectorXd> out) const;
  Eigen::Index size() const { return static_cast<Eigen::Index>(from_.size()); }

 private:
  struct From {
    Eigen::Index quantity;
    int delay;
  };

  void note_base(const Observation& seen, Eigen::Ref<Eigen::VectorXd> frame) const;
  void note_phase(double time_s, Eigen::Ref<Eigen::VectorXd> frame) const;

  const Robot& robot_;
  PhaseTimes phase_;
  std::vector<From> from_;
  Eigen::MatrixXd frames_;  ///< (quantities x remembered), the newest at newest_.
  Eigen::Index newest_ = 0;
  bool is_first_ = true;
};

}  // namespace torquewright::hopper
