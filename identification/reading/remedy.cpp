// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/remedy.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/faults/json_text.hpp"

namespace torquewright::identification {
namespace {

const ColumnUse* find_use(const ChannelKey& key, const Rig& rig) {
  const auto found =
      std::find_if(rig.columns.begin(), rig.columns.end(), [&](const ColumnUse& use) {
        return use.quantity == key.second &&
               (use.joint.empty() || use.joint == rig.joints[key.first]);
      });
  return found == rig.columns.end() ? nullptr : &*found;
}

/// What to write for the channel's column, with this said of it.
std::string advice(const ChannelKey& key, const ColumnUse* use, const std::string& said) {
  const std::string joint =
      use == nullptr || use->joint.empty() ? "" : fmt::format(", \"joint\": \"{}\"", use->joint);
  return fmt::format("write {{\"quantity\": \"{}\", {}{}}} for the column \"{}\"",
                     name_of(key.second), said, joint, use == nullptr ? "" : use->column);
}

}  // namespace

std::string path_of(const ChannelKey& key, const Rig& rig) {
  const ColumnUse* use = find_use(key, rig);
  return use == nullptr ? "/columns" : io::child_path("/columns", use->column);
}

std::string remedy(const ChannelKey& key, const Rig& rig, double factor) {
  const ColumnUse* use = find_use(key, rig);
  const double scale = factor * (use == nullptr ? 1.0 : use->scale);
  return advice(key, use, fmt::format("\"scale\": {:.6g}", scale));
}

std::string remedy_by_unit(const ChannelKey& key, const Rig& rig, const io::Unit& unit) {
  const ColumnUse* use = find_use(key, rig);
  const bool is_scaled = use != nullptr && (use->scale != 1.0 || use->offset != 0.0);
  if (is_scaled) return remedy(key, rig, unit.in_SI);
  return advice(key, use, fmt::format("\"unit\": \"{}\"", unit.name));
}

}  // namespace torquewright::identification
