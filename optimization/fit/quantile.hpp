// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::optimization {

/// Each is one of the values, found in linear time, and requires some. The least value stands at
/// the share 0 of the way through them in ascending order, the greatest at 1.

/// The value nearest to that share; of two that are as near, the greater.
double nearest_quantile(std::vector<double> values, double share);
/// The last value that does not stand beyond that share.
double lower_quantile(std::vector<double> values, double share);
/// The median; of an even number of values the greater of the two in the middle.
double median(std::vector<double> values);

}  // namespace torquewright::optimization
