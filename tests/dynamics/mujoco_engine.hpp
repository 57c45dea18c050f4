// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <memory>
#include <string>

namespace torquewright::test {

/// MuJoCo as an independent engine. Its conventions, not ours: a free joint has the position,
/// then the quaternion w first; velocities linear in the world's axes, angular in the body's.
class MujocoEngine {
 public:
  /// std::runtime_error with MuJoCo's message where it cannot read the text.
  explicit MujocoEngine(const std::string& mjcf);

  Eigen::Index nq() const { return model_->nq; }
  Eigen::Index nv() const { return model_->nv; }
  void set(const Eigen::VectorXd& q, const Eigen::VectorXd& v);

  Eigen::MatrixXd mass_matrix() const;
  Eigen::VectorXd bias() const;
  Eigen::VectorXd inverse_dynamics(const Eigen::VectorXd& a);
  /// Of body 1 and all that hangs on it: all bodies, if the tree is one.
  Eigen::Vector3d center_of_mass_m() const;
  Eigen::Vector3d angular_momentum_Nm_s() const;
  double kinetic_energy_J() const;
  double potential_energy_J() const;
  mjModel& model() { return *model_; }
  mjData& data() { return *data_; }

 private:
  struct Deleter {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, Deleter> model_;
  std::unique_ptr<mjData, Deleter> data_;
};

}  // namespace torquewright::test
