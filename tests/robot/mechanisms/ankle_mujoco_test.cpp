// SPDX-License-Identifier: Apache-2.0
// Oracle: MuJoCo on the example with cranks and rods as bodies of their own, loops closed by
// equality constraints. Its mass matrix M, bias h and constraint Jacobian G stay its own. Forces at
// the independent velocities are N^T (M a + h), with N from G alone, so that the softness of its
// constraints plays no part. They are linear in the masses of cranks and rods, which ours weigh
// nothing: those at no mass are twice those at m less those at 2 m, exactly.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>

#include "actuator/region/torque_at.hpp"
#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/dynamics/random_tree.hpp"
#include "tests/dynamics/tree_mjcf.hpp"
#include "tests/robot/mechanisms/ankles.hpp"
#include "tests/robot/mechanisms/derivatives.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr Eigen::Index kOwn = 9;    // base, knee, pitch, roll: what ours has too
constexpr Eigen::Index kLoops = 6;  // per rod: crank, two hinges; and three rows of a connect
constexpr double kExact = 1e-9;

Robot example() { return read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot; }

/// As in the example's document, said a second time: actuators' centres, half distance, rods.
struct RodPlace {
  Vector3d actuator_m;
  double half_m;
  double length_m;
};
const std::array<RodPlace, 2> kPlaces{
    {{{0.01, 0.04, -0.24}, 0.04, 0.17}, {{0.01, -0.04, -0.12}, -0.04, 0.29}}};
constexpr double kCrank_m = 0.06;
constexpr double kLever_m = 0.05;

dynamics::Body part(const std::string& name, std::size_t parent, const Vector3d& place_m,
                    const Vector3d& axis, double mass_kg) {
  dynamics::Body body;
  body.name = name;
  body.parent = parent;
  body.joint.p_PB_m = place_m;
  body.joint.axis = axis;
  body.inertia.mass_kg = mass_kg;
  body.inertia.center_of_mass_m = {0.01, 0.02, -0.03};
  body.inertia.inertia_kg_m2 = mass_kg * 1e-3 * Eigen::Matrix3d::Identity();
  return body;
}

/// The robot's tree with both legs of its loops: rods hang on cranks by two hinges.
test::MujocoEngine looped(const Robot& robot, double part_kg, const std::string& softness) {
  dynamics::Tree tree = robot.tree;
  std::string closing = "<equality>";
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string number = std::to_string(i);
    const std::size_t first = tree.bodies.size();
    dynamics::Body crank =
        part("crank_" + number, 1, kPlaces[i].actuator_m, Vector3d::UnitY(), part_kg);
    crank.joint.reflected_inertia =
        actuator::reflected_inertia_kg_m2(robot.drivetrains[1].actuators[i]);
    tree.bodies.push_back(crank);
    tree.bodies.push_back(
        part("fork_" + number, first, {-kCrank_m, 0, 0}, Vector3d::UnitY(), part_kg));
    tree.bodies.push_back(
        part("rod_" + number, first + 1, Vector3d::Zero(), Vector3d::UnitX(), part_kg));
    closing += "<connect body1=\"rod_" + number + "\" body2=\"foot\" anchor=\"0 0 -" +
               std::to_string(kPlaces[i].length_m) + "\" " + softness + "/>";
  }
  std::string text = test::mjcf_of(tree);
  return test::MujocoEngine(
      text.replace(text.find("</mujoco>"), 9, closing + "</equality></mujoco>"));
}

/// Turns of crank and hinges where the actuators stand so: by the geometry of the document.
VectorXd loop_angles(const SmallVector& joint_rad, const SmallVector& actuator_rad) {
  VectorXd angles(kLoops);
  const Eigen::Matrix3d foot = (Eigen::AngleAxisd(joint_rad[0], Vector3d::UnitY()) *
                                Eigen::AngleAxisd(joint_rad[1], Vector3d::UnitX()))
                                   .toRotationMatrix();
  for (std::size_t i = 0; i < 2; ++i) {
    const double turn = actuator_rad[static_cast<Eigen::Index>(i)];
    const Eigen::AngleAxisd crank(turn, Vector3d::UnitY());
    const Vector3d pin = Vector3d(0, 0, -0.41) + foot * Vector3d(-kLever_m, kPlaces[i].half_m, 0);
    const Vector3d end = kPlaces[i].actuator_m + crank * Vector3d(-kCrank_m, 0, 0);
    const Vector3d rod = crank.inverse() * (pin - end).normalized();
    // The rod at (0, 0, -1) turned about x, then about y.
    angles.segment<3>(3 * static_cast<Eigen::Index>(i)) =
        Vector3d(turn, std::atan2(-rod.x(), -rod.z()), std::asin(rod.y()));
  }
  return angles;
}

