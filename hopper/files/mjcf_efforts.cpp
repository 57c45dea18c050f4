// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "actuator".
#include "hopper/files/mjcf_efforts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hopper/files/mjcf_joint.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// The smaller of both directions.
double least_of(const Element& element, const char* range, const char* limited,
                const MjcfContext& context) {
  const auto found = context.faults.numbers(element, range, 2);
  if (!found || !is_limited(element, limited, context)) return kNone;
  return std::min(-found->front(), found->back());
}

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
  const double by_control = least_of(element, "ctrlrange", "ctrllimited", context);
  const double gain = gain_of(element, context);
  double force = least_of(element, "forcerange", "forcelimited", context);
  if (std::isfinite(gain) && std::isfinite(by_control)) force = std::min(force, gain * by_control);
  return gear * force;
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
  for (const Element* section : children(mujoco, "actuator")) {
    context.vocabulary.check(*section);
    for (const Element& stated : section->children) {
      const Element element = context.defaults.completed(stated, "");
      const std::string joint = joint_of(element);
      if (joint.empty()) {
        elsewhere.push_back(attribute(element, "name"));
        continue;
      }
      efforts.limit[joint] += effort_of(element, context);
    }
  }
  std::erase_if(efforts.limit, [](const auto& of_joint) {
    return !std::isfinite(of_joint.second) || !(of_joint.second > 0);
  });
  if (!elsewhere.empty()) {
    efforts.notes.push_back(
        fmt::format("actuators that pull on no single joint (tendons, sites, bodies) are not held: "
                    "{}",
                    fmt::join(elsewhere, ", ")));
  }
  return efforts;
}

}  // namespace torquewright::hopper
