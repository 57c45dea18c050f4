// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/linkage_mass.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "dynamics/rigid_inertia.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::RigidInertia;
using Eigen::Matrix3d;
using Eigen::Vector3d;

RigidInertia point_mass(double mass_kg, const Vector3d& place_m) {
  return {mass_kg, place_m, Matrix3d::Zero()};
}

void add(const RigidInertia& inertia, RigidInertia& body) {
  if (inertia.mass_kg > 0) body = dynamics::welded(body, inertia);
}

/// All of the rod's hinges as one body, in the rod's frame, as the file puts them.
RigidInertia whole_rod(const RodLoop& loop, const LoopFollower& file_posture,
                       const std::vector<DraftBody>& draft) {
  const std::size_t rod = loop.rod.back();
  RigidInertia whole;
  for (const std::size_t part : loop.rod) {
    const Vector3d origin_m = file_posture.seen_from({part, Vector3d::Zero()}, rod);
    Matrix3d R;
    for (Eigen::Index k = 0; k < 3; ++k) {
      R.col(k) = file_posture.seen_from({part, Vector3d::Unit(k)}, rod) - origin_m;
    }
    add(dynamics::moved(draft[part].body.inertia, R, origin_m), whole);
  }
  return whole;
}

/// About a point of it, averaged over all turns about an axis through that point.
RigidInertia spun(const RigidInertia& body, const Vector3d& axis) {
  const double along_m = axis.dot(body.center_of_mass_m);
  const Vector3d out_m = body.center_of_mass_m - along_m * axis;
  const Matrix3d about =
      body.inertia_kg_m2 +
      body.mass_kg * (out_m.squaredNorm() * Matrix3d::Identity() - out_m * out_m.transpose());
  const double axial_kg_m2 = axis.dot(about * axis);
  const double across_kg_m2 = (about.trace() - axial_kg_m2) / 2;
  const Matrix3d axial = axis * axis.transpose();
  return {body.mass_kg, along_m * axis,
          across_kg_m2 * (Matrix3d::Identity() - axial) + axial_kg_m2 * axial};
}

}  // namespace

double lump_links(const RodLoop& loop, const LoopFollower& file_posture,
                  std::vector<DraftBody>& draft) {
  const RigidInertia rod = whole_rod(loop, file_posture, draft);
  const double far_share =
      std::clamp(rod.center_of_mass_m.dot(loop.rod_m) / loop.rod_m.squaredNorm(), 0.0, 1.0);
  const double crank_share = loop.hangs_on_crank ? 1 - far_share : far_share;
  dynamics::Body& crank = draft[loop.crank].body;
  RigidInertia turning = crank.inertia;
  add(point_mass(crank_share * rod.mass_kg, loop.crank_pin_m), turning);
  add(point_mass((1 - crank_share) * rod.mass_kg, loop.held_pin_m),
      draft[loop.held.back()].body.inertia);
  const RigidInertia as_seen = spun(turning, crank.joint.axis);
  add(dynamics::moved(as_seen, crank.joint.R_PB, crank.joint.p_PB_m),
      draft[loop.ground].body.inertia);
  return crank.joint.axis.dot(as_seen.inertia_kg_m2 * crank.joint.axis);
}

double share_off(const Eigen::MatrixXd& found, const Eigen::MatrixXd& exact) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> motions(found - exact, exact,
                                                                          Eigen::EigenvaluesOnly);
  return motions.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace torquewright::hopper
