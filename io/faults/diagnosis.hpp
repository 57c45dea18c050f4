// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "io/faults/spec_error.hpp"

namespace torquewright::io {

/// A document with more faults than this is of another kind altogether; the rest is not listed.
constexpr std::size_t kMaxListedFaults = 1000;

/// Why a document does not satisfy its schema: one sentence for every fault, each at its place.
/// Knows the keywords type, const, enum, minimum, maximum, minItems, maxItems, items (one schema,
/// or one per place), properties, required, additionalProperties, anyOf, $ref inside the file; and
/// "unit" and "also_called", which are ours. `path` is the JSON pointer where the document stands
/// in the file.
std::vector<Fault> diagnose(const nlohmann::json& document, const nlohmann::json& schema,
                            const std::string& file, const std::string& path);

}  // namespace torquewright::io
