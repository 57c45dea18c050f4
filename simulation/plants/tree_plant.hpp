// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dynamics/tree_state.hpp"
#include "simulation/plant.hpp"

namespace torquewright::simulation {

/// Bodies and joints on a fixed base, some of whose joints are moved; the others are held where
/// they stand. Where a motion grew without bound forces and energy are no numbers either, so that a
/// simulation of it ends as any other does.
class TreePlant : public Plant {
 public:
  /// `bodies`: those that the moved joints carry, in the plant's order. `positions` (n x 1 of the
  /// tree): of the held joints; of the others it does not matter. std::invalid_argument where the
  /// base is not fixed, a body is none of the tree's or stands twice, or the size is wrong.
  TreePlant(dynamics::Tree tree, const std::vector<std::size_t>& bodies,
            const Eigen::VectorXd& positions);

  Eigen::Index joint_count() const override { return static_cast<Eigen::Index>(rows_.size()); }
  void mass_matrix(const Eigen::VectorXd& position_rad, Eigen::MatrixXd& mass_kg_m2) override;
  void bias(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s,
            Eigen::VectorXd& torque_Nm) override;
  double energy_J(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s) override;

 private:
  void set(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s);
  /// Whether the tree was set to those positions, at whatever speed.
  bool stands_at(const Eigen::VectorXd& position_rad) const;

  dynamics::TreeState state_;
  std::vector<Eigen::Index> rows_;  ///< Rows of the tree's velocities, by moved joint.
  Eigen::VectorXd position_, velocity_, force_;
  Eigen::VectorXd still_;  ///< (moved joints x 1) Zero.
  Eigen::MatrixXd mass_;
  bool is_set_ = false, is_mass_known_ = false;
};

}  // namespace torquewright::simulation
