// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/text/units.hpp"

namespace torquewright::actuator {

/// The greatest angle, speed, torque or force of a motion that is read, in SI units: squares and
/// sums of greater ones overflow.
inline constexpr double kGreatestValue = 1e9;

/// The quantity that a column of a trajectory holds.
enum class Quantity { kTime, kPosition, kVelocity, kTorque };
std::string_view name_of(Quantity quantity);
std::optional<Quantity> find_quantity(std::string_view name);
io::Dimension dimension_of(Quantity quantity);

/// The quantity and joint of a column (no joint for the time), and the factor that turns its
/// numbers into s, rad, rad/s or Nm.
struct ColumnMapping {
  std::string column;
  std::string joint;
  Quantity quantity = Quantity::kTime;
  double factor = 1.0;
  bool has_unit = false;  ///< Its unit or factor was stated.
  /// The mapping as the command line has it; empty: it is from a document or a header.
  std::string text{};
};

/// A mapping of the command line, taken apart: NAME=JOINT.QUANTITY[:unit][*factor].
struct MappingText {
  std::string column;
  std::string joint;  ///< Name of the joint; empty: none.
  std::string quantity;
  std::string unit;  ///< Unit; empty: none is stated.
  double factor = 1.0;
};
/// Splits a mapping. Throws io::SpecError where the text has not that form.
MappingText split_mapping(const std::string& text);
/// Refuses a mapping: throws io::SpecError that repeats it, says why and how it is written.
[[noreturn]] void refuse_mapping(const std::string& text, const std::string& why);

/// Reads NAME=JOINT.QUANTITY[:unit][*factor], or NAME=time[:unit][*factor]:
/// tau_k=knee.torque:Nm*0.5. Throws io::SpecError.
ColumnMapping read_mapping(const std::string& text);

/// Returns the mapping of a canonical header: time_s (also time or t), <joint>_position_rad,
/// <joint>_velocity_rad_s, <joint>_torque_Nm. Empty for any other.
std::optional<ColumnMapping> canonical_mapping(const std::string& column);

/// Returns the unit of a dimension that a column's name ends in, if it is not SI's: deg/s of
/// knee_velocity_deg_s, mNm of "tau [mNm]". Empty: none.
std::optional<io::Unit> foreign_unit(const std::string& column, io::Dimension dimension);

}  // namespace torquewright::actuator
