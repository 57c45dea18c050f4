// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/reading/channel.hpp"
#include "io/text/units.hpp"

namespace torquewright::identification {

/// Pointer to where the rig names the channel: /columns/...; /columns where it does not.
std::string path_of(const ChannelKey& key, const Rig& rig);

/// Returns what to write into the rig so that the column's numbers are taken `factor` times as
/// large: write {"quantity": "...", "scale": 0.0174533} for the column "q".
std::string remedy(const ChannelKey& key, const Rig& rig, double factor);

/// Returns what to write into the rig for a column in that unit: write {"quantity": "...", "unit":
/// "rpm"} for the column "w"; a scale where the rig states one already.
std::string remedy_by_unit(const ChannelKey& key, const Rig& rig, const io::Unit& unit);

}  // namespace torquewright::identification
