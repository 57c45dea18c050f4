// SPDX-License-Identifier: Apache-2.0
// What a problem asks of the quantities that are reported: each from its own definition, met up to
// a millionth of a millionth.
#include <cmath>
#include <memory>
#include <utility>

#include "tests/oracles/gearbox_objectives.hpp"
#include "tests/oracles/reals.hpp"
#include "tests/oracles/rule_families.hpp"

namespace torquewright::oracles {
namespace {

using gearbox::Objective;
using Quantity = std::function<long double(const Teeth&)>;

constexpr long double kSlack = 1e-12L;

Rule floor_rule(std::string name, const std::optional<Rational>& limit, Quantity quantity,
                long double sign) {
  const long double bound = to_long_double(*limit);
  return {std::move(name), [=](const Teeth& teeth) {
            const long double slack = kSlack * std::fabs(bound);
            const long double margin = sign * (quantity(teeth) - bound) + slack;
            return Judgement{margin >= 0, std::fabs(margin) < kNearTie * std::fabs(bound), margin};
          }};
}

/// An objective as a quantity: that of a problem which asks for it.
Quantity objective(const Setting& setting, Objective which) {
  auto problem = std::make_shared<gearbox::Problem>(setting.problem);
  problem->objective = which;
  const std::int64_t planets = setting.planet_count;
  const Rational module_mm = setting.module_mm;
  return [=](const Teeth& teeth) {
    return objective_value(Setting{*problem, planets, module_mm}, teeth);
  };
}

/// Sun and fixed ring held, every mesh with the backlash j along its line of action: angles psi of
/// the carrier, x of a planet in it, theta of the output solve, with base radii r,
///   r_S psi = j - r_1 x,  r_F psi = r_1 x + j  and  r_O (theta - psi) = r_2 x + j,
/// each j with the sign that turns theta most.
long double backlash_rad_per_mm(const Setting& setting, const Teeth& teeth) {
  const long double per_tooth_mm = to_long_double(setting.module_mm) / 2 * std::cos(kPi / 9);
  const long double both = per_tooth_mm * real(teeth.sun + teeth.fixed_ring);
  if (!is_3k(setting.problem)) return 2 / both;  // psi alone
  const long double r1 = per_tooth_mm * real(teeth.planet_1);
  const long double r2 = per_tooth_mm * real(teeth.planet_2);
  const long double ring = per_tooth_mm * real(teeth.output_ring);
  const long double held = per_tooth_mm * real(teeth.fixed_ring);
  // psi = (j_S + j_F)/both, x = (r_F psi - j_F)/r_1.
  const auto turned = [&](long double sun_j, long double fixed_j) {
    const long double psi = (sun_j + fixed_j) / both;
    const long double x = (held * psi - fixed_j) / r1;
    return psi - r2 * x / ring;
  };
  return std::fabs(turned(1, 0)) + std::fabs(turned(0, 1)) + 1 / ring;
}

}  // namespace

std::vector<Rule> floor_rules(const Setting& setting) {
  const gearbox::Floors& floors = setting.problem.floors;
  std::vector<Rule> list;
  const auto add = [&](const char* name, const std::optional<Rational>& limit, long double sign,
                       Quantity quantity) {
    if (limit) list.push_back(floor_rule(name, limit, std::move(quantity), sign));
  };
  const auto of = [&](Objective which) { return objective(setting, which); };
  add("forward_efficiency", floors.forward_efficiency, 1, of(Objective::kForwardEfficiency));
  add("backward_efficiency", floors.backward_efficiency, 1, of(Objective::kBackwardEfficiency));
  add("hollow_shaft", floors.hollow_shaft_mm, 1, of(Objective::kHollowShaft));
  add("mass", floors.mass_kg, -1, of(Objective::kMass));
  add("reflected_inertia", floors.reflected_inertia_kg_m2, -1, of(Objective::kReflectedInertia));
  long double length_mm = 0;
  for (const auto& [layer, width_mm] : setting.problem.face_width_mm) {
    length_mm += to_long_double(width_mm);
  }
  add("axial_length", floors.axial_length_mm, -1, [length_mm](const Teeth&) { return length_mm; });
  add("backlash", floors.backlash_rad_per_mm, -1,
      [&problem = setting.problem, planets = setting.planet_count,
       module_mm = setting.module_mm](const Teeth& teeth) {
        return backlash_rad_per_mm({problem, planets, module_mm}, teeth);
      });
  return list;
}

}  // namespace torquewright::oracles
