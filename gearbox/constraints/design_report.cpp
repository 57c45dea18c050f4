// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/design_report.hpp"

#include <algorithm>

namespace torquewright::gearbox {

bool DesignReport::feasible() const {
  return std::all_of(constraints.begin(), constraints.end(),
                     [](const ConstraintReport& constraint) { return constraint.satisfied; });
}

}  // namespace torquewright::gearbox
