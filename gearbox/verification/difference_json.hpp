// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace torquewright::gearbox {

/// Where a document is not as it should be.
struct Difference {
  std::string pointer;   ///< JSON pointer of the first place; empty: the whole document.
  std::string sentence;  ///< "is 3, expected 4"
};

/// The first difference, keys in alphabetical order; empty if there is none. Fractions are equal
/// within one part in 10^9 or 10^-14, so that another machine's sines do: the sums they stand in
/// are of that size. All else has to be the same; null and absent are different.
std::optional<Difference> first_difference(const nlohmann::json& found,
                                           const nlohmann::json& expected,
                                           const std::string& pointer = "");

}  // namespace torquewright::gearbox
