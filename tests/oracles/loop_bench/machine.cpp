// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/loop_bench/machine.hpp"

#include <cmath>

namespace torquewright::oracles::loop {

std::vector<Law> Drive::laws() const {
  std::vector<Law> all = stated;
  all.insert(all.end(), hidden.begin(), hidden.end());
  return all;
}

double Drive::reflected_inertia_kg_m2() const {
  double sum = rotor_inertia_kg_m2 * ratio * ratio;
  if (const Law* more = law_named(hidden, "reflected_inertia")) sum += more->at("inertia_kg_m2");
  return sum;
}

// Lagrange's equations of two links in a plane, angles relative, weight along zero.
LinkTorques link_torques(const Rig& rig, const Pair& position_rad, const Pair& speed_rad_s) {
  const Link& a = rig.links.front();
  LinkTorques out;
  out.m11 = a.inertia_kg_m2 + a.mass_kg * a.center_m * a.center_m;
  out.bias_Nm[0] = a.mass_kg * a.center_m * kGravity_m_s2 * std::sin(position_rad[0]);
  if (rig.links.size() < 2) return out;
  const Link& b = rig.links.back();
  const double l = a.length_m, c = b.center_m, m = b.mass_kg;
  const double both = position_rad[0] + position_rad[1];
  const double w1 = speed_rad_s[0], w2 = speed_rad_s[1];
  out.m22 = b.inertia_kg_m2 + m * c * c;
  out.m12 = out.m22 + m * l * c * std::cos(position_rad[1]);
  out.m11 += out.m22 + m * l * l + 2.0 * m * l * c * std::cos(position_rad[1]);
  const double turn = m * l * c * std::sin(position_rad[1]);
  const double weight = m * c * kGravity_m_s2 * std::sin(both);
  out.bias_Nm[0] +=
      m * l * kGravity_m_s2 * std::sin(position_rad[0]) + weight - turn * (2.0 * w1 * w2 + w2 * w2);
  out.bias_Nm[1] = weight + turn * w1 * w1;
  return out;
}

}  // namespace torquewright::oracles::loop
