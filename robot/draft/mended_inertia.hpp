// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

#include "robot/xml/element.hpp"

namespace torquewright::hopper {

/// Half a unit in the last place of the coarsest number that is written with decimals; 0 where none
/// is: "0.012 0.5" may be off by 0.05.
double rounding_of(std::string_view numbers);

/// The same of an MJCF <inertial> or a URDF <inertia>; 0 of null.
double rounding_of(const Element* inertia);

struct MendedInertia {
  Eigen::Matrix3d inertia_kg_m2;
  Eigen::Vector3d before_kg_m2;  ///< Principal moments, ascending.
  Eigen::Vector3d after_kg_m2;
  bool is_rounding = false;  ///< Whether numbers off by half a unit of their last place explain it.
};

/// The nearest inertia whose moments a flat body could have, where the largest exceeds the sum of
/// the others. Nothing where none is needed, or where a moment is negative that rounding does not
/// explain.
std::optional<MendedInertia> mended(const Eigen::Matrix3d& inertia_kg_m2, double rounding_kg_m2);

/// "principal moments 1, 2, 4 kg m2 become 1.33, 2.33, 3.67".
std::string change_of(const MendedInertia& mended);

}  // namespace torquewright::hopper
