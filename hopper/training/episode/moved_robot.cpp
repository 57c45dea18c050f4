// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/episode/moved_robot.hpp"

#include <utility>

namespace torquewright::hopper {

using Eigen::Index;
using Eigen::VectorXd;

MovedRobot::MovedRobot(const Robot& moved, const EngineKind& engine, const EngineOptions& options,
                       PoweredDrives drives)
    : body_(moved), engine_(engine.make(moved, options)), drives_(std::move(drives)) {
  force_.setZero(moved.tree.velocity_size());
  const auto count = static_cast<Index>(body_.drive_count());
  for (VectorXd* of_drives : {&drive_rad_, &drive_rad_s_, &contact_Nm_s_}) {
    of_drives->setZero(count);
  }
}

bool MovedRobot::start(const VectorXd& position, const VectorXd& velocity) {
  engine_->start(position, velocity);
  drives_.start();
  contact_Nm_s_.setZero();
  return place();
}

bool MovedRobot::place() {
  if (!body_.set(engine_->position(), engine_->velocity())) return false;
  body_.drive_positions(drive_rad_);
  body_.speed_changes(engine_->velocity(), drive_rad_s_);
  return true;
}

bool MovedRobot::step(const VectorXd& wanted_Nm, double step_s) {
  made_ = &drives_.drive(wanted_Nm, drive_rad_, drive_rad_s_, step_s);
  force_.setZero();
  body_.add_drive_torques(made_->torque_Nm, force_);
  outcome_ = engine_->step(force_, step_s);
  if (outcome_ != EngineOutcome::kStepped) return false;
  body_.at_actuators(engine_->generalised_impulse(), contact_Nm_s_);
  return place();
}

std::string MovedRobot::why() const {
  switch (outcome_) {
    case EngineOutcome::kUnsolved:
      return "the engine found no impulses that obey the contacts' laws";
    case EngineOutcome::kBlownUp:
      return "the engine's numbers grew without bound";
    default:
      return "a mechanism does not reach the posture";
  }
}

}  // namespace torquewright::hopper
