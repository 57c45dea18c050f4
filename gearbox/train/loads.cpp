// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/loads.hpp"

namespace torquewright::gearbox {

ThreeKRadii working_radii(const ThreeKTeeth<double>& teeth, double centre_m) {
  return {centre_m * teeth.sun / (teeth.sun + teeth.planet_1),
          centre_m * teeth.fixed_ring / (teeth.fixed_ring - teeth.planet_1),
          centre_m * teeth.output_ring / (teeth.output_ring - teeth.planet_2)};
}

ThreeKLoads three_k_loads(double output_torque_Nm, double reduction, std::int64_t planet_count,
                          const ThreeKRadii& radii) {
  const auto planets = static_cast<double>(planet_count);
  ThreeKLoads loads;
  loads.sun_torque_Nm = output_torque_Nm / reduction;
  // The carrier is free, so the held ring takes what sun and output leave: T_F = T_O - T_S.
  loads.fixed_ring_torque_Nm = output_torque_Nm - loads.sun_torque_Nm;
  loads.sun_force_N = loads.sun_torque_Nm / (planets * radii.sun_m);
  loads.fixed_ring_force_N = loads.fixed_ring_torque_Nm / (planets * radii.fixed_ring_m);
  loads.output_ring_force_N = output_torque_Nm / (planets * radii.output_ring_m);
  return loads;
}

PlanetaryRadii working_radii(const PlanetaryTeeth<double>& teeth, double centre_m) {
  return {centre_m * teeth.sun / (teeth.sun + teeth.planet),
          centre_m * teeth.ring / (teeth.ring - teeth.planet)};
}

PlanetaryLoads planetary_loads(double output_torque_Nm, double reduction, std::int64_t planet_count,
                               const PlanetaryRadii& radii) {
  const auto planets = static_cast<double>(planet_count);
  PlanetaryLoads loads;
  loads.sun_torque_Nm = output_torque_Nm / reduction;
  loads.ring_torque_Nm = output_torque_Nm - loads.sun_torque_Nm;
  loads.sun_force_N = loads.sun_torque_Nm / (planets * radii.sun_m);
  loads.ring_force_N = loads.ring_torque_Nm / (planets * radii.ring_m);
  return loads;
}

}  // namespace torquewright::gearbox
