// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearbox/proof/relaxation/relaxation.hpp"
#include "gearbox/proof/tree/node.hpp"

namespace torquewright::gearbox::proof {
namespace {

/// A point with exactly the problem's variables, inside the box.
std::optional<RealPoint> read_point(const Node& node, const Json* json) {
  const auto& names = node.alternative.train->variables;
  if (json == nullptr || !json->is_object() || json->size() != names.size()) {
    node.fault("/point", "is no point with exactly the variables of this problem");
    return std::nullopt;
  }
  RealPoint point;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto value = decimal(member(*json, names[i]));
    if (!value || *value < static_cast<long>(node.box.lower[i]) ||
        *value > static_cast<long>(node.box.upper[i])) {
      node.fault("/point/" + names[i], "is no number within the box");
      return std::nullopt;
    }
    point[i] = *value;
  }
  return point;
}

std::optional<Linearization> weighted_form(const Node& node, const RealPoint& point,
                                           const std::string& name, const Json& multiplier) {
  const std::string key = "/multipliers/" + pointer_part(name);
  const auto weight = decimal(&multiplier);
  if (!weight || *weight < 0) {
    node.fault(key, "is no finite number of at least zero");
    return std::nullopt;
  }
  const Json named = name;
  const auto condition = read_condition(node, key, &named);
  if (!condition) return std::nullopt;
  auto form = linearize(node.claim, node.alternative, *condition, node.box, point);
  if (!form) {
    node.fault(key, "belongs to a condition without a concave form here");
    return std::nullopt;
  }
  form->scale(Interval(*weight));
  return form;
}

}  // namespace

void check_relaxation_leaf(const Node& node, const Json& json) {
  ++node.account.counts.relaxation_leaves;
  check_keys(json, {"cuts", "closed", "point", "multipliers"}, node.place, node.account.faults);
  const auto point = read_point(node, member(json, "point"));
  if (!point) return;
  const Json* multipliers = member(json, "multipliers");
  if (multipliers == nullptr || !multipliers->is_object()) {
    node.fault("/multipliers", "is no object");
    return;
  }
  Linearization sum{0, {0, 0, 0}};
  for (const auto& [name, multiplier] : multipliers->items()) {
    const auto form = weighted_form(node, *point, name, multiplier);
    if (!form) return;
    sum += *form;
  }
  if (!is_negative_on(sum, *point, node.box)) {
    node.fault("/multipliers", "do not bring the linearisation below zero on the box");
  }
}

}  // namespace torquewright::gearbox::proof
