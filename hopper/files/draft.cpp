// SPDX-License-Identifier: Apache-2.0
#include "hopper/files/draft.hpp"

#include "dynamics/rigid_inertia.hpp"

namespace torquewright::hopper {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<DraftPlace> places_of(const std::vector<DraftBody>& draft) {
  std::vector<DraftPlace> places;
  std::size_t kept = 0;
  for (const DraftBody& next : draft) {
    if (places.empty()) {
      places.emplace_back();
      continue;
    }
    const DraftPlace& parent = places[next.body.parent];
    const dynamics::Joint& joint = next.body.joint;
    if (next.is_welded) {
      places.push_back({parent.kept, parent.R * joint.R_PB, parent.p_m + parent.R * joint.p_PB_m});
    } else {
      places.push_back({++kept, Matrix3d::Identity(), Vector3d::Zero()});
    }
  }
  return places;
}

std::vector<dynamics::Body> without_welds(const std::vector<DraftBody>& draft) {
  const std::vector<DraftPlace> places = places_of(draft);
  std::vector<dynamics::Body> bodies;
  for (std::size_t i = 0; i < draft.size(); ++i) {
    dynamics::Body body = draft[i].body;
    if (i == 0) {
      bodies.push_back(std::move(body));
      continue;
    }
    const DraftPlace& parent = places[body.parent];
    if (draft[i].is_welded) {
      dynamics::RigidInertia& whole = bodies[parent.kept].inertia;
      whole = dynamics::welded(whole, dynamics::moved(body.inertia, places[i].R, places[i].p_m));
      continue;
    }
    body.parent = parent.kept;
    body.joint.p_PB_m = parent.p_m + parent.R * body.joint.p_PB_m;
    body.joint.R_PB = parent.R * body.joint.R_PB;
    bodies.push_back(std::move(body));
  }
  return bodies;
}

}  // namespace torquewright::hopper
