// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/selection/model_fit.hpp"

namespace torquewright::identification {

/// Returns a member of a model with its parameters as documents name them and their standard
/// errors, by first-order propagation of the fit's covariance; null where the log does not
/// determine one.
NamedEffect named_effect(const ModelFit& fit, std::size_t member);

/// Whether both are waves of one effect, which a report states together.
bool is_wave_of(const NamedEffect& first, const NamedEffect& wave);

/// Joins two waves of one effect: the second's harmonics are appended to the first's.
void append_wave(NamedEffect& first, const NamedEffect& wave);

}  // namespace torquewright::identification
