// SPDX-License-Identifier: Apache-2.0
#include "tests/real_data/motions/walk_plant.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <stdexcept>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "tests/real_data/motions/walk_control.hpp"

namespace torquewright::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Joints' torques as forces per velocity.
VectorXd at_velocities(const VectorXd& torque_Nm) {
  VectorXd force = VectorXd::Zero(kWalkVelocities);
  force.tail(kWalkJoints) = torque_Nm;
  return force;
}

class HeldPlant final : public WalkPlant {
 public:
  HeldPlant(const hopper::Robot& robot, std::size_t stance, double landing_height_m)
      : feet_{robot.contacts.at(0).point, robot.contacts.at(1).point},
        stance_(stance),
        landing_height_m_(landing_height_m),
        tree_(robot.tree) {}

  std::optional<double> step(WalkState& state, const VectorXd& torque_Nm, double step_s,
                             bool may_land) override {
    const WalkState from = state;
    state = after(from, torque_Nm, step_s);
    if (!may_land || has_landed_ || height_m(state) >= landing_height_m_) return std::nullopt;
    double share = 0.0, width = 1.0;
    for (int halving = 0; halving < 40; ++halving) {
      width *= 0.5;
      if (height_m(after(from, torque_Nm, (share + width) * step_s)) >= landing_height_m_) {
        share += width;
      }
    }
    state = after(from, torque_Nm, share * step_s);
    land(state);
    state = after(state, torque_Nm, (1.0 - share) * step_s);
    return share;
  }

 private:
  VectorXd acceleration(const WalkState& state, const VectorXd& torque_Nm) {
    tree_.set(state.position, state.velocity);
    MatrixXd system = MatrixXd::Zero(9, 9);
    MatrixXd mass(kWalkVelocities, kWalkVelocities);
    dynamics::mass_matrix(tree_, mass);
    const MatrixXd rows = foot_rows(tree_, feet_[stance_]);
    system.topLeftCorner(7, 7) = mass;
    system.topRightCorner(7, 2) = -rows.transpose();
    system.bottomLeftCorner(2, 7) = rows;
    VectorXd bias(kWalkVelocities), right_side(9);
    dynamics::bias(tree_, bias);
    right_side << at_velocities(torque_Nm) - bias, -foot_bias_m_s2(tree_, feet_[stance_]);
    return system.partialPivLu().solve(right_side).head(kWalkVelocities);
  }

  WalkState after(const WalkState& from, const VectorXd& torque_Nm, double step_s) {
    const auto ahead = [&](const VectorXd& speed, const VectorXd& change, double s) -> WalkState {
      return {from.position + s * speed, from.velocity + s * change};
    };
    const VectorXd& v1 = from.velocity;
    const VectorXd a1 = acceleration(from, torque_Nm);
    const WalkState two = ahead(v1, a1, 0.5 * step_s);
    const VectorXd a2 = acceleration(two, torque_Nm);
    const WalkState three = ahead(two.velocity, a2, 0.5 * step_s);
    const VectorXd a3 = acceleration(three, torque_Nm);
    const WalkState four = ahead(three.velocity, a3, step_s);
    const VectorXd a4 = acceleration(four, torque_Nm);
    return ahead(v1 + 2.0 * two.velocity + 2.0 * three.velocity + four.velocity,
                 a1 + 2.0 * a2 + 2.0 * a3 + a4, step_s / 6.0);
  }

  double height_m(const WalkState& state) {
    tree_.set(state.position, state.velocity);
    return dynamics::point_position_m(tree_, feet_[1 - stance_]).z();
  }

  /// docs/derivations/impact.md, all contacts stick: v+ = v- - M^-1 J^T (J M^-1 J^T)^-1 J v-.
  void land(WalkState& state) {
    tree_.set(state.position, state.velocity);
    stance_ = 1 - stance_;
    has_landed_ = true;
    MatrixXd mass(kWalkVelocities, kWalkVelocities);
    dynamics::mass_matrix(tree_, mass);
    const MatrixXd rows = foot_rows(tree_, feet_[stance_]);
    const MatrixXd change = mass.llt().solve(rows.transpose());
    state.velocity -= change * (rows * change).inverse() * (rows * state.velocity);
  }

  std::array<dynamics::BodyPoint, 2> feet_;
  std::size_t stance_;
  double landing_height_m_;
  bool has_landed_ = false;
  dynamics::TreeState tree_;
};

class SteppingPlant final : public WalkPlant {
 public:
  SteppingPlant(const hopper::Robot& robot, std::size_t stance)
      : swing_(3 * static_cast<Eigen::Index>(1 - stance)),
        tree_(robot.tree),
        stepping_(tree_, {points_of(robot), {}}) {}

  std::optional<double> step(WalkState& state, const VectorXd& torque_Nm, double step_s,
                             bool may_land) override {
    const auto outcome =
        stepping_.step(state.position, state.velocity, at_velocities(torque_Nm), step_s);
    if (outcome != simulation::TimeStepping::Outcome::kStepped) {
      throw std::runtime_error("the walker's contacts were not solved");
    }
    if (!may_land || has_landed_ || stepping_.impulses_N_s()[swing_ + 2] <= 0.0)
      return std::nullopt;
    has_landed_ = true;
    return 1.0;
  }

 private:
  static std::vector<simulation::GroundPoint> points_of(const hopper::Robot& robot) {
    std::vector<simulation::GroundPoint> points;
    for (const hopper::ContactPoint& contact : robot.contacts) {
      points.push_back(
          {.point = contact.point, .friction_coefficient = contact.friction_coefficient});
    }
    return points;
  }

  Eigen::Index swing_;
  bool has_landed_ = false;
  simulation::BareTree tree_;
  simulation::TimeStepping stepping_;
};

}  // namespace

std::unique_ptr<WalkPlant> held_plant(const hopper::Robot& robot, std::size_t stance,
                                      double landing_height_m) {
  return std::make_unique<HeldPlant>(robot, stance, landing_height_m);
}

std::unique_ptr<WalkPlant> stepping_plant(const hopper::Robot& robot, std::size_t stance) {
  return std::make_unique<SteppingPlant>(robot, stance);
}

}  // namespace torquewright::test
