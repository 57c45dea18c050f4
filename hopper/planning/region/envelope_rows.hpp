// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/planning/region/held_bus.hpp"

namespace torquewright::hopper {

/// The curve of a drive at its joint as straight rows that hold together.
struct EnvelopeRows {
  /// torque <= at_rest + slope speed; for the least torque the same with both negated.
  struct Row {
    double at_rest_Nm = 0.0;
    double slope_Nm_s_rad = 0.0;
  };
  std::vector<Row> rows;
  double greatest_Nm = 0.0;
  double end_rad_s = 0.0;  ///< Faster is no torque known.
};

/// Makes the rows of a drive's envelope at the open circuit's voltage times `keep_V`. Throws
/// io::SpecError, which names the actuator, where no set of such rows describes the curve. Requires
/// a drive with an envelope. docs/derivations/envelopes.md.
EnvelopeRows envelope_rows(const HeldBus& bus, double keep_V);

}  // namespace torquewright::hopper
