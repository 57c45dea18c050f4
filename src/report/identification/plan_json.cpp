// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/plan_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace torquewright::report {
namespace {

using identification::Expected;
using identification::Plan;
using identification::PlannedParameter;
using nlohmann::ordered_json;

/// Infinity has no number in JSON.
ordered_json number_or_null(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json expected_json(const Expected& expected) {
  return {{"standard_error", number_or_null(expected.standard_error)},
          {"separability", expected.share},
          {"nearest", expected.nearest},
          {"nearest_parameter", expected.nearest_parameter}};
}

}  // namespace

nlohmann::ordered_json plan_json(const Plan& plan, ordered_json options) {
  ordered_json document;
  document["separable"] = plan.is_separable();
  document["parameters"] = ordered_json::array();
  for (const PlannedParameter& each : plan.parameters) {
    ordered_json entry = {{"effect", each.column.effect}, {"parameter", each.column.parameter}};
    if (!each.column.at.empty()) entry["at"] = each.column.at;
    entry["typical"] = each.typical;
    entry["separable"] = each.is_separable;
    entry["plan"] = expected_json(each.plan);
    entry["chirp"] = expected_json(each.chirp);
    document["parameters"].push_back(std::move(entry));
  }
  document["smallest_eigenvalue"] = {{"plan", plan.smallest_eigenvalue},
                                     {"chirp", plan.chirp_smallest_eigenvalue}};
  document["not_separable_on_this_rig"] = ordered_json::array();
  for (const Plan::Unseen& each : plan.unseen) {
    document["not_separable_on_this_rig"].push_back(
        {{"effects", each.effects}, {"why", each.why}, {"separated_by", each.remedy}});
  }
  for (const auto& [quantity, sigma] : plan.noise) {
    document["noise"][std::string(identification::name_of(quantity))] = sigma;
  }
  document["tried"] = plan.tried;
  document["options"] = std::move(options);
  return document;
}

}  // namespace torquewright::report
