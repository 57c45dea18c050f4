// SPDX-License-Identifier: Apache-2.0
// Linkages written as bodies. Oracle: MuJoCo's own constraint Jacobian G and mass matrix M of the
// file, cranks and rods then without mass: with N from G alone, N^T M N is the mass matrix at the
// robot's own velocities, which ours has from the mechanisms' formulas.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "robot/mjcf/mjcf_writer.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/model/whole_body.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/dynamics/random_tree.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double kAsFormulas = 1e-9;  // as of the formulas beside MuJoCo, ankle_mujoco_test.cpp

class Looped {
 public:
  Looped() {
    mju_user_warning = [](const char*) {};  // that what weighs nothing cannot be accelerated
    mjModel& model = mujoco_.model();
    model.opt.disableflags |= mjDSBL_LIMIT | mjDSBL_CONTACT;
    for (int body = 0; body < model.nbody; ++body) {
      const std::string name = mj_id2name(&model, mjOBJ_BODY, body);
      if (!name.ends_with("_crank") && !name.ends_with("_fork") && !name.ends_with("_rod"))
        continue;
      model.body_mass[body] = 0;
      mju_zero(model.body_inertia + 3 * body, 3);
    }
    for (int joint = 0; joint < model.njnt; ++joint) {
      const char* name = mj_id2name(&model, mjOBJ_JOINT, joint);
      const bool is_own = name == nullptr || robot_.find_joint(name).has_value();
      const int width = model.jnt_type[joint] == mjJNT_FREE ? 6 : 1;
      for (int k = 0; k < width; ++k) {
        (is_own ? own_ : links_).push_back(model.jnt_dofadr[joint] + k);
      }
    }
  }

  const Robot& robot() const { return robot_; }

  /// Moves cranks and rods, by Newton's method, until the loops of this posture are closed.
  void close(const VectorXd& joints) {
    VectorXd q = Eigen::Map<const VectorXd>(mujoco_.model().qpos0, mujoco_.nq());
    for (int step = 1; step <= 20; ++step) {
      for (Index i = 0; i < joints.size(); ++i) {
        q[own_[static_cast<std::size_t>(i) + 6] + 1] = joints[i] * step / 20;
      }
      for (int again = 0; again < 12; ++again) {
        set(q);
        const VectorXd move =
            jacobian()(Eigen::all, links_).completeOrthogonalDecomposition().solve(gap());
        for (std::size_t i = 0; i < links_.size(); ++i)
          q[links_[i] + 1] -= move[static_cast<Index>(i)];
      }
    }
    set(q);
  }

  VectorXd gap() { return Eigen::Map<const VectorXd>(mujoco_.data().efc_pos, rows()); }
  double crank_rad(const std::string& drive) {
    const int joint = mj_name2id(&mujoco_.model(), mjOBJ_JOINT, (drive + "_crank").c_str());
    return mujoco_.data().qpos[mujoco_.model().jnt_qposadr[joint]];
  }

  MatrixXd mass_matrix() {
    MatrixXd N = MatrixXd::Zero(mujoco_.nv(), static_cast<Index>(own_.size()));
    for (std::size_t i = 0; i < own_.size(); ++i) N(own_[i], static_cast<Index>(i)) = 1;
    const MatrixXd G = jacobian();
    const MatrixXd moved =
        -G(Eigen::all, links_).completeOrthogonalDecomposition().solve(G(Eigen::all, own_));
    for (std::size_t i = 0; i < links_.size(); ++i)
      N.row(links_[i]) = moved.row(static_cast<Index>(i));
    return N.transpose() * mujoco_.mass_matrix() * N;
  }

 private:
  Index rows() { return mujoco_.data().nefc; }
  MatrixXd jacobian() {
    return Eigen::Map<const RowMajor>(mujoco_.data().efc_J, rows(), mujoco_.nv());
  }
  void set(const VectorXd& q) { mujoco_.set(q, VectorXd::Zero(mujoco_.nv())); }

  Robot robot_ = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  test::MujocoEngine mujoco_{
      mjcf_of(robot_, {.actuators = true, .ground = true, .closed_loops = true, .collisions = true})
          .text};
  std::vector<Index> own_;
  std::vector<Index> links_;
};

TEST(ClosedLoops, HaveTheMechanismsMotionAndInertia) {
  Looped looped;
  WholeBody ours(looped.robot());
  oracles::Dice dice(21);
  double gap = 0, crank = 0, mass = 0;
  for (int sample = 0; sample < 30; ++sample) {
    VectorXd joints(3);
    for (Index i = 0; i < 3; ++i) {
      const auto& limits = looped.robot().tree.bodies[static_cast<std::size_t>(i) + 1].joint.limits;
      joints[i] = test::uniform(dice, 0.9 * limits.position_min, 0.9 * limits.position_max);
    }
    looped.close(joints);
    gap = std::max(gap, looped.gap().cwiseAbs().maxCoeff());
    VectorXd q = dynamics::zero_position(looped.robot().tree);
    q.tail<3>() = joints;
    ASSERT_TRUE(ours.set(q, VectorXd::Zero(9)));
    const auto ankle =
        looped.robot().drivetrains[1].mechanism->transfer(joints.tail<2>(), SmallVector::Zero(2));
    crank = std::max({crank, std::abs(looped.crank_rad("knee") - joints[0]),
                      std::abs(looped.crank_rad("ankle_left") - ankle->actuator_position_rad[0]),
                      std::abs(looped.crank_rad("ankle_right") - ankle->actuator_position_rad[1])});
    MatrixXd own(9, 9);
    ours.mass_matrix(own);
    mass = std::max(mass, test::difference(looped.mass_matrix(), own));
  }
  std::printf("worst of 30 postures: gap %.2g m, cranks %.2g rad, mass matrix %.2g\n", gap, crank,
              mass);
  EXPECT_LE(gap, 1e-12);
  EXPECT_LE(crank, kAsFormulas);
  EXPECT_LE(mass, kAsFormulas);
}

// Oracle: the pins hold while MuJoCo runs the file as it is, undriven, for half a second.
TEST(ClosedLoops, HoldWhereMujocoRunsTheFile) {
  const Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  test::MujocoEngine mujoco(
      mjcf_of(robot, {.actuators = true, .ground = true, .closed_loops = true, .collisions = true})
          .text);
  mjData& data = mujoco.data();
  mj_resetDataKeyframe(&mujoco.model(), &data, 0);
  for (int step = 0; step < 250; ++step) {
    mj_step(&mujoco.model(), &data);
    for (int row = 0; row < 9; ++row) {
      ASSERT_EQ(data.efc_type[row], mjCNSTR_EQUALITY);
      ASSERT_LE(std::abs(data.efc_pos[row]), 1e-3) << step;
    }
  }
  EXPECT_NEAR(data.time, 0.5, 1e-9);
}

}  // namespace
}  // namespace torquewright::hopper
