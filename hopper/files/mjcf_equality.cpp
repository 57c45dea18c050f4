// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "equality".
#include "hopper/files/mjcf_equality.hpp"

#include <fmt/format.h>

#include <set>

namespace torquewright::hopper {
namespace {

using Names = std::set<std::string>;

void gather_names(const Element& element, Names& names) {
  const std::string name = attribute(element, "name");
  if (!name.empty()) names.insert(name);
  for (const Element& held : element.children) gather_names(held, names);
}

/// A tendon runs where its parts are.
void add_tendons(const Element& mujoco, Names& names) {
  for (const Element* section : children(mujoco, "tendon")) {
    for (const Element& tendon : section->children) {
      for (const Element& part : tendon.children) {
        for (const char* key : {"joint", "site", "geom"}) {
          if (names.contains(attribute(part, key))) names.insert(attribute(tendon, "name"));
        }
      }
    }
  }
}

/// Also where it names nothing that could be elsewhere.
bool holds(const Element& equality, const Names& names) {
  bool names_none = true;
  for (const char* key : {"body1", "body2", "joint1", "joint2", "site1", "site2", "tendon1",
                          "tendon2", "geom1", "geom2"}) {
    const std::string name = attribute(equality, key);
    if (names.contains(name)) return true;
    names_none = names_none && name.empty();
  }
  return names_none;
}

std::string objection(const Element& equality) {
  const auto at = [&](const char* key) { return attribute(equality, key); };
  if (equality.name == "connect") {
    return fmt::format(
        "closes a loop between \"{}\" and \"{}\", which a tree does not: rods with "
        "mass are no part of our mechanisms. Leave it and the rods' bodies out, add "
        "their mass to their neighbours, and state a four_bar or parallel_ankle",
        at(at("body1").empty() ? "site1" : "body1"), at(at("body2").empty() ? "site2" : "body2"));
  }
  if (equality.name == "joint" || equality.name == "tendon") {
    const bool is_joint = equality.name == "joint";
    return fmt::format(
        "couples \"{}\" to \"{}\", which no mechanism of ours does; leave it out and "
        "it is free",
        at(is_joint ? "joint1" : "tendon1"), at(is_joint ? "joint2" : "tendon2"));
  }
  return "closes a loop or couples joints, which a tree does not; leave it out and state a "
         "mechanism";
}

}  // namespace

void refuse_equalities(const Element& mujoco, const Element& top, Faults& faults) {
  Names names;
  gather_names(top, names);
  add_tendons(mujoco, names);
  for (const Element* section : children(mujoco, "equality")) {
    for (const Element& stated : section->children) {
      if (attribute(stated, "active") == "false" || !holds(stated, names)) continue;
      faults.report(stated, objection(stated));
    }
  }
}

}  // namespace torquewright::hopper
