// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include "actuator/mor/clip_table.hpp"

namespace torquewright::python {

/// Numbers side by side, as actuator/clip.hpp takes them.
using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// The region's table, ready to clip arrays; `error_Nm` is by how much lines between its rows may
/// be off: both bounds are drawn in by it, as in the files for simulators.
class RegionClip {
 public:
  /// Requires three arrays of one length, with two different speeds, ascending; throws
  /// std::invalid_argument, which is ValueError.
  RegionClip(const Numbers& speed_rad_s, const Numbers& least_Nm, const Numbers& greatest_Nm,
             double error_Nm);

  /// Requires arrays of one shape, which is that of the answer. The interpreter goes on meanwhile.
  Numbers clip(const Numbers& torque_Nm, const Numbers& speed_rad_s) const;

 private:
  actuator::ClipTable table_;
};

}  // namespace torquewright::python
