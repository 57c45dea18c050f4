// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gearbox/problem.hpp"
#include "optimization/discrete/problem.hpp"

namespace torquewright::gearbox {

// The constraints of docs/gearbox_constraints.md that topologies share, as conditions on
// expressions of tooth counts. Lengths are in modules unless a name says otherwise.

using optimization::Condition;
using optimization::Expression;

/// Returns G(1-t) and G(1+t).
Rational least_ratio(const Problem& problem);
Rational greatest_ratio(const Problem& problem);

Condition at_least(const std::string& gear, const Expression& teeth, std::int64_t minimum);

/// Makes the condition pi/n - asin(P/(S + P)) >= alpha_min in linear form: k S - (1 - k) P >= 0, k
/// = sin(pi/n - alpha_min).
Condition carrier_clearance(const Problem& problem, std::int64_t planet_count,
                            const Expression& sun, const Expression& planet);
Expression carrier_clearance_rad(std::int64_t planet_count, const Expression& sun,
                                 const Expression& planet);

Condition rotor_bore(const Problem& problem, const Rational& module_mm, const Expression& ring);

/// Makes the clearance condition of planet `planet` of the layer, on the centre distance of sun and
/// planet 1.
Condition neighbour_clearance(const Problem& problem, const std::string& layer,
                              std::int64_t planet_count, const Rational& module_mm,
                              const Expression& tooth_sum, const Expression& planet);
Expression neighbour_clearance_mm(std::int64_t planet_count, const Rational& module_mm,
                                  const Expression& tooth_sum, const Expression& planet);

/// Makes the condition that a gear is not undercut by the stated hob, else by one that is straight
/// down to a rack's addendum.
Condition undercut(const Problem& problem, const std::string& gear, const Expression& teeth);
Condition ring_tip(const std::string& ring, const Rational& module_mm, const Expression& teeth);

Condition ring_wall(const Problem& problem, const std::string& ring, const Rational& module_mm,
                    const Expression& teeth);

/// Makes the conditions of involute and trochoid interference of a planet in a ring; judged at
/// points.
std::vector<Condition> interference(const std::string& mesh, const Expression& planet,
                                    const Expression& ring);
/// Makes the conditions that stated cutters leave the involutes in a ring's mesh, and that its
/// shaper can be fed in. Assumed cutters need no condition (docs/derivations/tooth_outline.md,
/// "Which cutters never fail").
std::vector<Condition> root_form(const Problem& problem, const std::string& mesh,
                                 const Expression& planet, const Expression& ring);
/// Makes the same conditions for two external gears.
std::vector<Condition> root_form_of_gears(const Problem& problem, const std::string& mesh,
                                          const Expression& gear_1, const Expression& gear_2);
/// Makes the condition that the contact ratio of two external gears is enough.
Condition contact_ratio(const Problem& problem, const std::string& mesh, const Expression& gear_1,
                        const Expression& gear_2);
/// Makes the condition that the contact ratio of a planet in a ring is enough; a ring whose tip
/// circle lies inside its base circle has no contact.
Condition contact_ratio_in_ring(const Problem& problem, const std::string& mesh,
                                const Expression& planet, const Expression& ring);

}  // namespace torquewright::gearbox
