// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "equality".
#include "robot/mjcf/mjcf_equality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

/// What an equality may hold.
constexpr std::array kHeld{"body1", "body2", "joint1", "joint2",  "site1",
                           "site2", "geom1", "geom2",  "tendon1", "tendon2"};

/// Also where it names nothing that could be elsewhere.
bool holds(const Element& equality, const Names& names) {
  bool names_none = true;
  for (const char* key : kHeld) {
    const std::string name = attribute(equality, key);
    if (names.contains(name)) return true;
    names_none = names_none && name.empty();
  }
  return names_none;
}

/// By its own name, or that of what it holds.
bool is_called(const Element& equality, const std::string& name) {
  if (attribute(equality, "name") == name) return true;
  return std::any_of(kHeld.begin(), kHeld.end(),
                     [&](const char* key) { return attribute(equality, key) == name; });
}

bool is_coupling(const Element& equality) {
  return equality.name == "joint" || equality.name == "tendon";
}

std::string coupling_of(const Element& equality) {
  const std::string one = attribute(equality, equality.name + "1");
  const std::string other = attribute(equality, equality.name + "2");
  return other.empty() ? fmt::format("holds \"{}\"", one)
                       : fmt::format("couples \"{}\" to \"{}\"", one, other);
}

/// All kinds of equalities share the defaults of <equality>.
bool is_active(const Element& stated, const MjcfDefaults& defaults) {
  const Element asked{"equality", stated.attributes, {}, stated.file, stated.line};
  return attribute(defaults.completed(asked, ""), "active") != "false";
}

std::string objection(const Element& equality) {
  if (is_coupling(equality)) {
    return fmt::format("{}, which no mechanism of ours does; --free-couplings leaves it out",
                       coupling_of(equality));
  }
  return "closes a loop or couples joints, which a tree does not; --open-loop NAME leaves it out, "
         "by "
         "its name or that of what it holds";
}

}  // namespace

Equalities read_equalities(const Element& mujoco, const Element& top, const MjcfDefaults& defaults,
                           ImportFileOptions& options, Faults& faults) {
  Names names;
  gather_names(top, names);
  add_tendons(mujoco, names);
  Equalities read;
  Names opened;
  const auto is_opened = [&](const Element& equality) {
    const auto& asked = options.opened_loops;
    const auto named = std::find_if(asked.begin(), asked.end(), [&](const std::string& name) {
      return is_called(equality, name);
    });
    if (named != asked.end()) opened.insert(*named);
    return named != asked.end();
  };
  for (const Element* section : children(mujoco, "equality")) {
    for (const Element& stated : section->children) {
      if (!is_active(stated, defaults) || !holds(stated, names)) continue;
      if (stated.name == "connect") {
        read.connects.push_back(&stated);
      } else if (options.frees_couplings && is_coupling(stated)) {
        read.freed.push_back(fmt::format("an equality that {} is left out", coupling_of(stated)));
      } else if (!is_coupling(stated) && is_opened(stated)) {
        read.freed.push_back(
            fmt::format("line {}: <{}> is left out (--open-loop)", stated.line, stated.name));
      } else {
        faults.report(stated, objection(stated));
      }
    }
  }
  std::erase_if(options.opened_loops, [&](const std::string& name) {
    return opened.contains(name) &&
           std::none_of(read.connects.begin(), read.connects.end(),
                        [&](const Element* connect) { return is_called(*connect, name); });
  });
  return read;
}

}  // namespace torquewright::hopper
