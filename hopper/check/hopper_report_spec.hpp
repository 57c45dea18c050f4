// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "hopper/check/hopper_check.hpp"

namespace torquewright::hopper {

/// Writes a document of kind `check_report` with the keys of a whole body, without its provenance.
/// What is not finite or not known is null.
nlohmann::ordered_json hopper_report_json(const HopperReport& report);

/// Writes the lists `transmission_load` and `contact_load` of the report.
nlohmann::ordered_json transmission_load_json(const std::vector<TransmissionLoad>& loads);
nlohmann::ordered_json contact_load_json(const std::vector<ContactLoad>& loads);

}  // namespace torquewright::hopper
