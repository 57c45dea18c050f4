// SPDX-License-Identifier: Apache-2.0
#include "identification/log/remedy.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/json_text.hpp"

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

}  // namespace

std::string path_of(const ChannelKey& key, const Rig& rig) {
  const ColumnUse* use = find_use(key, rig);
  return use == nullptr ? "/columns" : io::child_path("/columns", use->column);
}

std::string remedy(const ChannelKey& key, const Rig& rig, double factor) {
  const ColumnUse* use = find_use(key, rig);
  const double scale = factor * (use == nullptr ? 1.0 : use->scale);
  const std::string joint =
      use == nullptr || use->joint.empty() ? "" : fmt::format(", \"joint\": \"{}\"", use->joint);
  return fmt::format("write {{\"quantity\": \"{}\", \"scale\": {:.6g}{}}} for the column \"{}\"",
                     name_of(key.second), scale, joint, use == nullptr ? "" : use->column);
}

}  // namespace torquewright::identification
