// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "actuator/mor/mor_header.hpp"
#include "actuator/mor/mor_table.hpp"

namespace torquewright::actuator {

/// A document of kind `mor_table` without its provenance ("tool", "inputs").
nlohmann::ordered_json mor_table_json(const MorHeader& header, const MorTable& table);

/// The columns of the contract under a block of comment lines (#). Numbers have the digits that are
/// known of them (io/text/number_text.hpp); bounds of an empty range are left empty.
std::string mor_table_csv(const MorHeader& header, const MorTable& table);

}  // namespace torquewright::actuator
