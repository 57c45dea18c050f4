// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "contact/pair".
#include "robot/mjcf/mjcf_pairs.hpp"

#include <algorithm>

namespace torquewright::hopper {
namespace {

void set_attribute(Element& element, const std::string& name, const std::string& value) {
  const auto found = std::find_if(element.attributes.begin(), element.attributes.end(),
                                  [&](const auto& one) { return one.first == name; });
  if (found == element.attributes.end()) {
    element.attributes.emplace_back(name, value);
  } else {
    found->second = value;
  }
}

}  // namespace

MjcfPairs contact_pairs(const Element& mujoco) {
  MjcfPairs pairs;
  for (const Element* contact : children(mujoco, "contact")) {
    for (const Element* pair : children(*contact, "pair")) {
      for (const char* key : {"geom1", "geom2"}) {
        const std::string friction = attribute(*pair, "friction");
        std::string& stated = pairs[attribute(*pair, key)];
        if (stated.empty()) stated = friction.substr(0, friction.find(' '));
      }
    }
  }
  return pairs;
}

Element as_paired(const Element& geom, const MjcfPairs& pairs) {
  Element out = geom;
  const std::string name = attribute(geom, "name");
  const auto pair = name.empty() ? pairs.end() : pairs.find(name);
  if (pair == pairs.end()) return out;
  set_attribute(out, "contype", "1");
  if (!pair->second.empty()) set_attribute(out, "friction", pair->second);
  return out;
}

}  // namespace torquewright::hopper
