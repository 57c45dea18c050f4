// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/plane/sagittal_momentum.hpp"

#include "dynamics/composite.hpp"
#include "dynamics/jet.hpp"
#include "dynamics/momentum.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::VectorX;
using Eigen::Index;

constexpr Index kAboutY = 1;  // row of the momentum matrix

/// Of the tree, its base at the origin.
template <typename T>
VectorX<T> tree_rows(const SagittalRobot& robot, const VectorX<T>& posture) {
  VectorX<T> rows = VectorX<T>::Zero(robot.robot.tree.velocity_size());
  for (Index i = 0; i < posture.size(); ++i) {
    rows[robot.moving[static_cast<std::size_t>(i) + 2]] = posture[i];
  }
  return rows;
}

}  // namespace

template <typename T>
SagittalMomentumOf<T> sagittal_momentum(const SagittalRobot& robot, const VectorX<T>& posture_rad,
                                        const VectorX<T>& rates_rad_s) {
  dynamics::TreeStateOf<T> state(robot.robot.tree);
  const VectorX<T> rates = tree_rows(robot, rates_rad_s);
  state.set(tree_rows(robot, posture_rad), rates);
  Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> momentum(6, rates.size());
  dynamics::centroidal_momentum_matrix(state, momentum);
  SagittalMomentumOf<T> out{T(0.0), T(0.0)};
  for (Index i = 0; i < rates.size(); ++i) out.angular_Nm_s += momentum(kAboutY, i) * rates[i];
  const auto& all = state.composites().front();  // gathered by the momentum matrix
  const dynamics::Vector3<T>& moment = all.first_moment_kg_m;
  // Steiner, from the base's origin to the centre of mass; eq. (14).
  out.inertia_kg_m2 = all.inertia_kg_m2(1, 1) -
                      (moment.x() * moment.x() + moment.z() * moment.z()) * (1.0 / all.mass_kg);
  return out;
}

template SagittalMomentumOf<double> sagittal_momentum(const SagittalRobot&, const VectorX<double>&,
                                                      const VectorX<double>&);
template SagittalMomentumOf<dynamics::Jet> sagittal_momentum(const SagittalRobot&,
                                                             const VectorX<dynamics::Jet>&,
                                                             const VectorX<dynamics::Jet>&);
template SagittalMomentumOf<dynamics::Jet2> sagittal_momentum(const SagittalRobot&,
                                                              const VectorX<dynamics::Jet2>&,
                                                              const VectorX<dynamics::Jet2>&);

}  // namespace torquewright::hopper
