// SPDX-License-Identifier: Apache-2.0
// Oracle: MuJoCo on the same tree, told the base's own motion: where the sole's rear point, the
// foot and the centre of mass are, how they move and accelerate, and the forces that this takes.
#include <gtest/gtest.h>

#include <cmath>

#include "hopper/planning/plane/sagittal_dynamics.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/dynamics/tree_mjcf.hpp"
#include "tests/hopper/planning/sagittal_states.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::difference;

// Hundreds of roundings of forces that are themselves divided by the largest.
constexpr double kAlike = 1e-11;

/// x, z and pitch of something, with rates and second rates.
struct FrameMotion {
  Vector3d position, velocity, acceleration;
};

class MujocoPlane {
 public:
  explicit MujocoPlane(const SagittalRobot& plane)
      : plane_(plane), mujoco_(test::mjcf_of(plane.robot.tree)) {}

  void set(const TreeMotion& motion) {
    mujoco_.set(motion.position, motion.velocity);
    force_ = mujoco_.inverse_dynamics(motion.acceleration);
    mj_rnePostConstraint(&mujoco_.model(), &mujoco_.data());
    base_rad_ = motion.position[2];
    base_rad_s_ = motion.velocity[2];
    base_rad_s2_ = motion.acceleration[2];
  }
  Vector3d place_m(const dynamics::BodyPoint& point) {
    return Eigen::Map<const Vector3d>(mujoco_.data().xpos + 3 * body(point)) + arm_m(point);
  }
  Vector3d velocity_m_s(const dynamics::BodyPoint& point) {
    mjtNum both[6];
    mj_objectVelocity(&mujoco_.model(), &mujoco_.data(), mjOBJ_XBODY, body(point), both, 0);
    const Eigen::Map<const Vector3d> turning(both), moving(both + 3);
    return moving + turning.cross(arm_m(point));
  }
  Vector3d acceleration_m_s2(const dynamics::BodyPoint& point) {
    mjtNum rates[6], both[6];
    mj_objectVelocity(&mujoco_.model(), &mujoco_.data(), mjOBJ_XBODY, body(point), rates, 0);
    mj_objectAcceleration(&mujoco_.model(), &mujoco_.data(), mjOBJ_XBODY, body(point), both, 0);
    const Eigen::Map<const Vector3d> rate(rates), turning(both), moving(both + 3);
    const Vector3d arm = arm_m(point);
    // MuJoCo's world accelerates upwards instead of weighing.
    return moving - Vector3d(0, 0, plane_.robot.tree.gravity_m_s2) + turning.cross(arm) +
           rate.cross(rate.cross(arm));
  }
  FrameMotion sole() {
    const dynamics::BodyPoint& rear = plane_.sole.front().point;
    const Vector3d at = place_m(rear), v = velocity_m_s(rear), a = acceleration_m_s2(rear);
    mjtNum rates[6], both[6];
    mj_objectVelocity(&mujoco_.model(), &mujoco_.data(), mjOBJ_XBODY, body(rear), rates, 0);
    mj_objectAcceleration(&mujoco_.model(), &mujoco_.data(), mjOBJ_XBODY, body(rear), both, 0);
    const mjtNum* R = mujoco_.data().xmat + 9 * body(rear);
    return {{at.x(), at.z(), std::atan2(R[2], R[0])},
            {v.x(), v.z(), rates[1]},
            {a.x(), a.z(), both[1]}};
  }
  FrameMotion mass() {
    const Eigen::Map<const Vector3d> at(mujoco_.data().subtree_com + 3);
    const Eigen::Map<const Vector3d> v(mujoco_.data().subtree_linvel + 3);
    const double kg = mujoco_.model().body_subtreemass[1];
    return {{at.x(), at.z(), base_rad_},
            {v.x(), v.z(), base_rad_s_},
            {force_[0] / kg, force_[1] / kg - plane_.robot.tree.gravity_m_s2, base_rad_s2_}};
  }
  /// Per row of the tree, of a force on a point.
  VectorXd felt(const dynamics::BodyPoint& point, const Vector3d& force_N) {
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> jacobian(3, mujoco_.nv());
    const Vector3d at = place_m(point);
    mj_jac(&mujoco_.model(), &mujoco_.data(), jacobian.data(), nullptr, at.data(), body(point));
    return jacobian.transpose() * force_N;
  }
  const VectorXd& force() const { return force_; }
  double angular_momentum_Nm_s() { return mujoco_.angular_momentum_Nm_s().y(); }

