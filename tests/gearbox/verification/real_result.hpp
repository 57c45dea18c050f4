// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gearbox/verification/verification_json.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::gearbox::verification_test {

using Json = nlohmann::json;

/// The problem of specs/gearbox/d151_knee.json with other values for some keys; null removes one.
Json knee_with(const Json& changes = Json::object());
/// Any of specs/gearbox, changed in the same way.
Json problem_with(const std::string& name, const Json& changes = Json::object());

/// What `gearbox optimize` writes about a problem in a file of this folder.
Json real_result(const test::ScratchFolder& folder, const Json& problem, const Json& options);

/// What `gearbox verify` finds: reads the document, then verifies it. A document that is refused by
/// its shape comes back as not accepted, with the reader's faults.
Verification verified(const Json& result);

/// The problem in a result.
Problem problem_of(const Json& result);

}  // namespace torquewright::gearbox::verification_test
