// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/unknown_loads.hpp"

#include <cmath>

#include "dynamics/inverse_dynamics.hpp"
#include "hopper/tracking/linearisation.hpp"

namespace torquewright::hopper {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double kLeastShare = 0.01;     // of the robot's mass
constexpr double kUsualMassShare = 0.1;  // a tenth is added or left out
constexpr double kUsualInertiaShare = 0.1;
constexpr double kUsualShift_m = 0.02;  // cables, covers, a drive's own place
constexpr double kUsualFriction_Nm = 0.5;
constexpr double kRest_rad_s = 0.1;  // slower than that friction may act either way
constexpr double kStep = 0.01;       // of the quotients, which are exact

}  // namespace

UnknownLoads::UnknownLoads(const Robot& robot) : body_(robot) {
  const std::vector<dynamics::Body>& bodies = robot.tree.bodies;
  double mass_kg = 0.0;
  for (const dynamics::Body& body : bodies) mass_kg += body.inertia.mass_kg;
  add_mass(kUsualMassShare, [](dynamics::Tree& changed, double step) {
    for (dynamics::Body& body : changed.bodies) body.inertia.mass_kg *= 1.0 + step;
  });
  add_mass(kUsualInertiaShare, [](dynamics::Tree& changed, double step) {
    for (dynamics::Body& body : changed.bodies) body.inertia.inertia_kg_m2 *= 1.0 + step;
  });
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].inertia.mass_kg < kLeastShare * mass_kg) continue;
    for (Index axis = 0; axis < 3; ++axis) {
      add_mass(kUsualShift_m, [i, axis](dynamics::Tree& changed, double step) {
        changed.bodies[i].inertia.center_of_mass_m[axis] += step;
      });
    }
  }
  const Index masses = spread_.size(), drives = static_cast<Index>(body_.drive_count());
  spread_.conservativeResize(masses + drives);
  spread_.tail(drives).setConstant(kUsualFriction_Nm);
}

void UnknownLoads::add_mass(double spread,
                            const std::function<void(dynamics::Tree&, double)>& change) {
  dynamics::Tree more = body_.robot().tree, less = more;
  change(more, kStep);
  change(less, -kStep);
  masses_.push_back({dynamics::TreeState(std::move(more)), dynamics::TreeState(std::move(less))});
  spread_.conservativeResize(spread_.size() + 1);
  spread_[spread_.size() - 1] = spread;
}

void UnknownLoads::add_mass_forces(const VectorXd& position, const VectorXd& velocity,
                                   const VectorXd& acceleration, double sign, MatrixXd& out) {
  VectorXd more(velocity.size()), less(velocity.size());
  for (std::size_t i = 0; i < masses_.size(); ++i) {
    masses_[i].more.set(position, velocity);
    masses_[i].less.set(position, velocity);
    dynamics::inverse_dynamics(masses_[i].more, acceleration, more);
    dynamics::inverse_dynamics(masses_[i].less, acceleration, less);
    out.col(static_cast<Index>(i)) += sign / (2.0 * kStep) * (more - less);
  }
}

std::optional<MatrixXd> UnknownLoads::forces(const VectorXd& position, const VectorXd& velocity,
                                             const VectorXd& acceleration) {
  if (!body_.set(position, velocity)) return std::nullopt;
  MatrixXd forces = MatrixXd::Zero(velocity.size(), size());
  add_mass_forces(position, velocity, acceleration, 1.0, forces);
  const MatrixXd drives = drive_jacobian(body_);
  const Eigen::ArrayXd speed_rad_s = (drives * velocity).array();
  const VectorXd against = speed_rad_s / (speed_rad_s.square() + kRest_rad_s * kRest_rad_s).sqrt();
  forces.rightCols(drives.rows()) = drives.transpose() * against.asDiagonal();
  return forces;
}

MatrixXd UnknownLoads::impulses(const VectorXd& position, const VectorXd& change) {
  const VectorXd nothing = VectorXd::Zero(change.size());
  MatrixXd impulses = MatrixXd::Zero(change.size(), size());
  add_mass_forces(position, nothing, change, 1.0, impulses);
  add_mass_forces(position, nothing, nothing, -1.0, impulses);
  return impulses;
}

}  // namespace torquewright::hopper