 private:
  static int body(const dynamics::BodyPoint& point) { return static_cast<int>(point.body) + 1; }
  Vector3d arm_m(const dynamics::BodyPoint& point) {
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    return Eigen::Map<const RowMajor>(mujoco_.data().xmat + 9 * body(point)) * point.p_B_m;
  }

  const SagittalRobot& plane_;
  test::MujocoEngine mujoco_;
  VectorXd force_;
  double base_rad_ = 0, base_rad_s_ = 0, base_rad_s2_ = 0;
};

/// 0 in difference of angles that are a whole turn apart.
double apart_rad(double a, double b) { return std::remainder(a - b, 2.0 * M_PI); }

class PlaneBesideMujoco : public testing::TestWithParam<const char*> {
 protected:
  static Robot robot() {
    return std::string(GetParam()) == "leg_with_tail" ? test::leg_with_tail()
                                                      : test::documented_robot(GetParam());
  }
  SagittalRobot plane = sagittal(robot());
  MujocoPlane mujoco{plane};
  oracles::Dice dice{11};
};

TEST_P(PlaneBesideMujoco, FramesMoveAlike) {
  for (int sample = 0; sample < 20; ++sample) {
    const TreeMotion tree = test::random_motion(dice, plane);
    mujoco.set(tree);
    for (const PlanFrame frame : {PlanFrame::kSole, PlanFrame::kMass}) {
      const FrameMotion theirs = frame == PlanFrame::kSole ? mujoco.sole() : mujoco.mass();
      const TreeMotion ours = frame_motion(plane, frame, tree);
      EXPECT_LT((ours.position.head<2>() - theirs.position.head<2>()).norm(), 1e-12);
      EXPECT_LT(std::abs(apart_rad(ours.position[2], theirs.position[2])), 1e-12);
      EXPECT_LT(difference(ours.velocity.head<3>(), theirs.velocity), kAlike);
      EXPECT_LT(difference(ours.acceleration.head<3>(), theirs.acceleration), kAlike);
      const TreeMotion back = tree_motion(plane, frame, ours);
      EXPECT_LT(difference(back.position, tree.position), 1e-13);
      EXPECT_LT(difference(back.velocity, tree.velocity), 1e-13);
      EXPECT_LT(difference(back.acceleration, tree.acceleration), 1e-12);
    }
  }
}

TEST_P(PlaneBesideMujoco, DynamicsTakeTheSameForces) {
  SagittalDynamicsOf<double> dynamics(plane);
  for (int sample = 0; sample < 20; ++sample) {
    const TreeMotion tree = test::random_motion(dice, plane);
    mujoco.set(tree);
    const auto drives = static_cast<Index>(plane.drive_count());
    const VectorXd drive_Nm = test::uniform_vector(dice, drives, 20);
    std::vector<SoleForceOf<double>> forces;
    VectorXd theirs = mujoco.force();
    for (std::size_t i = 0; i < plane.sole.size(); ++i) {
      forces.push_back({i, test::uniform(dice, -50, 50), test::uniform(dice, 0, 90)});
      theirs -= mujoco.felt(plane.sole[i].point, {forces[i].x, 0.0, forces[i].z});
    }
    // Direct drives, each of one joint.
    for (Index i = 0; i < drives; ++i) {
      const Drivetrain& drivetrain = plane.robot.drivetrains[static_cast<std::size_t>(i)];
      theirs[2 + static_cast<Index>(drivetrain.joints[0])] -= drive_Nm[i];
    }
    VectorXd picked(theirs.size());
    picked << test::moving_of(plane, theirs), theirs(plane.held);
    for (const PlanFrame frame : {PlanFrame::kSole, PlanFrame::kMass}) {
      const TreeMotion rows = frame_motion(plane, frame, tree);
      dynamics.set(frame, test::moving_of(plane, rows.position),
                   test::moving_of(plane, rows.velocity));
      const VectorXd ours =
          dynamics.residual(test::moving_of(plane, rows.acceleration), drive_Nm, forces);
      EXPECT_LT(difference(ours, picked), kAlike);
    }
  }
}

