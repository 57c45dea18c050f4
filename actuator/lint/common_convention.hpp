// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "actuator/lint/finding.hpp"

namespace torquewright::actuator::lint {

/// Several actuators of one maker: does one convention of the torque constant fit them all?

/// Factors from the least to the greatest.
struct FactorRange {
  double low = 0.0;
  double high = 0.0;
};

/// The factor c of w0 = c V / (Kt N) that a document's printed numbers demand.
struct RequiredFactor {
  std::string actuator;
  RoundedInterval factor;
  RoundedInterval speed_rad_s;  ///< Speed as stated.
  double peak_current_A = 0.0;  ///< Peak current of the drive.
  /// Greatest factor of field weakening on a speed, if Kt = Ke; 1 where the document has none.
  double greatest_weakening = 1.0;
  /// The factors that its sheet does not contradict: `factor` with what the rule for a single
  /// no-load speed leaves open, the constants' tolerance and the no-load current's share.
  FactorRange tolerated = {};
  bool assumes_convention = false;  ///< Its document marks the convention as assumed.
};

/// The factor c, and each actuator's speed, under one convention and modulation.
struct FactorCandidate {
  CurrentConvention convention = CurrentConvention::kDc;
  std::string sentence;
  double factor = 1.0;
  std::vector<RoundedInterval> speeds_rad_s;  ///< Speeds in the order of the actuators.
  Agreement fit = Agreement::kExcludes;  ///< kAdmits: no stated speed exceeds what is possible.
  bool is_tolerated = false;             ///< Every document's tolerated factors hold this one.
};

struct CommonFactor {
  std::vector<RequiredFactor> required;
  bool is_common_as_printed = false;  ///< All factors equal without rounding.
  double low = 0.0;  ///< Least of the intervals' overlap; above `high` if there is none.
  double high = 0.0;
  std::vector<FactorCandidate> candidates;
};

/// Looks for a common factor. Empty with fewer than two documents that state a no-load speed.
std::optional<CommonFactor> common_factor(std::span<const Actuator> documents);

/// Returns a finding; empty if one candidate fits all. A note where one is tolerated by all and
/// some document assumes its convention; where all state theirs, a tolerated one is no finding.
std::optional<Finding> finding_of(const CommonFactor& common);

/// Returns findings on one motor with several gearboxes (pairs with the same constants and drive,
/// but another ratio): no-load speed times ratio, peak torque over ratio and reflected inertia over
/// its square must agree.
std::vector<Finding> same_motor(std::span<const Actuator> documents);

}  // namespace torquewright::actuator::lint
