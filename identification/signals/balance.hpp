// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/signals/preparation.hpp"

namespace torquewright::identification {

/// What the torque balance of a bench is measured in. docs/derivations/identification.md eq. (2) to
/// (4).
class Balance {
 public:
  explicit Balance(const Bench& bench);

  /// What one Nm before the mesh does to the residual, in Nm at the output.
  double gain(const Signals& signals, std::size_t i) const;

  const Bench& bench() const { return bench_; }

  /// Residual in the unit of the measured quantity per Nm, and that quantity.
  double unit_per_Nm() const;
  Quantity quantity() const;

 private:
  Bench bench_;
  bool is_sensor_;
};

}  // namespace torquewright::identification