TEST_P(PlaneBesideMujoco, PointsMoveAlike) {
  SagittalDynamicsOf<double> dynamics(plane);
  const dynamics::BodyPoint points[] = {
      plane.sole.back().point, {1, {0.05, 0.0, -0.1}}, {0, {0.1, 0.0, 0.2}}};
  for (int sample = 0; sample < 20; ++sample) {
    const TreeMotion tree = test::random_motion(dice, plane);
    mujoco.set(tree);
    for (const PlanFrame frame : {PlanFrame::kSole, PlanFrame::kMass}) {
      const TreeMotion rows = frame_motion(plane, frame, tree);
      dynamics.set(frame, test::moving_of(plane, rows.position),
                   test::moving_of(plane, rows.velocity));
      for (const dynamics::BodyPoint& point : points) {
        const Vector3d at = mujoco.place_m(point), v = mujoco.velocity_m_s(point),
                       a = mujoco.acceleration_m_s2(point);
        EXPECT_LT(difference(dynamics.place_m(point), Vector2d(at.x(), at.z())), kAlike);
        EXPECT_LT(difference(dynamics.velocity_m_s(point), Vector2d(v.x(), v.z())), kAlike);
        EXPECT_LT(
            difference(dynamics.acceleration_m_s2(point, test::moving_of(plane, rows.acceleration)),
                       Vector2d(a.x(), a.z())),
            kAlike);
      }
    }
  }
}

/// Without contact the residual asks that the centre of mass falls and that CAM stands: CAM at
/// t +- h on the parabola of an instant that obeys it changes by its h^3 part alone.
TEST_P(PlaneBesideMujoco, FlightKeepsAngularMomentum) {
  SagittalDynamicsOf<double> dynamics(plane);
  const Index m = plane.moving_count();
  constexpr double kStep_s = 1e-4;
  for (int sample = 0; sample < 10; ++sample) {
    const TreeMotion tree = test::random_motion(dice, plane);
    TreeMotion rows = frame_motion(plane, PlanFrame::kMass, tree);
    const VectorXd drive_Nm =
        test::uniform_vector(dice, static_cast<Index>(plane.drive_count()), 5);
    dynamics.set(PlanFrame::kMass, test::moving_of(plane, rows.position),
                 test::moving_of(plane, rows.velocity));
    const VectorXd rest = dynamics.residual(VectorXd::Zero(m), drive_Nm, {}).head(m);
    Eigen::MatrixXd mass(m, m);
    for (Index i = 0; i < m; ++i) {
      mass.col(i) = dynamics.residual(VectorXd::Unit(m, i), drive_Nm, {}).head(m) - rest;
    }
    const VectorXd acceleration = mass.partialPivLu().solve(-rest);
    EXPECT_NEAR(acceleration[0], 0.0, 1e-9);
    EXPECT_NEAR(acceleration[1], -plane.robot.tree.gravity_m_s2, 1e-9);
    rows.acceleration = plane.all_rows(acceleration);
    const TreeMotion falling = tree_motion(plane, PlanFrame::kMass, rows);
    const auto momentum_after = [&](double h) {
      mujoco.set({falling.position + h * falling.velocity + 0.5 * h * h * falling.acceleration,
                  falling.velocity + h * falling.acceleration, falling.acceleration});
      return mujoco.angular_momentum_Nm_s();
    };
    // Its rate; without the law it would be of the torques' size, 1 Nm and more. What is left is
    // h^2 of the parabola's third derivative of CAM, and rounding over h.
    EXPECT_NEAR((momentum_after(kStep_s) - momentum_after(-kStep_s)) / (2.0 * kStep_s), 0.0, 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(, PlaneBesideMujoco, testing::Values("planar_leg", "leg_with_tail"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace torquewright::hopper
