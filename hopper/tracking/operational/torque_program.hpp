// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "hopper/tracking/contact_rows.hpp"
#include "hopper/tracking/operational/task_rows.hpp"
#include "optimization/quadratic/solver.hpp"

namespace torquewright::hopper {

/// Bounds of the drives' torques (drives x 1 each).
struct TorqueBounds {
  Eigen::VectorXd least_Nm, greatest_Nm;
};

/// The quadratic program of one look: torques of the drives, forces of the contacts and of springs
/// that count as rigid, so that the weighted residuals of tasks and contacts are least while the
/// robot moves as its dynamics say, each drive stays in its bounds and each force in its cone.
/// docs/derivations/operational_space.md eqs. (4)-(8).
class TorqueProgram {
 public:
  /// Robot and tasks must outlive it.
  TorqueProgram(const Robot& robot, const OperationalTasks& tasks);

  /// Begins anew: forgets which bounds were active.
  void start() { solver_.forget(); }

  /// `wanted` (k x 1): accelerations wanted of the rows. The status says whether there is an
  /// answer.
  optimization::QuadraticStatus solve(TaskFrame& frame, const TaskRows& rows,
                                      const Eigen::VectorXd& wanted, const TouchingPoints& touches,
                                      const TorqueBounds& bounds);

  const optimization::QuadraticProgram& program() const { return program_; }
  const optimization::QuadraticSolution& solution() const { return *solution_; }
  const Eigen::VectorXd& torque_Nm() const { return torque_Nm_; }        ///< (drives x 1)
  const Eigen::VectorXd& contact_N() const { return contact_N_; }        ///< (3 points x 1)
  const Eigen::VectorXd& acceleration() const { return acceleration_; }  ///< (n x 1)

 private:
  void move(TaskFrame& frame);
  void price(TaskFrame& frame, const TaskRows& rows, const Eigen::VectorXd& wanted);
  void bound(const TouchingPoints& touches, const TorqueBounds& bounds);
  void add_square(const Eigen::MatrixXd& rows, const Eigen::VectorXd& off,
                  const Eigen::VectorXd& weight);

  const Robot& robot_;
  const OperationalTasks& tasks_;
  Eigen::VectorXd peaks_Nm_;
  double weight_N_ = 0.0;
  Eigen::LLT<Eigen::MatrixXd> mass_;
  Eigen::MatrixXd effect_;  ///< (n x unknowns): accelerations by them,
  Eigen::VectorXd free_;    ///< (n x 1): and without them.
  Eigen::VectorXd scales_;  ///< (unknowns x 1): Nm, N; unknowns are shares of them.
  optimization::QuadraticProgram program_;
  optimization::QuadraticSolver solver_;
  const optimization::QuadraticSolution* solution_ = nullptr;
  Eigen::VectorXd torque_Nm_, contact_N_, acceleration_;
};

}  // namespace torquewright::hopper
