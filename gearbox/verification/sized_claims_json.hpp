// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gearbox/problem.hpp"
#include "gearbox/proof/reading/faults.hpp"

namespace torquewright::gearbox {

/// What went into the check of a synthesis' claims.
struct SizedCheck {
  std::map<std::string, std::int64_t> choices;  ///< Gone through, by topology.
  std::int64_t boxes = 0;
  bool is_ended = false;  ///< Told to stop.
};

/// Proves every claim of a synthesis anew (gearbox/sized_proof) and that together they carry what
/// the result says: its status, its bound, its conflict. Adds faults.
SizedCheck check_sized_claims(const Problem& asked, const nlohmann::json& result,
                              const std::function<bool()>& should_stop, proof::Faults& faults);

}  // namespace torquewright::gearbox
