// SPDX-License-Identifier: Apache-2.0
#include "hopper/files/draft.hpp"

#include "dynamics/rigid_inertia.hpp"

namespace torquewright::hopper {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<dynamics::Body> without_welds(const std::vector<DraftBody>& draft) {
  // Where each drafted body's frame stands in the kept body that it is part of.
  struct Placed {
    std::size_t kept;
    Matrix3d R;
    Vector3d p_m;
  };
  std::vector<Placed> placed;
  std::vector<dynamics::Body> bodies;
  for (const DraftBody& next : draft) {
    dynamics::Body body = next.body;
    if (placed.empty()) {
      placed.push_back({0, Matrix3d::Identity(), Vector3d::Zero()});
      bodies.push_back(std::move(body));
      continue;
    }
    const Placed parent = placed[next.body.parent];
    const Matrix3d R = parent.R * body.joint.R_PB;
    const Vector3d p_m = parent.p_m + parent.R * body.joint.p_PB_m;
    if (next.is_welded) {
      dynamics::RigidInertia& whole = bodies[parent.kept].inertia;
      whole = dynamics::welded(whole, dynamics::moved(body.inertia, R, p_m));
      placed.push_back({parent.kept, R, p_m});
      continue;
    }
    body.parent = parent.kept;
    body.joint.R_PB = R;
    body.joint.p_PB_m = p_m;
    placed.push_back({bodies.size(), Matrix3d::Identity(), Vector3d::Zero()});
    bodies.push_back(std::move(body));
  }
  return bodies;
}

}  // namespace torquewright::hopper
