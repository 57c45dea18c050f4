// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gearbox/problem.hpp"

namespace torquewright::gearbox::proof_test {

/// Changes within a proof tree, or of the numbers that its claim rests on, may make another proof
/// of the same claim: a cut that takes less, a split elsewhere. Whether the result, changed at
/// `pointer`, is one, by trying all teeth of every box.
bool is_another_proof(const Problem& problem, const nlohmann::json& result,
                      const std::string& pointer);

}  // namespace torquewright::gearbox::proof_test
