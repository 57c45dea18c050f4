// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace torquewright::gearbox {

/// A train as it was made.
struct GearTrain {
  std::string topology;             ///< "3k" or "planetary".
  std::vector<std::int64_t> teeth;  ///< In the topology's order.
  std::vector<double> shifts;       ///< Profile shifts in modules, likewise.
  std::int64_t planet_count = 0;
  double module_mm = 0.0;
  std::vector<double> face_width_mm;  ///< By layer: one, or two of a 3K train.
};

}  // namespace torquewright::gearbox
