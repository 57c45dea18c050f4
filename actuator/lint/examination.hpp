// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "actuator/lint/common_convention.hpp"
#include "actuator/lint/finding.hpp"

namespace torquewright::actuator::lint {

/// Everything that one document states twice.
struct Examination {
  std::string actuator;
  std::vector<Comparison> comparisons;  ///< Of every check whose numbers are all stated.
  std::vector<Finding> findings;
};

Examination examine(const Actuator& document);

/// Several documents, each by itself and together.
struct Report {
  std::vector<Examination> examinations;
  std::optional<CommonFactor> common_factor;  ///< With two documents or more that state speeds.
  std::vector<Finding> findings;              ///< All of them, those of single documents first.
};

Report examine_all(std::span<const Actuator> documents);

/// True if a finding is more than a note.
bool has_contradiction(const Report& report);

}  // namespace torquewright::actuator::lint
