// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearbox/proof/tree/account.hpp"

namespace torquewright::gearbox::proof {

/// One node of a proof tree on its way through the checks: the box shrinks with every cut.
struct Node {
  const Claim& claim;
  const Alternative& alternative;
  Box box;
  std::string place;
  Account& account;

  void fault(const std::string& key, const std::string& sentence) const {
    account.faults.add(place + key, sentence);
  }
};

/// Checks cuts and closing or split; returns the children's boxes, the second child first.
std::vector<Box> check_node(Node& node, const Json& json);

/// Applies the cuts to the node's box. Returns the condition of the last one, empty if there is
/// none; after a fault the box is as the last valid cut left it.
std::string apply_cuts(Node& node, const Json& cuts);

/// The condition of that name; a fault and empty if the claim has none that is judged on boxes.
std::optional<Condition> read_condition(const Node& node, const std::string& key, const Json* name);

/// Index of a variable; a fault and empty if there is none of that name.
std::optional<std::size_t> read_variable(const Node& node, const std::string& key,
                                         const Json* name);

void check_relaxation_leaf(const Node& node, const Json& json);

}  // namespace torquewright::gearbox::proof
