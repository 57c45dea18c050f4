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
    Placed inside = pose_of(placed, held, context);
    const std::string own = attribute(held, "childclass");
    if (!own.empty()) inside.childclass = own;
    gather(inside, context, out);
  }
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
  Placed around{&body, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(),
                own.empty() ? childclass : own};
  gather(around, context, out);
  return out;
}

}  // namespace torquewright::hopper
