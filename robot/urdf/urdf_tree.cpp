// SPDX-License-Identifier: Apache-2.0
#include "robot/urdf/urdf_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "robot/find_name.hpp"

namespace torquewright::hopper {
namespace {

/// Index of a link by its name; the first of two that are called alike.
using Links = std::unordered_map<std::string, std::size_t>;

Links links_by_name(const UrdfTree& tree) {
  Links links;
  for (std::size_t i = 0; i < tree.names.size(); ++i) links.emplace(tree.names[i], i);
  return links;
}

std::optional<std::size_t> read_end(const UrdfTree& tree, const Links& links, const Element& joint,
                                    const char* which, Faults& faults) {
  const Element* element = faults.only_child(joint, which);
  const std::string wanted = element == nullptr ? "" : attribute(*element, "link");
  if (const auto known = links.find(wanted); known != links.end()) return known->second;
  std::vector<io::Fault> found;
  const auto link = find_name(tree.names, wanted, "link", {"", "", ""}, found);
  if (!link) faults.report(joint, found.back().message);
  return link;
}

void read_ends(const Element& robot, UrdfTree& tree, Faults& faults) {
  const Links links = links_by_name(tree);
  for (const Element* joint : children(robot, "joint")) {
    const std::string name = faults.needed(*joint, "name");
    const auto parent = read_end(tree, links, *joint, "parent", faults);
    const auto child = read_end(tree, links, *joint, "child", faults);
    if (parent && child) tree.ends.push_back({name, "", *parent, *child});
    if (!tree.joints.emplace(name, joint).second) faults.report(*joint, "its name stands twice");
  }
  faults.refuse();
}

/// That no joint carries; the first of several, the others are faults of the tree.
std::size_t root_link(const Element& robot, const UrdfTree& tree, Faults& faults) {
  std::vector<bool> is_carried(tree.links.size(), false);
  for (const Ends& ends : tree.ends) is_carried[ends.child] = true;
  const auto root = std::find(is_carried.begin(), is_carried.end(), false);
  if (root != is_carried.end()) return static_cast<std::size_t>(root - is_carried.begin());
  faults.report(robot, "every link is carried by a joint: a closed loop is no tree");
  faults.refuse();
  return 0;
}

/// The link that floats by its own joint, in place of a root that is nothing but the world; the
/// root itself where there is none.
std::size_t without_world(std::size_t root, UrdfTree& tree) {
  const auto carries = [&](const Ends& ends) { return ends.parent == root; };
  const auto first = std::find_if(tree.ends.begin(), tree.ends.end(), carries);
  const bool is_only =
      first != tree.ends.end() && std::count_if(tree.ends.begin(), tree.ends.end(), carries) == 1;
  const bool floats = is_only && attribute(*tree.joints[first->joint], "type") == "floating";
  if (!floats || child(*tree.links[root], "inertial") != nullptr) return root;
  const std::size_t base = first->child;
  tree.ends.erase(first);
  return base;
}

/// The root of a file without it is not in the tree.
void drop_link(std::size_t link, UrdfTree& tree) {
  tree.links.erase(tree.links.begin() + static_cast<std::ptrdiff_t>(link));
  tree.names.erase(tree.names.begin() + static_cast<std::ptrdiff_t>(link));
  for (Ends& ends : tree.ends) {
    if (ends.parent > link) --ends.parent;
    if (ends.child > link) --ends.child;
  }
}

}  // namespace

UrdfTree read_urdf_tree(const Element& robot, Faults& faults) {
  UrdfTree tree;
  tree.links = children(robot, "link");
  for (const Element* link : tree.links) tree.names.push_back(faults.needed(*link, "name"));
  if (tree.links.empty()) faults.report(robot, "holds no link");
  faults.refuse();
  read_ends(robot, tree, faults);
  const std::size_t root = root_link(robot, tree, faults);
  std::size_t base = without_world(root, tree);
  tree.floats = base != root || tree.names[root] != "world";
  tree.is_said_to_float = base != root;
  if (base != root) {
    drop_link(root, tree);
    if (base > root) --base;
  }
  std::vector<io::Fault> found;
  tree.order = tree_order(tree.names, base, tree.ends, *robot.file, found);
  if (!found.empty()) throw io::SpecError(found);
  return tree;
}

}  // namespace torquewright::hopper
