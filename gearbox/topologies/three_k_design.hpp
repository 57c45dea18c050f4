// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/train/cut_train.hpp"
#include "gearbox/train/kinematics.hpp"

namespace torquewright::gearbox::three_k {

/// One design of a 3K train as its evaluation sees it.
struct ThreeKDesign {
  const Problem& problem;
  ThreeKTeeth<std::int64_t> teeth;
  std::int64_t planet_count = 0;
  Rational module_mm;
  std::optional<CutTrain> cut = {};  ///< Of gears with profile shift or a second module only.

  ThreeKTeeth<double> real_teeth() const;
  /// O P1 = F P2: the output ring does not move.
  bool stands_still() const;
};

/// The constraints of docs/gearbox_constraints.md in that order: those of equations (2)...(9), and
/// those of a buildable train that come on top.
std::vector<ConstraintReport> paper_constraints(const ThreeKDesign& design);
std::vector<ConstraintReport> further_constraints(const ThreeKDesign& design);

/// Rings that are not coaxial without shift; empty for those of equations (2), (3).
std::vector<ConstraintReport> coaxiality_constraints(const ThreeKDesign& design);

/// What is worth knowing and forbids nothing. Needs the rest of the report.
std::vector<Remark> remarks(const ThreeKDesign& design, const DesignReport& report);

}  // namespace torquewright::gearbox::three_k