struct Loops {
  MatrixXd jacobian;  ///< G.
  VectorXd gap_m;
};

Loops loops_at(test::MujocoEngine& mujoco, const VectorXd& q, const VectorXd& v) {
  mujoco.set(q, v);
  const mjData& data = mujoco.data();
  if (data.nefc != kLoops) throw std::runtime_error("other constraints than the loops' are active");
  return {Eigen::Map<const RowMajor>(data.efc_J, kLoops, mujoco.nv()),
          Eigen::Map<const VectorXd>(data.efc_pos, kLoops)};
}

/// What MuJoCo says of one state of ours.
struct Theirs {
  VectorXd gap_m;
  VectorXd loop_speed;  ///< Of cranks and hinges.
  VectorXd loop_acceleration;
  VectorXd force;  ///< At our velocities.
};

Theirs ask(test::MujocoEngine& mujoco, const VectorXd& q, const VectorXd& own_v,
           const VectorXd& own_a) {
  Theirs theirs;
  VectorXd v = VectorXd::Zero(mujoco.nv());
  v.head(kOwn) = own_v;
  const Loops loops = loops_at(mujoco, q, v);
  theirs.gap_m = loops.gap_m;
  const auto solver = loops.jacobian.rightCols(kLoops).partialPivLu();
  MatrixXd N = MatrixXd::Identity(mujoco.nv(), kOwn);
  N.bottomRows(kLoops) = -solver.solve(loops.jacobian.leftCols(kOwn));
  v = N * own_v;
  theirs.loop_speed = v.tail(kLoops);
  // G' v by differences of their G along their own way of moving on.
  const VectorXd drift = test::slope([&](double step) -> VectorXd {
    VectorXd moved = q;
    mj_integratePos(&mujoco.model(), moved.data(), v.data(), step);
    return loops_at(mujoco, moved, v).jacobian * v;
  });
  VectorXd a = N * own_a;
  a.tail(kLoops) -= solver.solve(drift);
  theirs.loop_acceleration = a.tail(kLoops);
  mujoco.set(q, v);
  theirs.force = N.transpose() * (mujoco.mass_matrix() * a + mujoco.bias());
  return theirs;
}

/// One state within the joints' ranges, and what ours says of it.
struct State {
  State(oracles::Dice& dice, const Robot& robot, double speed) {
    q = test::random_position(dice, robot.tree);
    q.segment<4>(3).normalize();
    for (Eigen::Index i = 0; i < 3; ++i) {
      const auto& limits = robot.tree.bodies[static_cast<std::size_t>(i) + 1].joint.limits;
      q[7 + i] = test::uniform(dice, limits.position_min, limits.position_max);
    }
    v = test::uniform_vector(dice, kOwn, speed);
    a = test::uniform_vector(dice, kOwn, 80);
    at = robot.drivetrains[1].mechanism->transfer(q.tail<2>(), v.tail<2>()).value();
    whole.resize(q.size() + kLoops);
    whole << q, loop_angles(q.tail<2>(), at.actuator_position_rad);
  }
  VectorXd q, v, a;
  VectorXd whole;  ///< With cranks and hinges.
  Transfer at;
};

SmallVector armatures(const Robot& robot) {
  const auto& actuators = robot.drivetrains[1].actuators;
  return test::pair_of(actuator::reflected_inertia_kg_m2(actuators[0]),
                       actuator::reflected_inertia_kg_m2(actuators[1]));
}

