// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::hopper {

/// The relaxed logarithmic barrier of one end at a distance z from it (seed 000, A.2): log z, below
/// `softness` the parabola that continues its value and slope there; finite for every z.
/// Requires softness > 0.
double relaxed_log(double distance, double softness);

/// Both ends: relaxed_log(x - least) + relaxed_log(greatest - x).
double relaxed_barrier(double value, double least, double greatest, double softness);

}  // namespace torquewright::hopper
