// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::io {

enum class Dimension {
  kTime,
  kAngle,
  kAngularVelocity,
  kAngularAcceleration,
  kTorque,
  kLength,
  kVelocity,
  kAcceleration,
  kForce,
  kCurrent,
  kVoltage,
  kTemperature,
  kNumber,  ///< Has no unit.
};

/// A unit of a column or an option: a value in it is in_SI times it plus zero_in_SI in the SI unit
/// (s, rad, rad/s, Nm, m, ...).
struct Unit {
  std::string_view name;
  Dimension dimension;
  double in_SI;
  double zero_in_SI = 0.0;  ///< Of temperatures alone is it another.
};

/// The unit of that name: "deg", "deg/s" or "deg_s", "rpm", "mNm", "ms", "degC", ... Empty if there
/// is none such.
std::optional<Unit> find_unit(std::string_view name);

/// The names of a dimension's units, its SI unit first.
std::vector<std::string> unit_names(Dimension dimension);

}  // namespace torquewright::io
