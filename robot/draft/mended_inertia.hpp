// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

#include "robot/xml/element.hpp"

namespace torquewright::hopper {

/// Half a unit in the last place of the coarsest number that is written with decimals; 0 where none
/// is: "0.012 0.5" may be off by 0.05.
double rounding_of(std::string_view numbers);

/// The same of an MJCF <inertial> or a URDF <inertia>; 0 of null.
double rounding_of(const Element* inertia);

/// The nearest inertia whose moments a flat body could have, where the largest exceeds the sum of
/// the others by no more than numbers off by so much could make it. Nothing where none is needed,
/// or where rounding does not explain it.
std::optional<Eigen::Matrix3d> mended(const Eigen::Matrix3d& inertia_kg_m2, double rounding_kg_m2);

}  // namespace torquewright::hopper
