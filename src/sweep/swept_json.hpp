// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "src/sweep/swept.hpp"

namespace torquewright::sweep {

/// A row as workers send it and journals keep it, on one line.
std::string row_text(const SweepRow& row);
/// Reads a row again; requires what row_text() wrote.
SweepRow row_of(const std::string& text);

/// A document of kind sweep_result, without its provenance.
nlohmann::ordered_json swept_json(const Swept& swept);

}  // namespace torquewright::sweep
