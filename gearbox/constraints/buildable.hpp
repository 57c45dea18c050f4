// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/constraints/tooth_conditions.hpp"
#include "gearbox/train_parts.hpp"

namespace torquewright::gearbox {

// The constraints of a buildable train without profile shift, part by part, in the order of
// docs/gearbox_constraints.md: the one list that designs are judged by and the one that the search
// keeps. `own` is what no other topology is asked for; it stands between the gears' and the rings'.

/// Judges a design, all of whose teeth are named, by these constraints.
std::vector<ConstraintReport> buildable_constraints(const Problem& problem, const TrainParts& parts,
                                                    const Design& design,
                                                    std::vector<ConstraintReport> own);

/// States these constraints on expressions of the teeth, in the topology's order.
std::vector<Condition> buildable_conditions(const Problem& problem, const TrainParts& parts,
                                            std::int64_t planet_count, const Rational& module_mm,
                                            std::span<const Expression> teeth,
                                            const std::vector<Condition>& own);

}  // namespace torquewright::gearbox
