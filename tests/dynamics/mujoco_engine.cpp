// SPDX-License-Identifier: Apache-2.0
#include "tests/dynamics/mujoco_engine.hpp"

#include <array>
#include <stdexcept>

#include "tests/io/scratch_folder.hpp"

namespace torquewright::test {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::VectorXd copied(const mjtNum* numbers, Eigen::Index size) {
  return Eigen::Map<const Eigen::VectorXd>(numbers, size);
}

}  // namespace

MujocoEngine::MujocoEngine(const std::string& mjcf) {
  const ScratchFolder folder;
  std::array<char, 1000> error{};
  const std::string file = folder.write("model.xml", mjcf).string();
  model_.reset(mj_loadXML(file.c_str(), nullptr, error.data(), error.size()));
  if (!model_) throw std::runtime_error(error.data());
  model_->opt.enableflags |= mjENBL_ENERGY;
  data_.reset(mj_makeData(model_.get()));
}

void MujocoEngine::set(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  Eigen::Map<Eigen::VectorXd>(data_->qpos, nq()) = q;
  Eigen::Map<Eigen::VectorXd>(data_->qvel, nv()) = v;
  mj_fwdPosition(model_.get(), data_.get());
  mj_fwdVelocity(model_.get(), data_.get());
  mj_energyPos(model_.get(), data_.get());
  mj_energyVel(model_.get(), data_.get());
  mj_subtreeVel(model_.get(), data_.get());
}

Eigen::MatrixXd MujocoEngine::mass_matrix() const {
  RowMajor full(nv(), nv());
  mj_fullM(model_.get(), full.data(), data_->qM);
  return full;
}

Eigen::VectorXd MujocoEngine::bias() const { return copied(data_->qfrc_bias, nv()); }

Eigen::VectorXd MujocoEngine::inverse_dynamics(const Eigen::VectorXd& a) {
  Eigen::Map<Eigen::VectorXd>(data_->qacc, nv()) = a;
  mj_inverse(model_.get(), data_.get());
  return copied(data_->qfrc_inverse, nv());
}

Eigen::Vector3d MujocoEngine::center_of_mass_m() const { return copied(data_->subtree_com + 3, 3); }

Eigen::Vector3d MujocoEngine::angular_momentum_Nm_s() const {
  return copied(data_->subtree_angmom + 3, 3);
}

double MujocoEngine::potential_energy_J() const { return data_->energy[0]; }
double MujocoEngine::kinetic_energy_J() const { return data_->energy[1]; }

}  // namespace torquewright::test
