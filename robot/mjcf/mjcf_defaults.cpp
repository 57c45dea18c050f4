// SPDX-License-Identifier: Apache-2.0
#include "robot/mjcf/mjcf_defaults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace torquewright::hopper {

std::string kind_of_default(const std::string& element) {
  constexpr std::array kActuators{"motor",  "general",  "position", "velocity", "intvelocity",
                                  "damper", "cylinder", "muscle",   "adhesion"};
  if (element == "fixed" || element == "spatial") return "tendon";
  const bool drives = std::find(kActuators.begin(), kActuators.end(), element) != kActuators.end();
  return drives ? "actuator" : element;
}

MjcfDefaults::MjcfDefaults(const Element& mujoco, Faults& faults) : faults_(&faults) {
  for (const Element* element : children(mujoco, "default")) gather(*element, classes_[""], true);
}

void MjcfDefaults::gather(const Element& element, Kinds inherited, bool is_main) {
  for (const Element& next : element.children) {
    if (next.name == "default") continue;
    Attributes& attributes = inherited[kind_of_default(next.name)];
    for (const auto& [name, value] : next.attributes) attributes[name] = value;
  }
  if (is_main) classes_["main"] = classes_[""] = inherited;
  const std::string name = attribute(element, "class");
  if (!is_main && classes_.count(name) > 0 && !name.empty()) {
    faults_->report(element, fmt::format("the default class \"{}\" stands twice; one of them would "
                                         "not count: put them together, or name one differently",
                                         name));
  }
  if (!name.empty()) classes_[name] = inherited;
  if (name.empty() && !is_main) faults_->report(element, "class is missing");
  for (const Element* nested : children(element, "default")) gather(*nested, inherited, false);
}

Element MjcfDefaults::completed(const Element& element, const std::string& childclass) const {
  Element copy{element.name, element.attributes, {}, element.file, element.line};
  // <freejoint> is there to have no defaults.
  if (element.name == "freejoint") return copy;
  const std::string own = attribute(element, "class");
  const std::string& name = own.empty() ? childclass : own;
  const auto found = classes_.find(name);
  if (found == classes_.end()) {
    if (!name.empty()) faults_->report(element, fmt::format("no default has class \"{}\"", name));
    return copy;
  }
  const auto attributes = found->second.find(kind_of_default(element.name));
  if (attributes == found->second.end()) return copy;
  for (const auto& [key, value] : attributes->second) {
    if (find_attribute(copy, key) == nullptr) copy.attributes.emplace_back(key, value);
  }
  return copy;
}

}  // namespace torquewright::hopper
