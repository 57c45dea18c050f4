// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::io {

/// A force with so many digits: "812 N", from 1000 N on "43.9 kN".
std::string force_text(double force_N, int digits);

}  // namespace torquewright::io
