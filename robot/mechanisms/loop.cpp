// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/mechanisms.md, "Loop".
#include "robot/mechanisms/loop.hpp"

#include <algorithm>
#include <cmath>

#include "robot/mechanisms/gap_closer.hpp"

namespace torquewright::hopper {

using dynamics::value_of;
using Eigen::Index;

template <typename T>
std::optional<TransferOf<T>> Loop::transfer_of_followed(const FollowedOf<T>& followed) const {
  const Index count = geometry().joints;
  TransferOf<T> out{SmallVectorOf<T>(count), SmallMatrixOf<T>(count, count),
                    SmallMatrixOf<T>(count, count)};
  SmallMatrix values(count, count);
  for (Index k = 0; k < count; ++k) {
    const Index row = static_cast<Index>(geometry().turned[static_cast<std::size_t>(k)]) - 1;
    out.actuator_position_rad[k] = followed.position[row];
    out.jacobian.row(k) = followed.motions.row(row);
    out.jacobian_rate_1_s.row(k) = followed.motions_rate_1_s.row(row);
    for (Index j = 0; j < count; ++j) values(k, j) = value_of(out.jacobian(k, j));
  }
  double fastest = 0;
  for (Index i = 0; i < followed.motions.rows(); ++i) {
    for (Index j = 0; j < count; ++j) {
      fastest = std::max(fastest, std::abs(value_of(followed.motions(i, j))));
    }
  }
  const double least = values.rowwise().norm().minCoeff();
  if (!(least > kSingularLever * fastest)) return std::nullopt;
  if (count == 2) {
    const SmallMatrix rows = values.rowwise().normalized();
    if (!(std::abs(rows(0, 0) * rows(1, 1) - rows(0, 1) * rows(1, 0)) > kSingularLever)) {
      return std::nullopt;
    }
  }
  return out;
}

template <typename T>
std::optional<TransferOf<T>> Loop::any_transfer(const SmallVectorOf<T>& joint_rad,
                                                const SmallVectorOf<T>& joint_rad_s) const {
  const auto followed = follow<T>(joint_rad, joint_rad_s);
  if (!followed) return std::nullopt;
  return transfer_of_followed<T>(*followed);
}

std::optional<Transfer> Loop::transfer(const SmallVector& joint_rad,
                                       const SmallVector& joint_rad_s) const {
  return any_transfer<double>(joint_rad, joint_rad_s);
}

std::optional<TransferOf<dynamics::Jet>> Loop::transfer_with_slopes(
    const SmallVectorOf<dynamics::Jet>& joint_rad,
    const SmallVectorOf<dynamics::Jet>& joint_rad_s) const {
  return any_transfer<dynamics::Jet>(joint_rad, joint_rad_s);
}

std::optional<TransferOf<dynamics::Jet2>> Loop::transfer_with_curvatures(
    const SmallVectorOf<dynamics::Jet2>& joint_rad,
    const SmallVectorOf<dynamics::Jet2>& joint_rad_s) const {
  return any_transfer<dynamics::Jet2>(joint_rad, joint_rad_s);
}

std::vector<MechanismMargin> Loop::margins(const SmallVector& joint_rad) const {
  std::vector<MechanismMargin> margins;
  const auto followed = follow<double>(joint_rad, SmallVector::Zero(joint_rad.size()));
  if (!followed) return margins;
  for (Index i = geometry().joints; i < followed->position.size(); ++i) {
    const dynamics::Joint& joint = geometry().tree.bodies[static_cast<std::size_t>(i) + 1].joint;
    const double least = joint.limits.position_min, most = joint.limits.position_max;
    if (!std::isfinite(least) && !std::isfinite(most)) continue;
    const double at = followed->position[i];
    const bool is_low = at - least < most - at;
    margins.push_back({joint.name + "_range", at, is_low ? least : most,
                       is_low ? at - least : most - at,
                       joint.kind == dynamics::JointKind::kRevolute ? "rad" : "m"});
  }
  return margins;
}

template std::optional<TransferOf<double>> Loop::transfer_of_followed(
    const FollowedOf<double>&) const;
template std::optional<TransferOf<dynamics::Jet>> Loop::transfer_of_followed(
    const FollowedOf<dynamics::Jet>&) const;
template std::optional<TransferOf<dynamics::Jet2>> Loop::transfer_of_followed(
    const FollowedOf<dynamics::Jet2>&) const;

}  // namespace torquewright::hopper
