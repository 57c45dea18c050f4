// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/contact_ratio.hpp"

namespace torquewright::gearbox::proof {

ContactPath contact_path(const TeethRange& range, int mesh) {
  const auto& [least, most] = range;
  if (mesh == 0) {
    return {external_path(least.sun, most.sun), external_path(least.planet_1, most.planet_1)};
  }
  return {external_path(planet(least, mesh), planet(most, mesh)),
          ring_path(ring(least, mesh), ring(most, mesh))};
}

Interval contact_ratio(const TeethRange& range, int mesh) {
  const ContactPath path = contact_path(range, mesh);
  return path.first + path.mate;
}

}  // namespace torquewright::gearbox::proof
