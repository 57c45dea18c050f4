// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/equation_fit.hpp"
#include "identification/residual_structure.hpp"
#include "identification/search.hpp"

namespace torquewright::identification {

/// The reasons for which a name is no confident one, a file each; empty: not that one. `before`:
/// what is left along each coordinate without any member; `left`: with all of them.
/// docs/derivations/identification.md section 6.

/// Up to so many floors of squared error left, nothing is held against a model.
constexpr double kTestedFloors = 2.5;
/// Below so much of the floor what is left says nothing.
constexpr double kNearlyNoise = 0.5;

inline bool is_nearly_noise(const EquationFit& fit, const Fit& model) {
  return model.loss <= kNearlyNoise * fit.floor_loss(model);
}

/// Of all members together.
using AcceptanceTestOfAll = std::string(const EquationFit& fit, const Selection& selection,
                                        const std::vector<ResidualStructure>& before);

/// They have to explain most of what is explainable.
AcceptanceTestOfAll insufficient_share;
/// The right laws know more than their values over any one coordinate. Where the target is part of
/// a coordinate, its table explains it by itself and says nothing.
AcceptanceTestOfAll coordinate_table_explains_more;
/// Members that need one another may together be no better than none, where no fit saw.
AcceptanceTestOfAll unconfirmed_held_out_together;

/// Of one member.
using AcceptanceTestOfMember = std::string(const EquationFit& fit, const Fit& model,
                                           std::size_t member,
                                           const std::vector<ResidualStructure>& left);

/// Runs that no fit has seen have the last word.
AcceptanceTestOfMember unconfirmed_held_out;
/// Once others are gone it may gain nothing any more.
AcceptanceTestOfMember insufficient_gain;
/// Fits in each fold alone: parameters that wander are no law.
AcceptanceTestOfMember parameter_scatter;
/// Many waves on one fundamental are a spot, which the law of a few orders is not.
AcceptanceTestOfMember harmonic_comb;
/// Nothing may be left along the coordinate of its own law.
AcceptanceTestOfMember residual_along_own_coordinate;
/// A member whose amplitude varies with something would explain much more.
AcceptanceTestOfMember varying_amplitude;

}  // namespace torquewright::identification
