// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearbox/proof/tree/node.hpp"

namespace torquewright::gearbox::proof {
namespace {

/// Cuts one slab off, if it is refuted.
void apply_cut(Node& node, const Json& cut, const std::string& key) {
  ++node.account.counts.cuts;
  if (!cut.is_array() || cut.size() != 4) {
    node.fault(key, "is not [condition, variable, \"min\" or \"max\", value]");
    return;
  }
  if (node.box.is_empty()) {
    node.fault(key, "cuts a box of which nothing is left");
    return;
  }
  const auto condition = read_condition(node, key + "/0", &cut[0]);
  const auto variable = read_variable(node, key + "/1", &cut[1]);
  const auto side = text(&cut[2]);
  const auto value = whole_number(&cut[3]);
  if (side != "min" && side != "max") node.fault(key + "/2", "is neither min nor max");
  if (!condition || !variable || (side != "min" && side != "max")) return;

  const bool is_upper = side == "max";
  const std::int64_t least = node.box.lower[*variable];
  const std::int64_t most = node.box.upper[*variable];
  const bool cuts_some = value && (is_upper ? *value < most && *value >= least - 1
                                            : *value > least && *value <= most + 1);
  if (!cuts_some) {
    node.fault(key + "/3", fmt::format("is no cut of {} to {}", least, most));
    return;
  }
  Box slab = node.box;
  Box rest = node.box;
  if (is_upper) {
    rest.upper[*variable] = *value;
    slab.lower[*variable] = *value + 1;
  } else {
    rest.lower[*variable] = *value;
    slab.upper[*variable] = *value - 1;
  }
  if (!refutes(node.claim, node.alternative, *condition, slab, node.account.budget)) {
    node.fault(key, fmt::format("cuts off teeth that {} does not refute", *text(&cut[0])));
    return;
  }
  node.box = rest;
}

}  // namespace

std::string apply_cuts(Node& node, const Json& cuts) {
  if (!cuts.is_array() || cuts.empty()) {
    node.fault("/cuts", "is no list of cuts");
    return {};
  }
  const std::size_t faults_before = node.account.faults.count();
  for (std::size_t index = 0; index < cuts.size(); ++index) {
    apply_cut(node, cuts[index], fmt::format("/cuts/{}", index));
    if (node.account.faults.count() != faults_before) return {};
  }
  return *text(&cuts.back()[0]);
}

}  // namespace torquewright::gearbox::proof
