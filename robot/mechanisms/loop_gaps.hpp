// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot/mechanisms/loop_geometry.hpp"

namespace torquewright::hopper {

template <typename T>
using LoopMatrixOf = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/// A loop's tree without names, to be copied often.
inline dynamics::Tree without_names(const dynamics::Tree& tree) {
  dynamics::Tree out = tree;
  for (dynamics::Body& body : out.bodies) body.name = body.joint.name = "";
  return out;
}

/// Between the points that stay together, three rows for each closure.
template <typename T>
dynamics::VectorX<T> gaps_m(const dynamics::TreeStateOf<T>& state,
                            const std::vector<LoopClosure>& closures) {
  dynamics::VectorX<T> gaps(3 * static_cast<Eigen::Index>(closures.size()));
  for (std::size_t i = 0; i < closures.size(); ++i) {
    gaps.template segment<3>(3 * static_cast<Eigen::Index>(i)) =
        dynamics::point_position_m(state, closures[i][0]) -
        dynamics::point_position_m(state, closures[i][1]);
  }
  return gaps;
}

/// Of the gaps by the joints' positions.
template <typename T>
LoopMatrixOf<T> gap_jacobian(const dynamics::TreeStateOf<T>& state,
                             const std::vector<LoopClosure>& closures) {
  const Eigen::Index columns = state.tree().velocity_size();
  LoopMatrixOf<T> jacobian(3 * static_cast<Eigen::Index>(closures.size()), columns);
  Eigen::Matrix<T, 3, Eigen::Dynamic> one(3, columns), other(3, columns);
  for (std::size_t i = 0; i < closures.size(); ++i) {
    dynamics::point_jacobian(state, closures[i][0], one);
    dynamics::point_jacobian(state, closures[i][1], other);
    jacobian.template middleRows<3>(3 * static_cast<Eigen::Index>(i)) = one - other;
  }
  return jacobian;
}

/// d/dt of the gaps' Jacobian times the state's velocity, while the tree moves with it.
template <typename T>
dynamics::VectorX<T> gap_bias_m_s2(const dynamics::TreeStateOf<T>& state,
                                   const std::vector<LoopClosure>& closures) {
  dynamics::VectorX<T> bias(3 * static_cast<Eigen::Index>(closures.size()));
  for (std::size_t i = 0; i < closures.size(); ++i) {
    bias.template segment<3>(3 * static_cast<Eigen::Index>(i)) =
        dynamics::point_bias_acceleration_m_s2(state, closures[i][0]) -
        dynamics::point_bias_acceleration_m_s2(state, closures[i][1]);
  }
  return bias;
}

}  // namespace torquewright::hopper
