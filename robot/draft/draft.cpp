// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/draft.hpp"

#include "dynamics/rigid_inertia.hpp"

namespace torquewright::hopper {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Merged merged(const std::vector<DraftBody>& draft) {
  Merged out;
  for (DraftBody next : draft) {
    if (out.places.empty()) {
      out.places.push_back({});
      out.draft.push_back(std::move(next));
      continue;
    }
    const DraftPlace parent = out.places[next.body.parent];
    const Matrix3d R = parent.R * next.body.joint.R_PB;
    const Vector3d p_m = parent.p_m + parent.R * next.body.joint.p_PB_m;
    if (next.is_welded) {
      dynamics::RigidInertia& whole = out.draft[parent.draft].body.inertia;
      whole = dynamics::welded(whole, dynamics::moved(next.body.inertia, R, p_m));
      for (DraftShape& shape : next.shapes) {
        shape.p_m = p_m + R * shape.p_m;
        shape.R = R * shape.R;
        out.draft[parent.draft].shapes.push_back(std::move(shape));
      }
      std::vector<DraftMark>& marks = out.draft[parent.draft].marks;
      marks.push_back({next.body.name, R, p_m});
      for (const DraftMark& mark : next.marks) {
        marks.push_back({mark.name, R * mark.R, p_m + R * mark.p_m});
      }
      out.places.push_back({parent.draft, R, p_m});
      continue;
    }
    next.body.parent = parent.draft;
    next.body.joint.R_PB = R;
    next.body.joint.p_PB_m = p_m;
    out.places.push_back({out.draft.size(), Matrix3d::Identity(), Vector3d::Zero()});
    out.draft.push_back(std::move(next));
  }
  return out;
}

}  // namespace torquewright::hopper
