// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

/// What a robot's document may have wrong of what its drives carry: all masses by one factor, and
/// all inertias about centres of mass by another (shares), where the centre of mass of each body
/// is, along the body's axes (m; bodies without a hundredth of the mass are left out), and dry
/// friction at each drive's output (Nm).
class UnknownLoads {
 public:
  explicit UnknownLoads(const Robot& robot);

  Eigen::Index size() const { return spread_.size(); }
  /// What of each is usual, as a standard deviation (p x 1).
  const Eigen::VectorXd& spread() const { return spread_; }
  /// Returns the generalised forces (n x p) that a motion asks for beside those of the document,
  /// per unit of each. Exact of masses, of which they are of second degree; friction is smoothed
  /// about rest. None where a mechanism does not reach the posture.
  std::optional<Eigen::MatrixXd> forces(const Eigen::VectorXd& position,
                                        const Eigen::VectorXd& velocity,
                                        const Eigen::VectorXd& acceleration);
  /// Returns the generalised impulses (n x p) that a change of the velocity asks for beside.
  Eigen::MatrixXd impulses(const Eigen::VectorXd& position, const Eigen::VectorXd& change);

 private:
  struct Sides {
    dynamics::TreeState more, less;
  };
  void add_mass(double spread, const std::function<void(dynamics::Tree&, double)>& change);
  void add_mass_forces(const Eigen::VectorXd& position, const Eigen::VectorXd& velocity,
                       const Eigen::VectorXd& acceleration, double sign, Eigen::MatrixXd& out);

  WholeBody body_;
  std::vector<Sides> masses_;
  Eigen::VectorXd spread_;
};

}  // namespace torquewright::hopper
