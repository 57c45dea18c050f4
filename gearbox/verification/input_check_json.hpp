// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gearbox/proof/reading/faults.hpp"

namespace torquewright::gearbox {

/// Whether a problem is what the file named in "inputs" holds. Paths are as they were given, from
/// the folder that the command runs in. Returns a sentence: what was found equal, or that there is
/// no such file, so that nothing was compared; empty after a fault.
struct InputCheck {
  bool is_compared = false;
  std::string sentence;
};
InputCheck check_input(const nlohmann::json& result, const nlohmann::json& problem,
                       proof::Faults& faults);

}  // namespace torquewright::gearbox
