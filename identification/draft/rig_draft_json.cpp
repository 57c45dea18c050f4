// SPDX-License-Identifier: Apache-2.0
#include "identification/draft/rig_draft_json.hpp"

#include "io/faults/json_text.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::ordered_json;

ordered_json column_json(const ColumnGuess& guess) {
  const std::string quantity(name_of(*guess.quantity));
  const bool is_other_unit = guess.unit && guess.unit->name != unit_of(*guess.quantity);
  if (!is_other_unit && guess.joint.empty() && !guess.is_reversed) return quantity;
  ordered_json column = {{"quantity", quantity}};
  if (is_other_unit) column["unit"] = guess.unit->name;
  if (guess.is_reversed) column["scale"] = -1;
  if (!guess.joint.empty()) column["joint"] = guess.joint;
  return column;
}

}  // namespace

ordered_json rig_draft_json(const RigDraft& draft, const std::string& name) {
  ordered_json document = {{"kind", "rig"},
                           {"version", 1},
                           {"name", name},
                           {"columns", ordered_json::object()},
                           {"ignore", ordered_json::array()}};
  ordered_json assumed = ordered_json::array();
  for (const ColumnGuess& each : draft.columns) {
    if (!each.quantity) {
      document["ignore"].push_back(each.column);
      continue;
    }
    document["columns"][each.column] = column_json(each);
    if (!each.is_sure) assumed.push_back(io::child_path("/columns", each.column));
  }
  if (draft.is_dynamometer) {
    document["load"] = {{"type", "dynamometer"}};
    assumed.push_back("/load");
  }
  if (document["ignore"].empty()) document.erase("ignore");
  if (!assumed.empty()) document["assumed"] = std::move(assumed);
  return document;
}

}  // namespace torquewright::identification
