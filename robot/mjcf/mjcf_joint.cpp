// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "joint", "freejoint".
#include "robot/mjcf/mjcf_joint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::hopper {
namespace {

using dynamics::JointKind;
using Eigen::Vector3d;

void read_range(const Element& element, double unit, const MjcfContext& context,
                dynamics::JointLimits& limits) {
  const auto range = context.faults.numbers(element, "range", 2);
  if (!range || !is_limited(element, "limited", context)) return;
  // What is not said to hold and leaves nothing is MuJoCo's own default: no range.
  const bool is_default = range->front() == 0 && range->back() == 0;
  if (is_default && attribute(element, "limited") != "true") return;
  if (!(range->front() < range->back())) {
    context.faults.report(element, "the range's first number is not below its second");
    return;
  }
  limits.position_min = unit * range->front();
  limits.position_max = unit * range->back();
}

void read_axis(const Element& element, const Placed& placed, const MjcfContext& context,
               MjcfJoint& read) {
  const Vector3d axis = context.faults.vector(element, "axis", Vector3d::UnitZ());
  if (axis.norm() < 1e-6) {
    context.faults.report(element, "the axis has no direction");
  } else {
    read.joint.axis = (placed.R * axis).normalized();
  }
  read.place_m = placed.p_m + placed.R * context.faults.vector(element, "pos", Vector3d::Zero());
}

}  // namespace

bool is_limited(const Element& element, const char* limited, const MjcfContext& context) {
  const std::string stated = context.faults.one_of(element, limited, {"auto", "true", "false"});
  if (stated == "auto" && !context.compiler.are_limits_automatic) {
    context.faults.report(element, fmt::format("has a range and does not say whether it holds, "
                                               "which autolimits=\"false\" asks for: state {}",
                                               limited));
  }
  return stated != "false";
}

double force_either_way(const Element& element, const char* range, const char* limited,
                        const MjcfContext& context) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const auto found = context.faults.numbers(element, range, 2);
  if (!found || !is_limited(element, limited, context)) return kNone;
  const double least = found->front();
  const double greatest = found->back();
  // MuJoCo's default, which says that there is none.
  if (least == 0 && greatest == 0 && attribute(element, limited) != "true") return kNone;
  const std::string stated = fmt::format("{}=\"{}\"", range, attribute(element, range));
  if (!(least < greatest)) {
    context.faults.report(element, stated + ": the first number is not below the second");
    return kNone;
  }
  if (least < 0 && greatest > 0) return std::min(-least, greatest);
  context.faults.report(
      element, stated +
                   " pushes one way only, and a robot document's limit holds both ways; state "
                   "what it may push either way, or leave the range out");
  return kNone;
}

namespace {

/// Of a hinge or a slide.
dynamics::PassiveForces read_passive(const Element& element, double unit, Faults& faults) {
  dynamics::PassiveForces passive;
  passive.damping = faults.number(element, "damping", 0);
  passive.dry_friction = faults.number(element, "frictionloss", 0);
  passive.stiffness = faults.number(element, "stiffness", 0);
  if (passive.stiffness != 0) passive.rest_position = unit * faults.number(element, "springref", 0);
  for (const char* key : {"damping", "frictionloss", "stiffness"}) {
    if (faults.number(element, key, 0) < 0) {
      faults.report(element, fmt::format("{}=\"{}\" is negative and would drive the joint", key,
                                         attribute(element, key)));
    }
  }
  return passive;
}

}  // namespace

MjcfJoint read_mjcf_joint(const Placed& placed, const MjcfContext& context) {
  const Element element = context.defaults.completed(*placed.element, placed.childclass);
  Faults& faults = context.faults;
  context.vocabulary.check(element);
  const std::string type = attribute(element, "type");
  MjcfJoint read;
  read.element = placed.element;
  read.joint.name = attribute(element, "name");
  read.is_free = element.name == "freejoint" || type == "free";
  read.states_armature = find_attribute(element, "armature") != nullptr;
  read.joint.reflected_inertia = faults.number(element, "armature", 0);
  if (read.joint.reflected_inertia < 0) faults.report(element, "the armature is negative");
  if (read.is_free) return read;
  read.is_ball = type == "ball";
  if (!type.empty() && type != "hinge" && type != "slide" && !read.is_ball) {
    faults.report(element, fmt::format("type \"{}\" must be hinge or slide here", type));
  }
  const bool turns = type != "slide";
  read.joint.kind = turns ? JointKind::kRevolute : JointKind::kPrismatic;
  const double unit = turns ? context.compiler.rad_per_angle : 1;
  read.joint.passive = read_passive(element, read.is_ball ? 1 : unit, faults);
  if (!read.is_ball) read.reference = unit * faults.number(element, "ref", 0);
  read_axis(element, placed, context, read);
  if (!read.is_ball) read_range(element, unit, context, read.joint.limits);
  read.joint.limits.effort_max =
      force_either_way(element, "actuatorfrcrange", "actuatorfrclimited", context);
  return read;
}

void refuse_ball(const Element& joint, Faults& faults) {
  faults.report(
      joint,
      "type \"ball\" must be hinge or slide where it has a range or an armature, or beside "
      "a closed loop; three hinges in one body turn like a ball");
}

std::vector<MjcfJoint> hinges_of_ball(const MjcfJoint& ball) {
  std::vector<MjcfJoint> hinges(3, ball);
  for (Eigen::Index k = 0; k < 3; ++k) {
    dynamics::Joint& joint = hinges[static_cast<std::size_t>(k)].joint;
    joint.axis = Vector3d::Unit(k);
    joint.passive = {};
    if (k > 0) joint.name += k == 1 ? ".y" : ".z";
  }
  return hinges;
}

}  // namespace torquewright::hopper
