// SPDX-License-Identifier: Apache-2.0
#include "tests/robot/mujoco_loops.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <stdexcept>

namespace torquewright::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

namespace {

int joint_id(mjModel& model, const std::string& name) {
  const int id = mj_name2id(&model, mjOBJ_JOINT, name.c_str());
  if (id < 0) throw std::runtime_error("MuJoCo has no joint " + name);
  return id;
}

}  // namespace

MujocoLoops::MujocoLoops(const std::string& mjcf, const hopper::Robot& robot) : mujoco_(mjcf) {
  mju_user_warning = [](const char*) {};  // that what weighs nothing cannot be accelerated
  mjModel& model = mujoco_.model();
  model.opt.disableflags |= mjDSBL_LIMIT | mjDSBL_CONTACT | mjDSBL_FRICTIONLOSS;
  base_ = robot.tree.base_velocity_size();
  for (Index row = 0; row < base_; ++row) own_.push_back(row);
  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) {
    own_.push_back(model.jnt_dofadr[joint_id(model, robot.tree.bodies[i].joint.name)]);
  }
  for (Index row = 0; row < mujoco_.nv(); ++row) {
    if (std::find(own_.begin(), own_.end(), row) == own_.end()) links_.push_back(row);
  }
  q_ = Eigen::Map<const VectorXd>(model.qpos0, mujoco_.nq());
  set(q_);
}

void MujocoLoops::set(const VectorXd& q) {
  q_ = q;
  mujoco_.set(q, VectorXd::Zero(mujoco_.nv()));
}

MatrixXd MujocoLoops::gap_jacobian() {
  return Eigen::Map<const RowMajor>(mujoco_.data().efc_J, mujoco_.data().nefc, mujoco_.nv());
}

double MujocoLoops::close(const VectorXd& joints) {
  constexpr int kSteps = 40;
  mjModel& model = mujoco_.model();
  std::vector<int> places;  // of the own joints' positions
  for (std::size_t i = static_cast<std::size_t>(base_); i < own_.size(); ++i) {
    places.push_back(model.jnt_qposadr[model.dof_jntid[own_[i]]]);
  }
  VectorXd from(joints.size());
  for (Index i = 0; i < joints.size(); ++i) from[i] = q_[places[static_cast<std::size_t>(i)]];
  double gap_m = 0;
  for (int step = 1; step <= kSteps; ++step) {
    VectorXd q = q_;
    for (Index i = 0; i < joints.size(); ++i) {
      q[places[static_cast<std::size_t>(i)]] = from[i] + (joints[i] - from[i]) * step / kSteps;
    }
    set(q);
    for (int again = 0; again < 15; ++again) {
      const VectorXd gaps = Eigen::Map<const VectorXd>(mujoco_.data().efc_pos, mujoco_.data().nefc);
      gap_m = gaps.cwiseAbs().maxCoeff();
      Eigen::CompleteOrthogonalDecomposition<MatrixXd> factors;
      factors.setThreshold(1e-9);  // spins of rods between balls are no motion of the gaps
      factors.compute(gap_jacobian()(Eigen::all, links_));
      VectorXd move = VectorXd::Zero(mujoco_.nv());
      move(links_) = -factors.solve(gaps);
      VectorXd next = q_;
      mj_integratePos(&model, next.data(), move.data(), 1);
      set(next);
    }
  }
  return gap_m;
}

double MujocoLoops::position(const std::string& joint) {
  return q_[mujoco_.model().jnt_qposadr[joint_id(mujoco_.model(), joint)]];
}

MatrixXd MujocoLoops::closed_motions() {
  MatrixXd N = MatrixXd::Zero(mujoco_.nv(), static_cast<Index>(own_.size()));
  for (std::size_t i = 0; i < own_.size(); ++i) N(own_[i], static_cast<Index>(i)) = 1;
  const MatrixXd G = gap_jacobian();
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> factors;
  factors.setThreshold(1e-9);
  factors.compute(G(Eigen::all, links_));
  const MatrixXd moved = -factors.solve(MatrixXd(G(Eigen::all, own_)));
  for (std::size_t i = 0; i < links_.size(); ++i) {
    N.row(links_[i]) = moved.row(static_cast<Index>(i));
  }
  return N;
}

Eigen::RowVectorXd MujocoLoops::ratios(const std::string& joint) {
  const int id = joint_id(mujoco_.model(), joint);
  const MatrixXd N = closed_motions();
  return N.row(mujoco_.model().jnt_dofadr[id]).tail(N.cols() - base_);
}

MatrixXd MujocoLoops::mass_matrix() {
  const MatrixXd N = closed_motions();
  return N.transpose() * mujoco_.mass_matrix() * N;
}

/// N' by central differences: 1e-5 s along the motion leave 1e-10 of its third derivative.
VectorXd MujocoLoops::inverse_dynamics(const VectorXd& velocity, const VectorXd& acceleration) {
  constexpr double kStep_s = 1e-5;
  const VectorXd here = q_;
  const MatrixXd N = closed_motions();
  const VectorXd speeds = N * velocity;
  const auto motions_at = [&](double step_s) {
    VectorXd q = here;
    mj_integratePos(&mujoco_.model(), q.data(), speeds.data(), step_s);
    set(q);
    return closed_motions();
  };
  const VectorXd bent = (motions_at(kStep_s) - motions_at(-kStep_s)) * velocity / (2 * kStep_s);
  q_ = here;
  mujoco_.set(here, speeds);
  const Eigen::Map<const VectorXd> passive(mujoco_.data().qfrc_passive, mujoco_.nv());
  const VectorXd all = mujoco_.mass_matrix() * (N * acceleration + bent) + mujoco_.bias() - passive;
  return N.transpose() * all;
}

void MujocoLoops::begin_at_keyframe(int key) {
  mjModel& model = mujoco_.model();
  set(Eigen::Map<const VectorXd>(model.key_qpos + static_cast<std::ptrdiff_t>(key) * model.nq,
                                 model.nq));
}

void MujocoLoops::leave_balls_undamped() {
  mjModel& model = mujoco_.model();
  for (int dof = 0; dof < model.nv; ++dof) {
    if (model.jnt_type[model.dof_jntid[dof]] == mjJNT_BALL) model.dof_damping[dof] = 0;
  }
}

void MujocoLoops::weigh_nothing(const std::string& body) {
  mjModel& model = mujoco_.model();
  const int id = mj_name2id(&model, mjOBJ_BODY, body.c_str());
  if (id < 0) throw std::runtime_error("MuJoCo has no body " + body);
  model.body_mass[id] = 0;
  mju_zero(model.body_inertia + 3 * id, 3);
}

}  // namespace torquewright::test