TEST(AnkleBesideMujoco, HasTheSameMotionAndForces) {
  const Robot robot = example();
  test::MujocoEngine light = looped(robot, 0.05, ""), heavy = looped(robot, 0.1, "");
  dynamics::TreeState state(robot.tree);
  oracles::Dice dice(17);
  double gap = 0, speed = 0, acceleration = 0, force = 0;
  constexpr int kStates = 1000;
  for (int i = 0; i < kStates; ++i) {
    const State drawn(dice, robot, 8);
    const Theirs one = ask(light, drawn.whole, drawn.v, drawn.a);
    const Theirs two = ask(heavy, drawn.whole, drawn.v, drawn.a);
    gap = std::max(gap, one.gap_m.cwiseAbs().maxCoeff());
    const SmallVector joint_v = drawn.v.tail<2>(), joint_a = drawn.a.tail<2>();
    const VectorXd crank_v = drawn.at.jacobian * joint_v;
    const VectorXd crank_a = drawn.at.jacobian * joint_a + drawn.at.jacobian_rate_1_s * joint_v;
    const Eigen::Vector2d their_v(one.loop_speed[0], one.loop_speed[3]);
    const Eigen::Vector2d their_a(one.loop_acceleration[0], one.loop_acceleration[3]);
    speed = std::max(speed, test::difference(crank_v, their_v));
    acceleration = std::max(acceleration, test::difference(crank_a, their_a));
    state.set(drawn.q, drawn.v);
    VectorXd ours(kOwn);
    dynamics::inverse_dynamics(state, drawn.a, ours);
    ours.tail<2>() += rotor_torque_Nm(drawn.at, armatures(robot), joint_v, joint_a);
    force = std::max(force, test::difference(ours, VectorXd(2 * one.force - two.force)));
  }
  std::printf("worst of %d states: gap %.2g m, speed %.2g, acceleration %.2g, force %.2g\n",
              kStates, gap, speed, acceleration, force);
  EXPECT_LE(gap, 1e-12);
  EXPECT_LE(speed, kExact);
  EXPECT_LE(acceleration, kExact);
  EXPECT_LE(force, kExact);
}

/// MuJoCo's own solution of its soft constraints. They give way by their inverse weight, which is
/// set to a millionth of what the light parts would make it.
VectorXd soft_acceleration(const Robot& robot, double part_kg, const State& drawn,
                           const VectorXd& torque) {
  test::MujocoEngine mujoco =
      looped(robot, part_kg, R"(solimp="0.9999 0.9999 0.001 0.5 2" solref="0.02 1")");
  mjModel& model = mujoco.model();
  model.opt.tolerance = 0;
  model.opt.iterations = 200;
  for (int i = 0; i < 2 * model.nbody; ++i) model.body_invweight0[i] *= 1e-6;
  mujoco.set(drawn.whole, VectorXd::Zero(mujoco.nv()));
  mju_zero(mujoco.data().qfrc_applied, static_cast<int>(mujoco.nv()));
  Eigen::Map<VectorXd>(mujoco.data().qfrc_applied, kOwn) = torque;
  mj_forward(&model, &mujoco.data());
  return Eigen::Map<const VectorXd>(mujoco.data().qacc, kOwn);
}

// At rest, for MuJoCo leaves G' v out of what it enforces. What remains of cranks and rods of 1 g
// after twice one less the other is of second order: 1e-3 squared, and some times the softness.
TEST(AnkleBesideMujoco, AcceleratesAlikeWithinItsSoftness) {
  const Robot robot = example();
  dynamics::TreeState state(robot.tree);
  oracles::Dice dice(18);
  double worst = 0;
  for (int i = 0; i < 100; ++i) {
    const State drawn(dice, robot, 0);
    const VectorXd torque = test::uniform_vector(dice, kOwn, 100);
    MatrixXd mass(kOwn, kOwn);
    VectorXd force(kOwn);
    state.set(drawn.q, drawn.v);
    dynamics::mass_matrix(state, mass);
    dynamics::bias(state, force);
    mass.bottomRightCorner<2, 2>() += reflected_inertia_kg_m2(drawn.at, armatures(robot));
    const VectorXd ours = mass.llt().solve(torque - force);
    const VectorXd theirs = 2 * soft_acceleration(robot, 1e-3, drawn, torque) -
                            soft_acceleration(robot, 2e-3, drawn, torque);
    worst = std::max(worst, test::difference(ours, theirs));
  }
  std::printf("worst of 100 states at rest, soft constraints: %.2g\n", worst);
  EXPECT_LE(worst, 1e-5);
}

}  // namespace
}  // namespace torquewright::hopper
