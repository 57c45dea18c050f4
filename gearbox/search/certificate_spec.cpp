// SPDX-License-Identifier: Apache-2.0
#include "gearbox/search/certificate_spec.hpp"

#include <nlohmann/json.hpp>
#include <optional>

namespace torquewright::gearbox {
namespace {

using nlohmann::ordered_json;
using optimization::Leaf;
using optimization::ProofNode;

std::string condition_name(const AlternativeProof& proof, std::size_t condition) {
  return condition == optimization::kQuantity ? "quantity" : proof.conditions.at(condition);
}

ordered_json cuts_json(const AlternativeProof& proof, const ProofNode& node) {
  ordered_json cuts = ordered_json::array();
  for (const optimization::Cut& cut : node.cuts) {
    cuts.push_back({condition_name(proof, cut.condition), proof.variables[cut.variable],
                    cut.is_lower ? "min" : "max", cut.value});
  }
  return cuts;
}

void close(const AlternativeProof& proof, const ProofNode& node, ordered_json& result) {
  switch (node.leaf) {
    case Leaf::kOpen:
      result["closed"] = "open";
      return;
    case Leaf::kSplit:
      result["split"] = {proof.variables[node.split_variable], node.split_value};
      return;
    case Leaf::kEmpty:
      result["closed"] = "empty";
      result["by"] = condition_name(proof, node.condition);
      return;
    case Leaf::kEnumerated:
      result["closed"] = "enumerated";
      return;
    case Leaf::kRelaxation:
      result["closed"] = "relaxation";
      for (std::size_t i = 0; i < node.point.size(); ++i) {
        result["point"][proof.variables[i]] = node.point[i];
      }
      for (const optimization::Multiplier& multiplier : node.multipliers) {
        result["multipliers"][condition_name(proof, multiplier.condition)] = multiplier.value;
      }
      return;
  }
}

// In preorder: the children of a node that splits follow it, the first with all that is below it.
ordered_json nodes_json(const AlternativeProof& proof) {
  ordered_json nodes = ordered_json::array();
  std::vector<std::size_t> next;
  if (!proof.tree.empty()) next.push_back(0);
  while (!next.empty()) {
    const ProofNode& node = proof.tree[next.back()];
    next.pop_back();
    ordered_json result = ordered_json::object();
    if (!node.cuts.empty()) result["cuts"] = cuts_json(proof, node);
    close(proof, node, result);
    nodes.push_back(std::move(result));
    if (node.leaf == Leaf::kSplit) {
      next.push_back(node.children[1]);
      next.push_back(node.children[0]);
    }
  }
  return nodes;
}

ordered_json claim_json(const Topology& topology, const Claim& claim) {
  ordered_json result;
  result["kind"] = claim.kind;
  result["constraints"] = claim.constraints;
  result["quantity"] = claim.quantity.empty() ? ordered_json() : ordered_json(claim.quantity);
  result["reference"] = claim.reference ? design_json(topology, *claim.reference) : ordered_json();
  if (!claim.key.empty()) result["key"] = claim.key;
  result["ring_limit"] = claim.ring_limit ? ordered_json(*claim.ring_limit) : ordered_json();
  result["alternatives"] = ordered_json::array();
  for (const AlternativeProof& proof : claim.alternatives) {
    result["alternatives"].push_back({{"planet_count", proof.planet_count},
                                      {"module_mm", io::nearest(proof.module_mm)},
                                      {"nodes", nodes_json(proof)}});
  }
  return result;
}

}  // namespace

ordered_json design_json(const Topology& topology, const Design& design) {
  ordered_json teeth;
  for (std::size_t i = 0; i < topology.gears.size(); ++i) {
    teeth[std::string(topology.gears[i])] = design.teeth[i];
  }
  return {{"teeth", teeth},
          {"planet_count", design.planet_count},
          {"module_mm", io::nearest(design.module_mm)}};
}

ordered_json certificate_json(const Topology& topology, const std::vector<Claim>& claims) {
  ordered_json result{{"version", 1}, {"claims", ordered_json::array()}};
  for (const Claim& claim : claims) result["claims"].push_back(claim_json(topology, claim));
  return result;
}

}  // namespace torquewright::gearbox
