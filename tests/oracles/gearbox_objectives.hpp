// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "tests/oracles/gearbox_rules.hpp"

namespace torquewright::oracles {

bool greater_is_better(gearbox::Objective objective);

/// The objective as the user reads it. Throws std::bad_optional_access or std::out_of_range where
/// the problem lacks a value it needs.
long double objective_value(const Setting& setting, const Teeth& teeth);

/// Equation (1) with Z_P3 read as Z_P2, as a fraction.
Rational paper_cost(const Setting& setting, const Teeth& teeth);

/// The objective as a fraction, where it is one.
std::optional<Rational> exact_objective(const Setting& setting, const Teeth& teeth);

struct Efficiencies {
  long double forward = 0;
  long double backward = 0;  ///< At most 0: self-locking.
};
/// Both are 0 where a mesh does not exist (a ring whose tip circle lies inside its base circle),
/// loses contact (contact ratio below 1), or loses all power by friction.
Efficiencies efficiencies(const gearbox::Problem& problem, const Teeth& teeth);

/// The same, from the basic efficiencies of the meshes sun-planet, planet 1-fixed ring, planet
/// 2-output ring (1 for a single stage).
Efficiencies efficiencies(bool three_k, const Teeth& teeth, long double sun_mesh,
                          long double fixed_mesh, long double output_mesh);

long double mass_kg(const Setting& setting, const Teeth& teeth);
long double reflected_inertia_kg_m2(const Setting& setting, const Teeth& teeth);

}  // namespace torquewright::oracles
