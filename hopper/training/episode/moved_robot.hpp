// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "hopper/engines/engine_kind.hpp"
#include "hopper/replay/powered_drives.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

/// A robot that its drives move in an engine, one step of both at a time: what a step of a replay
/// does (run.cpp), without its record.
class MovedRobot {
 public:
  /// `moved` as the engine moves it: without_free_rotors(). It must outlive this.
  MovedRobot(const Robot& moved, const EngineKind& engine, const EngineOptions& options,
             PoweredDrives drives);

  /// Begins there. False where a mechanism does not reach.
  [[nodiscard]] bool start(const Eigen::VectorXd& position, const Eigen::VectorXd& velocity);
  /// A step in which these torques are wanted at the drives' outputs. False where nothing can go
  /// on: why() says what stopped.
  [[nodiscard]] bool step(const Eigen::VectorXd& wanted_Nm, double step_s);

  std::string why() const;

  WholeBody& body() { return body_; }
  const Engine& engine() const { return *engine_; }
  /// Of the last step: what the drives did, their torques at the joints (n x 1, per velocity), and
  /// J^T of the contacts' impulses at the drives' outputs.
  const DriveStep& made() const { return *made_; }
  const Eigen::VectorXd& force() const { return force_; }
  const Eigen::VectorXd& contact_Nm_s() const { return contact_Nm_s_; }

 private:
  bool place();

  WholeBody body_;
  std::unique_ptr<Engine> engine_;
  PoweredDrives drives_;
  EngineOutcome outcome_ = EngineOutcome::kStepped;
  const DriveStep* made_ = nullptr;
  Eigen::VectorXd force_, drive_rad_, drive_rad_s_, contact_Nm_s_;
};

}  // namespace torquewright::hopper
