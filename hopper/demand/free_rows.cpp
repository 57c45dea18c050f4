// SPDX-License-Identifier: Apache-2.0
#include "hopper/demand/free_rows.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

}  // namespace

FreeRows::FreeRows(const WholeBody& body)
    : kind_(body.robot().tree.base), base_(body.robot().tree.base_velocity_size()) {
  std::vector<bool> is_driven(body.robot().tree.bodies.size(), false);
  for (const Drivetrain& drivetrain : body.robot().drivetrains) {
    for (const std::size_t joint : drivetrain.joints) is_driven[joint] = true;
  }
  for (std::size_t i = 1; i < is_driven.size(); ++i) {
    if (is_driven[i]) continue;
    const bool slides = body.robot().tree.bodies[i].joint.kind == dynamics::JointKind::kPrismatic;
    if (slides) slides_.push_back(size());
    passive_.push_back(base_ + static_cast<Index>(i) - 1);
  }
  turn_.setIdentity(base_, base_);
}

void FreeRows::set(const dynamics::TreeState& state, const Vector3d& center_of_mass_m) {
  const Vector3d arm_m = center_of_mass_m - state.base_origin_m();
  if (kind_ == BaseKind::kPlanar) {
    // About +y: the moment less that of the force at the base's origin.
    turn_(2, 0) = -arm_m.z();
    turn_(2, 1) = arm_m.x();
  } else if (kind_ == BaseKind::kSpatial) {
    turn_.block<3, 3>(3, 0) = -state.motion(0).R_WB.transpose() * cross_matrix(arm_m);
  }
}

void FreeRows::take(const Eigen::Ref<const Eigen::MatrixXd>& from,
                    Eigen::Ref<Eigen::MatrixXd> to) const {
  to.topRows(base_).noalias() = turn_ * from.topRows(base_);
  for (std::size_t i = 0; i < passive_.size(); ++i) {
    to.row(base_ + static_cast<Index>(i)) = from.row(passive_[i]);
  }
}

Eigen::VectorXd FreeRows::scales(double weight_N, double size_m) const {
  Eigen::VectorXd scales = Eigen::VectorXd::Constant(size(), weight_N * size_m);
  scales.head(kinds().forces).setConstant(weight_N);
  for (const Index row : slides_) scales[row] = weight_N;
  return scales;
}

RowKinds FreeRows::kinds() const {
  const auto passives = static_cast<Index>(passive_.size());
  if (kind_ == BaseKind::kFixed) return {0, 0, passives, slides_};
  return kind_ == BaseKind::kPlanar ? RowKinds{2, 1, passives, slides_}
                                    : RowKinds{3, 3, passives, slides_};
}

}  // namespace torquewright::hopper
