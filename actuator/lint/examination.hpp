// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "actuator/lint/common_convention.hpp"
#include "actuator/lint/finding.hpp"

namespace torquewright::actuator::lint {

/// Comparisons and findings of one document.
struct Examination {
  std::string actuator;
  /// Comparisons of every check whose numbers are all stated.
  std::vector<Comparison> comparisons;
  std::vector<Finding> findings;
};

Examination examine(const Actuator& document);

/// Results of several documents, each by itself and together.
struct Report {
  std::vector<Examination> examinations;
  /// Present with two or more documents that state speeds.
  std::optional<CommonFactor> common_factor;
  std::vector<Finding> findings;  ///< All findings, those of single documents first.
};

Report examine_all(std::span<const Actuator> documents);

/// True if a finding is more than a note.
bool has_contradiction(const Report& report);

}  // namespace torquewright::actuator::lint
