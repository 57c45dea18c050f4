// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <array>
#include <vector>

#include "simulation/contact/contact_impulses.hpp"
#include "simulation/contact/ground_profile.hpp"
#include "simulation/contact/moving_bodies.hpp"
#include "simulation/contact/obstacles.hpp"

namespace torquewright::simulation {

/// What bodies may meet: ground points, ends of joints' ranges, and the joints' own dry friction.
struct Obstacles {
  std::vector<GroundPoint> points;
  std::vector<JointStop> stops = {};
  std::vector<JointFriction> frictions = {};
  double ground_height_m = 0.0;
  /// The profile of the ground over that height. Its faces at the edges stop nothing: only what
  /// comes from above is met.
  GroundProfile profile = {};
  /// Time constant with which the ground gives under each point, as a critically damped spring of
  /// what the point feels of the bodies, that gives nothing back; 0: it is rigid.
  double time_constant_s = 0.0;
};

/// Rigid bodies over the ground, step by step: Moreau's midpoint scheme, in which velocities jump
/// and forces of contact are impulses of a step; without contact a Runge-Kutta step of fourth order
/// (docs/derivations/time_stepping.md). On rigid ground there is no penalty and no stiffness: its
/// one number is the step. Dry friction of joints is an impulse of the step too, and dampers act
/// implicitly; a tree that has either does not fly by Runge-Kutta steps. A step takes no memory but
/// where as many points, stops and frictions act together as never before.
class TimeStepping {
 public:
  enum class Outcome {
    kStepped,
    kUnreached,  ///< A mechanism does not reach the posture.
    kUnsolved,   ///< The contacts' laws could not be met.
    /// A number is not finite or above 1e10, or the mass matrix is not positive definite.
    kBlownUp,
  };

  /// Makes a stepper of `bodies`, which must outlive it.
  TimeStepping(MovingBodies& bodies, Obstacles obstacles);

  /// Moves position and velocity by one step while `force` (n x 1) acts. Unless the outcome is
  /// kStepped both stay as they are. std::invalid_argument on wrong sizes.
  [[nodiscard]] Outcome step(Eigen::VectorXd& position, Eigen::VectorXd& velocity,
                             const dynamics::VectorIn& force, double step_s);

  /// Forgets the last impulses, from which the next step would begin.
  void forget();

  /// Impulses of the last step (3 per point: x, y, z of the world), zero for open points.
  const Eigen::VectorXd& impulses_N_s() const { return impulses_N_s_; }
  /// Impulses of joints' stops in the last step (1 per stop, along its inward side): N s or N m s.
  const Eigen::VectorXd& stop_impulses() const { return stop_impulses_; }
  /// J^T impulses (n x 1): the mass matrix times the velocity's change by points and stops.
  const Eigen::VectorXd& generalised_impulse() const { return generalised_; }
  /// The part of generalised_impulse() that the first `points` points give (n x 1).
  void generalised_impulse_of(std::size_t points, dynamics::VectorOut out) const;
  /// The velocity's jump by the impulses (n x 1).
  const Eigen::VectorXd& jump() const { return jump_; }

 private:
  /// One stage of a Runge-Kutta step.
  struct Stage {
    Eigen::VectorXd step;  ///< Step that leads to the stage from the beginning.
    Eigen::VectorXd velocity;
    Eigen::VectorXd rate;  ///< Rate of the step: the velocity, but for a rotation whose axis turns.
    Eigen::VectorXd acceleration;
  };

  /// What acts on some number of points, stops and joints' friction together, three rows each. One
  /// for each number that there was, so that a number that comes again takes no memory.
  struct Met {
    Eigen::MatrixXd directions;  ///< J^T (n x 3 k)
    Eigen::MatrixXd answers;     ///< L^-1 J^T, where M = L L^T.
    ContactProblem problem;
    NewtonMemory newton;
    Eigen::VectorXd impulses;
  };

  Outcome fly(const dynamics::VectorIn& force, double step_s, bool& touches);
  void lead(const Stage& before, double duration_s, Stage& next);
  Outcome touch(const dynamics::VectorIn& force, double step_s);
  Outcome accelerations(const dynamics::VectorIn& force, double implicit_s, Eigen::VectorXd& out);
  Outcome place(const Eigen::VectorXd& position, const Eigen::VectorXd& velocity);
  void move(const Eigen::VectorXd& position, const Eigen::VectorXd& velocity, double duration_s,
            Eigen::VectorXd& out) const;
  void find_active();
  bool is_active() const { return !active_.empty() || !active_stops_.empty() || has_drag_; }
  /// Where the rows of the joints' friction begin, behind those of points and stops.
  Eigen::Index first_friction_row() const {
    return 3 * static_cast<Eigen::Index>(active_.size() + active_stops_.size());
  }
  Met& met() { return met_by_count_[count_]; }
  const Met& met() const { return met_by_count_[count_]; }
  void fill_friction_rows();
  void answer_by_friction(double step_s);
  void fill_rows();
  void respond();
  void soften(double step_s);
  bool solve_active(double step_s);
  void gather(double restitution_share, double step_s);
  double contact_work_J() const;
  void record_impulses();

  MovingBodies& bodies_;
  Obstacles obstacles_;
  bool gives_back_ = false;  ///< A point has restitution.
  bool has_drag_ = false;    ///< A joint has damping or dry friction.
  Eigen::VectorXd damping_;  ///< Damping by row of velocity.

  // Of the step under way.
  bool flew_ = false;  ///< The step before touched nothing.
  Eigen::VectorXd position_, velocity_;
  Eigen::VectorXd middle_;         ///< Position in the middle of the step.
  Eigen::VectorXd free_velocity_;  ///< Velocity after the step if there were nothing to meet.
  Eigen::VectorXd bias_, stiff_;
  Eigen::MatrixXd mass_;
  Eigen::LLT<Eigen::MatrixXd> factors_;
  std::array<Stage, 4> stages_;
  Eigen::VectorXd stage_position_, rate_, acceleration_;
  std::vector<std::size_t> active_;  ///< Points that touch; in rows they come first.
  std::vector<double> sunk_m_;       ///< How deep each of them is in the ground.
  /// Stops that act, behind the points: three rows each, of which the third is used.
  std::vector<std::size_t> active_stops_;
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian_;  ///< Jacobian of one point.
  std::vector<Met> met_by_count_;
  std::size_t count_ = 0;  ///< How many act now.
  Eigen::VectorXd impulses_N_s_, stop_impulses_, friction_impulses_, generalised_, jump_;
};

}  // namespace torquewright::simulation
