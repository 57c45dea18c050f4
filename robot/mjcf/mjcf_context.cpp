// SPDX-License-Identifier: Apache-2.0
#include "robot/mjcf/mjcf_context.hpp"

namespace torquewright::hopper {
namespace {

void gather(const Placed& around, const MjcfContext& context, std::vector<Placed>& out) {
  context.vocabulary.check(*around.element);
  for (const Element& held : around.element->children) {
    const Placed placed{&held, around.R, around.p_m, around.childclass};
    if (held.name != "frame") {
      out.push_back(placed);
      continue;
    }
    if (context.compiler.is_global) {
      context.faults.report(held, "stands in a file of global coordinates, which know no frames");
    }
    Placed inside = pose_of(placed, held, context);
    const std::string own = attribute(held, "childclass");
    if (!own.empty()) inside.childclass = own;
    gather(inside, context, out);
  }
}

/// The frame that a body's content is placed by, in the body: its own, or the world's.
Placed reference_of(const Element& body, const MjcfContext& context) {
  Placed frame{&body, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), ""};
  if (!context.compiler.is_global || body.name != "body") return frame;
  const Placed own = pose_of(frame, body, context);
  frame.R = own.R.transpose();
  frame.p_m = -(frame.R * own.p_m);
  return frame;
}

}  // namespace

Placed pose_of(const Placed& placed, const Element& completed, const MjcfContext& context) {
  Placed pose = placed;
  const Eigen::Vector3d own_m = context.faults.vector(completed, "pos", Eigen::Vector3d::Zero());
  pose.p_m = placed.p_m + placed.R * own_m;
  pose.R = placed.R * rotation_of(completed, context.compiler, context.faults);
  return pose;
}

std::vector<Placed> contents(const Element& body, const std::string& childclass,
                             const MjcfContext& context) {
  std::vector<Placed> out;
  const std::string own = attribute(body, "childclass");
  Placed around = reference_of(body, context);
  around.childclass = own.empty() ? childclass : own;
  gather(around, context, out);
  return out;
}

}  // namespace torquewright::hopper
