// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/balance.hpp"
#include "identification/model.hpp"
#include "identification/result.hpp"

namespace torquewright::identification {

/// The members of a fit as effects with the contract's parameters; members of one effect (several
/// harmonics) become one. Standard errors by the covariance, propagated to first order. `members`:
/// for each effect, the places in the fit that it came from.
struct Named {
  NamedEffect effect;
  std::vector<std::size_t> members;
};
/// Coefficients that stood before the members' own when a fit was made: some may have been dropped.
std::size_t count_always(const Fit& fit, const std::vector<Variant>& variants);

std::vector<Named> named_effects(const Fit& fit, const Dictionary& dictionary,
                                 std::size_t always_count, const Balance& balance);

}  // namespace torquewright::identification
