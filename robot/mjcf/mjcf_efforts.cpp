// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "actuator".
#include "robot/mjcf/mjcf_efforts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "robot/mjcf/mjcf_joint.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// Force over control, where it is a constant and nothing stands between.
double gain_of(const Element& element, const MjcfContext& context) {
  if (element.name == "motor") return 1;
  const auto plain = [&](const char* name, const char* wanted) {
    const std::string found = attribute(element, name);
    return found.empty() || found == wanted;
  };
  const bool is_plain = element.name == "general" && plain("dyntype", "none") &&
                        plain("gaintype", "fixed") && plain("biastype", "none");
  if (!is_plain) return kNone;
  const auto gains = context.faults.numbers(element, "gainprm", 1, 10);
  return gains ? std::abs(gains->front()) : 1;
}

double effort_of(const Element& element, const MjcfContext& context) {
  const auto gears = context.faults.numbers(element, "gear", 1, 6);
  const double gear = gears ? std::abs(gears->front()) : 1;
  if (gear == 0) context.faults.report(element, "a gear of 0 drives nothing");
  const double gain = gain_of(element, context);
  double force = force_either_way(element, "forcerange", "forcelimited", context);
  if (!std::isfinite(gain)) return gear * force;
  if (gain == 0) context.faults.report(element, "a gain of 0 drives nothing");
  const double by_control = force_either_way(element, "ctrlrange", "ctrllimited", context);
  if (std::isfinite(by_control)) force = std::min(force, gain * by_control);
  return gear * force;
}

void gather_joints(const Element& element, std::set<std::string>& names) {
  for (const Element& held : element.children) {
    if (held.name == "joint" || held.name == "freejoint") names.insert(attribute(held, "name"));
    gather_joints(held, names);
  }
}

/// Names of all joints of all bodies of the world.
std::set<std::string> joints_of_world(const Element& mujoco) {
  std::set<std::string> names;
  for (const Element* world : children(mujoco, "worldbody")) gather_joints(*world, names);
  return names;
}

/// Words of defaults of actuators. All kinds share one default, so that what one of them takes from
/// it may be no word of its own.
void check_defaults(const Element& element, const MjcfContext& context) {
  for (const Element& held : element.children) {
    if (kind_of_default(held.name) == "actuator") context.vocabulary.check_attributes(held);
    if (held.name == "default") check_defaults(held, context);
  }
}

std::string name_of(const Element& actuator) {
  const std::string name = attribute(actuator, "name");
  return name.empty() ? fmt::format("<{}> of line {}", actuator.name, actuator.line) : name;
}

std::string joint_of(const Element& actuator) {
  const std::string joint = attribute(actuator, "joint");
  return joint.empty() ? attribute(actuator, "jointinparent") : joint;
}

}  // namespace

std::map<std::string, std::string> driven_joints(const Element& mujoco,
                                                 const MjcfContext& context) {
  std::map<std::string, std::string> driven;
  for (const Element* section : children(mujoco, "actuator")) {
    for (const Element& stated : section->children) {
      const Element element = context.defaults.completed(stated, "");
      const std::string joint = joint_of(element);
      if (!joint.empty()) driven[joint] = attribute(element, "name");
    }
  }
  return driven;
}

MjcfEfforts read_efforts(const Element& mujoco, const MjcfContext& context) {
  MjcfEfforts efforts;
  std::vector<std::string> elsewhere;
  const std::set<std::string> joints = joints_of_world(mujoco);
  check_defaults(mujoco, context);
  for (const Element* section : children(mujoco, "actuator")) {
    context.vocabulary.check(*section);
    for (const Element& stated : section->children) {
      const Element element = context.defaults.completed(stated, "");
      context.vocabulary.check_attributes(stated);
      const std::string joint = joint_of(element);
      if (joint.empty()) {
        elsewhere.push_back(name_of(element));
        continue;
      }
      if (joints.count(joint) == 0) {
        context.faults.report(element, fmt::format("no body has a joint \"{}\"", joint));
        continue;
      }
      efforts.limit[joint] += effort_of(element, context);
    }
  }
  std::erase_if(efforts.limit,
                [](const auto& of_joint) { return !std::isfinite(of_joint.second); });
  if (!elsewhere.empty()) {
    efforts.notes.push_back(
        fmt::format("actuators that pull on no single joint (tendons, sites, bodies) are not held: "
                    "{}",
                    fmt::join(elsewhere, ", ")));
  }
  return efforts;
}

}  // namespace torquewright::hopper
