// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "identification/rig/quantity.hpp"
#include "identification/rig/rig.hpp"

namespace torquewright::cli {

/// Standard deviations of white noise from texts QUANTITY=SIGMA, each in its quantity's unit.
/// Throws io::SpecError, also where a quantity stands twice or the rig names no column of it.
std::map<identification::Quantity, double> read_noise(const std::vector<std::string>& texts,
                                                      const identification::Rig& rig);

}  // namespace torquewright::cli
