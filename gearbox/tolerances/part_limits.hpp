// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "gearbox/train/cut_train.hpp"

namespace torquewright::gearbox {

/// What is made with a tolerance.
enum class Dimension {
  kCentreDistance,  ///< Of a planet's pin from the gearbox' axis [mm].
  kToothThickness,  ///< On the reference circle [mm].
  kProfileShift,    ///< In modules.
  kTipDiameter,     ///< [mm]
};

/// How far a dimension of a part may be from its nominal value.
struct PartLimit {
  Dimension dimension = Dimension::kCentreDistance;
  std::size_t gear = 0;  ///< In the train's order; of no gear for a centre distance.
  std::string name;      ///< centre_distance, tooth_thickness.sun, ...
  double least = 0.0;
  double greatest = 0.0;
  bool is_of_each_planet = false;  ///< Every planet has one of its own.
  bool is_assumed = true;          ///< By usual_limits().

  double middle() const { return 0.5 * (least + greatest); }
  double width() const { return greatest - least; }
};

/// "mm", or "module".
std::string unit_of(Dimension dimension);

/// Unit of tolerance i of ISO 286-1 at a length [mm]: 0.45 D^(1/3) + 0.001 D micrometres; IT7 is
/// 16 i, IT8 25 i, IT9 40 i. Taken at the length itself, not at the middle of its range.
double tolerance_unit_mm(double length_mm);

/// Least backlash that ISO/TR 10064-2 recommends, along the line of action:
/// 2/3 (0.06 + 0.0005 a + 0.03 m) mm.
double recommended_backlash_mm(double centre_mm, double module_mm);

/// Limits where nobody states others, one for each dimension of each gear and one for the pins:
/// centre distance js7; teeth thinner by what makes two gears that backlash, to as much more as IT9
/// of infeed takes off them (ISO/TR 10064-2, grade 7, without runout); no tolerance of the shift,
/// which is that of the thickness; tip diameters h8, of rings H8.
std::vector<PartLimit> usual_limits(const CutTrain& train);

}  // namespace torquewright::gearbox
