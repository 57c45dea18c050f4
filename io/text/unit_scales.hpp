// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace torquewright::io {

/// The unit that a name ends in, as columns and keys have it: "Nm_s" of base_momentum_y_Nm_s.
/// Empty: none that is known.
std::string_view unit_of_name(std::string_view name);

/// Scales of columns, against which noise shows: the greatest size of all columns of one unit, in
/// their order. One of a unit that is not known has its own.
std::vector<double> unit_scales(const std::vector<std::string>& names,
                                const std::vector<double>& greatest_sizes);

}  // namespace torquewright::io
