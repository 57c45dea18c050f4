// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robot/model/tree_order.hpp"
#include "robot/xml/xml.hpp"

namespace torquewright::hopper {

/// Links and joints of a URDF file as a tree.
struct UrdfTree {
  std::vector<const Element*> links;
  std::vector<std::string> names;  ///< Of the links.
  std::vector<Ends> ends;
  std::map<std::string, const Element*> joints;  ///< By name.
  std::vector<Place> order;                      ///< The root first.
  bool floats = true;                            ///< Whether the root does.
  bool is_said_to_float = false;                 ///< By a joint of that type.
};

/// Throws io::SpecError where they are none. A root without mass whose only joint is a floating one
/// is left out.
UrdfTree read_urdf_tree(const Element& robot, Faults& faults);

}  // namespace torquewright::hopper
