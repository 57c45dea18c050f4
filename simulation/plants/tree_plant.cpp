// SPDX-License-Identifier: Apache-2.0
#include "simulation/plants/tree_plant.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/momentum.hpp"

namespace torquewright::simulation {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TreePlant::TreePlant(dynamics::Tree tree, const std::vector<std::size_t>& bodies,
                     const VectorXd& positions)
    : state_(std::move(tree)), position_(positions) {
  const dynamics::Tree& of = state_.tree();
  if (of.base != dynamics::BaseKind::kFixed || positions.size() != of.position_size()) {
    throw std::invalid_argument("tree plant: the base floats, or positions are too few or many");
  }
  for (const std::size_t body : bodies) {
    if (body == 0 || body >= of.bodies.size()) {
      throw std::invalid_argument("tree plant: no such body");
    }
    const Index row = state_.joint_row(body);
    if (std::find(rows_.begin(), rows_.end(), row) != rows_.end()) {
      throw std::invalid_argument("tree plant: a body stands twice");
    }
    rows_.push_back(row);
  }
  velocity_.setZero(of.velocity_size());
  force_.setZero(of.velocity_size());
  mass_.setZero(of.velocity_size(), of.velocity_size());
  still_.setZero(joint_count());
}

void TreePlant::set(const VectorXd& position_rad, const VectorXd& speed_rad_s) {
  if (!stands_at(position_rad)) is_mass_known_ = false;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    position_[rows_[i]] = position_rad[static_cast<Index>(i)];
    velocity_[rows_[i]] = speed_rad_s[static_cast<Index>(i)];
  }
  state_.set(position_, velocity_);
  is_set_ = true;
}

bool TreePlant::stands_at(const VectorXd& position_rad) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (position_[rows_[i]] != position_rad[static_cast<Index>(i)]) return false;
  }
  return is_set_;
}

void TreePlant::mass_matrix(const VectorXd& position_rad, MatrixXd& mass_kg_m2) {
  if (!position_rad.allFinite()) {
    mass_kg_m2.setIdentity();
    return;
  }
  if (!stands_at(position_rad)) set(position_rad, still_);
  if (!is_mass_known_) dynamics::mass_matrix(state_, mass_);
  is_mass_known_ = true;
  for (Index i = 0; i < joint_count(); ++i) {
    for (Index j = 0; j < joint_count(); ++j) {
      mass_kg_m2(i, j) =
          mass_(rows_[static_cast<std::size_t>(i)], rows_[static_cast<std::size_t>(j)]);
    }
  }
}

void TreePlant::bias(const VectorXd& position_rad, const VectorXd& speed_rad_s,
                     VectorXd& torque_Nm) {
  if (!position_rad.allFinite() || !speed_rad_s.allFinite()) {
    torque_Nm.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  set(position_rad, speed_rad_s);
  dynamics::bias(state_, force_);
  for (Index i = 0; i < joint_count(); ++i)
    torque_Nm[i] = force_[rows_[static_cast<std::size_t>(i)]];
}

double TreePlant::energy_J(const VectorXd& position_rad, const VectorXd& speed_rad_s) {
  if (!position_rad.allFinite() || !speed_rad_s.allFinite()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  set(position_rad, speed_rad_s);
  return dynamics::kinetic_energy_J(state_) + dynamics::potential_energy_J(state_);
}

}  // namespace torquewright::simulation
