// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/tree/tree.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearbox/proof/tree/node.hpp"

namespace torquewright::gearbox::proof {

void check_tree(const Claim& claim, const Alternative& alternative, const Json& nodes,
                const std::string& place, Account& account) {
  const std::size_t faults_before = account.faults.count();
  if (!nodes.is_array()) {
    account.faults.add(place, "is no list of nodes");
    return;
  }
  if (largest_ring_teeth(alternative) > kMostTeeth) {
    account.faults.add(place,
                       fmt::format("rings of more than {} teeth are not judged", kMostTeeth));
    return;
  }
  // Boxes that still need a node, the next one last. A preorder needs no recursion.
  std::vector<Box> pending;
  const Box root = root_box(alternative);
  if (!root.is_empty()) pending.push_back(root);
  for (std::size_t index = 0; index < nodes.size(); ++index) {
    ask_whether_to_stop(account);
    const std::string node_place = fmt::format("{}/{}", place, index);
    if (pending.empty()) {
      account.faults.add(node_place, "is one node more than the boxes call for");
      return;
    }
    Node node{claim, alternative, pending.back(), node_place, account};
    pending.pop_back();
    for (const Box& child : check_node(node, nodes[index])) pending.push_back(child);
    if (account.faults.count() != faults_before) return;
  }
  if (!pending.empty()) {
    account.faults.add(place, fmt::format("{} boxes have no node", pending.size()));
  }
}

}  // namespace torquewright::gearbox::proof
