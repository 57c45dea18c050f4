// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace torquewright::io {

/// The keys that an object of this schema may have, but for "$schema".
std::vector<std::string> known_keys(const nlohmann::json& schema);

/// Those keys that somebody may have meant with an unknown one: it is another name of theirs (the
/// schema's "also_called"), its words are theirs (voltage: bus_voltage_V), or it differs by a few
/// letters. Keys that the object has already count only where no other will do, and of several
/// those that are missing.
std::vector<std::string> meant_keys(const std::string& key, const nlohmann::json& object,
                                    const nlohmann::json& schema);

/// The pointer of a key of that other name, anywhere in a kind's schema; empty: there is none.
std::string place_of(const std::string& key, const nlohmann::json& root);

}  // namespace torquewright::io
