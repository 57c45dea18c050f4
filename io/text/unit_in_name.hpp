// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "io/text/units.hpp"

namespace torquewright::io {

/// The longest unit of that dimension that a column's name ends in: rad_s of knee_velocity_rad_s,
/// rpm of "speed [rpm]" and "speed / rpm". Empty if it ends in none.
std::optional<Unit> unit_in_name(std::string_view name, Dimension dimension);

}  // namespace torquewright::io
