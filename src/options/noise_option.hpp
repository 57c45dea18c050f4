// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "identification/rig/quantity.hpp"

namespace torquewright::cli {

/// Standard deviations of white noise from texts QUANTITY=SIGMA, each in its quantity's unit; the
/// last one holds where a quantity repeats. Throws io::SpecError.
std::map<identification::Quantity, double> read_noise(const std::vector<std::string>& texts);

}  // namespace torquewright::cli
