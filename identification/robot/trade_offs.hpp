// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/rollout/value_fit.hpp"

namespace torquewright::identification {

/// One of the values that change together without changing the motion.
struct TradedValue {
  FreeValue which;
  double value = 0.0, standard_error = 0.0;
  double ratio = 0.0, ratio_error = 0.0;  ///< To the first of the group.
};

/// Values of a joint of which the log tells less than each would show if the first were known: one
/// of them cannot be printed without the others.
struct TradeOff {
  std::size_t joint = 0;
  /// Whether they scale together, a controller's gain first: only the ratios to it are told.
  bool is_scale = false;
  std::vector<TradedValue> values;
};

/// Finds them in a fit, and marks its values as traded: where a gain is not told to a tenth, what
/// would be known twice as well with it; then pairs of a joint that are not told and would be,
/// each with the other.
std::vector<TradeOff> find_trade_offs(ValueFit& fit);

/// "wrist_roll: controller_stiffness_Nm_rad (17 ± 9) and rotor_inertia_kg_m2 scale together ..."
std::string sentence_of(const TradeOff& trade_off, const std::vector<std::string>& joints);

/// What would tell them apart.
std::string separated_by(const TradeOff& trade_off);

}  // namespace torquewright::identification
