// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "dynamics/point.hpp"
#include "simulation/contact/contact_impulses.hpp"
#include "simulation/contact/moving_bodies.hpp"

namespace torquewright::simulation {

/// Where the bodies may touch the ground, which is the plane z = height.
struct GroundPoint {
  dynamics::BodyPoint point;
  double friction_coefficient = 0.0;
  /// Of the normal velocity (Newton's, as Moreau's stepping has it). Where it would add energy, as
  /// it can with friction, less of it is taken.
  double restitution = 0.0;
};

/// Rigid bodies over rigid ground, step by step: Moreau's midpoint scheme, in which velocities jump
/// and forces of contact are impulses of a step; without contact a Runge-Kutta step of fourth order
/// (docs/derivations/time_stepping.md). No penalty, no stiffness: its one number is the step.
class TimeStepping {
 public:
  enum class Outcome {
    kStepped,
    kUnreached,  ///< A mechanism does not reach the posture.
    kUnsolved,   ///< The contacts' laws could not be met.
    kBlownUp,    ///< A number is not finite, or the mass matrix not positive definite.
  };

  /// `bodies` must outlive it.
  TimeStepping(MovingBodies& bodies, std::vector<GroundPoint> points, double ground_height_m = 0.0);

  /// From position and velocity to those a step later, while `force` (n x 1) acts. Unless it is
  /// kStepped, both stay as they are. std::invalid_argument on wrong sizes.
  [[nodiscard]] Outcome step(Eigen::VectorXd& position, Eigen::VectorXd& velocity,
                             const dynamics::VectorIn& force, double step_s);

  /// Of the last step (3 per point: x, y, z of the world): zero where a point was open.
  const Eigen::VectorXd& impulses_N_s() const { return impulses_N_s_; }
  /// The contacts' part of the velocity's change, times the mass matrix: J^T impulses (n x 1).
  const Eigen::VectorXd& generalised_impulse() const { return generalised_; }
  /// The velocity's jump by the contacts' impulses (n x 1).
  const Eigen::VectorXd& jump() const { return jump_; }

 private:
  Outcome fly(const dynamics::VectorIn& force, double step_s);
  Outcome touch(const dynamics::VectorIn& force, double step_s);
  bool accelerations(const dynamics::VectorIn& position, const dynamics::VectorIn& velocity,
                     const dynamics::VectorIn& force, Eigen::VectorXd& out, Outcome& trouble);
  void find_active();
  bool solve_active();
  void gather(double restitution_share);
  double contact_work_J() const;

  MovingBodies& bodies_;
  std::vector<GroundPoint> points_;
  double ground_height_m_;

  // Of the step under way.
  Eigen::VectorXd position_, velocity_;
  Eigen::VectorXd middle_;         ///< Position in the middle of the step.
  Eigen::VectorXd free_velocity_;  ///< After the step, were there no ground.
  Eigen::VectorXd bias_;
  Eigen::MatrixXd mass_;
  Eigen::LLT<Eigen::MatrixXd> factors_;
  std::vector<std::size_t> active_;
  Eigen::MatrixXd jacobian_;         ///< (3 k x n), of the active points.
  Eigen::MatrixXd jacobian_answer_;  ///< M^-1 J^T.
  ContactProblem problem_;
  Eigen::VectorXd active_impulses_;
  Eigen::VectorXd impulses_N_s_, generalised_, jump_;
};

}  // namespace torquewright::simulation
