// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/preparation/preparation.hpp"

namespace torquewright::identification {

/// The measures of a bench's torque balance: which sign and unit its residual has
/// (docs/derivations/identification.md eq. (2) to (4)).
class Balance {
 public:
  explicit Balance(const Bench& bench);

  /// Change of the residual by one Nm before the mesh, in Nm at the output.
  double gain(const Signals& signals, std::size_t i) const;

  const Bench& bench() const { return bench_; }

  /// Residual in the unit of the measured quantity per Nm of the balance.
  double unit_per_Nm() const;
  Quantity quantity() const;

 private:
  Bench bench_;
  bool is_sensor_;
};

}  // namespace torquewright::identification
