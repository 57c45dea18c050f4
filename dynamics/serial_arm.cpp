// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/serial_arm.md.
#include "dynamics/serial_arm.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace torquewright::dynamics {
namespace {

std::size_t at(Eigen::Index index) { return static_cast<std::size_t>(index); }

bool is_finite(const SerialLink& link) {
  return std::isfinite(link.mass_kg) && std::isfinite(link.length_m) &&
         std::isfinite(link.center_of_mass_m) && std::isfinite(link.inertia_kg_m2);
}

}  // namespace

SerialLinkParameters parameters_of(const SerialLink& link) {
  const double first_moment_kg_m = link.mass_kg * link.center_of_mass_m;
  return {link.mass_kg, first_moment_kg_m,
          link.inertia_kg_m2 + first_moment_kg_m * link.center_of_mass_m};
}

SerialArm::SerialArm(std::vector<SerialLink> links, double gravity_m_s2)
    : links_(std::move(links)),
      gravity_m_s2_(gravity_m_s2),
      joints_(static_cast<Eigen::Index>(links_.size())),
      parameters_(kParametersPerLink * joints_),
      directions_(links_.size()),
      zero_(Eigen::VectorXd::Zero(joints_)),
      torque_Nm_(joints_),
      regressor_(joints_, kParametersPerLink * joints_),
      mass_matrix_(joints_, joints_) {
  if (links_.empty()) throw std::invalid_argument("serial arm: no links");
  if (!std::isfinite(gravity_m_s2)) throw std::invalid_argument("serial arm: gravity not finite");
  for (Eigen::Index i = 0; i < joints_; ++i) {
    if (!is_finite(links_[at(i)])) throw std::invalid_argument("serial arm: link not finite");
    const SerialLinkParameters link = parameters_of(links_[at(i)]);
    parameters_.segment<kParametersPerLink>(kParametersPerLink * i) << link.mass_kg,
        link.first_moment_kg_m, link.joint_inertia_kg_m2;
  }
}

void SerialArm::require_size(const Vector& vector) const {
  if (vector.size() != joints_) throw std::invalid_argument("serial arm: one value per link");
}

void SerialArm::set_directions(const Vector& position_rad) {
  require_size(position_rad);
  double angle_rad = 0;
  for (Eigen::Index i = 0; i < joints_; ++i) {
    angle_rad += position_rad[i];
    const double sine = std::sin(angle_rad);
    const double cosine = std::cos(angle_rad);
    directions_[at(i)] = {{sine, -cosine}, {cosine, sine}};  // eq. (1)
  }
}

void SerialArm::regressor(const Vector& position_rad, const Vector& velocity_rad_s,
                          const Vector& acceleration_rad_s2, MatrixOut out) {
  set_directions(position_rad);
  require_size(velocity_rad_s);
  require_size(acceleration_rad_s2);
  if (out.rows() != joints_ || out.cols() != kParametersPerLink * joints_) {
    throw std::invalid_argument("serial arm: regressor is joints x 3 joints");
  }
  double speed_rad_s = 0;
  double acceleration = 0;
  // A base that accelerates upwards at g feels what gravity does.
  Eigen::Vector2d joint_m_s2(0, gravity_m_s2_);
  for (Eigen::Index i = 0; i < joints_; ++i) {
    speed_rad_s += velocity_rad_s[i];
    acceleration += acceleration_rad_s2[i];
    const auto& [along, across] = directions_[at(i)];
    const Eigen::Vector2d per_metre = acceleration * across - speed_rad_s * speed_rad_s * along;
    Eigen::Vector2d lever_m = Eigen::Vector2d::Zero();  // from joint j to joint i, turned across
    for (Eigen::Index j = i; j >= 0; --j) {
      if (j < i) lever_m += links_[at(j)].length_m * directions_[at(j)].across;
      out(j, 3 * i) = joint_m_s2.dot(lever_m);                              // eq. (5)
      out(j, 3 * i + 1) = per_metre.dot(lever_m) + joint_m_s2.dot(across);  // eq. (6)
      out(j, 3 * i + 2) = acceleration;                                     // eq. (7)
    }
    for (Eigen::Index j = i + 1; j < joints_; ++j) out.row(j).segment<3>(3 * i).setZero();
    joint_m_s2 += links_[at(i)].length_m * per_metre;
  }
}

void SerialArm::inverse_dynamics(const Vector& position_rad, const Vector& velocity_rad_s,
                                 const Vector& acceleration_rad_s2, VectorOut torque_Nm) {
  require_size(torque_Nm);
  regressor(position_rad, velocity_rad_s, acceleration_rad_s2, regressor_);
  torque_Nm.noalias() = regressor_ * parameters_;
}

void SerialArm::bias(const Vector& position_rad, const Vector& velocity_rad_s,
                     VectorOut torque_Nm) {
  inverse_dynamics(position_rad, velocity_rad_s, zero_, torque_Nm);
}

void SerialArm::mass_matrix(const Vector& position_rad, MatrixOut out) {
  set_directions(position_rad);
  if (out.rows() != joints_ || out.cols() != joints_) {
    throw std::invalid_argument("serial arm: mass matrix is joints x joints");
  }
  out.setZero();
  for (Eigen::Index i = 0; i < joints_; ++i) {
    const auto link = parameters_.segment<kParametersPerLink>(kParametersPerLink * i);
    const Eigen::Vector2d& across = directions_[at(i)].across;
    Eigen::Vector2d lever_j_m = Eigen::Vector2d::Zero();
    for (Eigen::Index j = i; j >= 0; --j) {
      if (j < i) lever_j_m += links_[at(j)].length_m * directions_[at(j)].across;
      Eigen::Vector2d lever_k_m = lever_j_m;
      for (Eigen::Index k = j; k >= 0; --k) {
        if (k < j) lever_k_m += links_[at(k)].length_m * directions_[at(k)].across;
        out(j, k) += link[0] * lever_j_m.dot(lever_k_m) +
                     link[1] * across.dot(lever_j_m + lever_k_m) + link[2];  // eq. (4)
      }
    }
  }
  for (Eigen::Index j = 0; j < joints_; ++j) {
    for (Eigen::Index k = j + 1; k < joints_; ++k) out(j, k) = out(k, j);
  }
}

double SerialArm::kinetic_energy_J(const Vector& position_rad, const Vector& velocity_rad_s) {
  require_size(velocity_rad_s);
  mass_matrix(position_rad, mass_matrix_);
  torque_Nm_.noalias() = mass_matrix_ * velocity_rad_s;
  return 0.5 * velocity_rad_s.dot(torque_Nm_);
}

double SerialArm::potential_energy_J(const Vector& position_rad) {
  set_directions(position_rad);
  double energy_J = 0;
  double joint_height_m = 0;
  for (Eigen::Index i = 0; i < joints_; ++i) {
    const SerialLink& link = links_[at(i)];
    const double along = directions_[at(i)].along.y();
    energy_J += gravity_m_s2_ * link.mass_kg * (joint_height_m + link.center_of_mass_m * along);
    joint_height_m += link.length_m * along;
  }
  return energy_J;
}

}  // namespace torquewright::dynamics
