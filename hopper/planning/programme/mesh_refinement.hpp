// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::hopper {

/// New knots (shares of a phase, 0 to 1): intervals whose error is more than their part of what is
/// allowed are halved. `error` by interval, infinite where it could not be told; `allowed` for the
/// phase, shared alike by its intervals.
std::vector<double> refined(const std::vector<double>& knots, const std::vector<double>& error,
                            double allowed);

}  // namespace torquewright::hopper
