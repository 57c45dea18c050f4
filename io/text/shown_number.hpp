// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::io {

/// With as many digits of `scale` as are shown of it: a part of a vector or a sum beside the whole,
/// which a reader compares with it. 2.83e-05 beside 33.0 becomes 0.
double shown(double value, double scale, int digits);

/// The value as it is, or 0 where it has no part in the ten digits that are known of `scale`: for
/// files that others compute on, whose digits count and whose noise does not. 8e-15 beside 320
/// becomes 0, 0.1 + 0.2 stays.
double without_noise(double value, double scale);

}  // namespace torquewright::io
