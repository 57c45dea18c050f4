// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::hopper {

/// New knots (shares of a phase, 0 to 1): intervals whose error is more than their part of what is
/// allowed are halved, the worst first, no more than there were. `error` by interval; `allowed` for
/// the phase, shared alike by its intervals.
/// Those whose `other` error is beyond `other_allowed` of each are halved as well.
std::vector<double> refined(const std::vector<double>& knots, const std::vector<double>& error,
                            double allowed, const std::vector<double>& other,
                            double other_allowed);

}  // namespace torquewright::hopper
