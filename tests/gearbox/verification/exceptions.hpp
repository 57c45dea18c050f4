// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "tests/gearbox/proof/mutation.hpp"

namespace torquewright::gearbox::verification_test {

/// A change that leaves a valid proof of a true claim. docs/certificate.md has a row for each:
/// `| field | reason |`.
struct Exception {
  std::string field;
  std::string reason;
  std::regex pointer;
  std::regex kind;
  bool (*applies)(const nlohmann::json& before) = nullptr;  ///< Empty: always.
};

const std::vector<Exception>& exceptions();

/// The first exception that covers the change; nullptr if none does.
const Exception* find_exception(const proof_test::Mutation& mutation, const nlohmann::json& before);

}  // namespace torquewright::gearbox::verification_test
