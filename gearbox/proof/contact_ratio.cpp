// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/contact_ratio.hpp"

namespace torquewright::gearbox::proof {

ContactPath contact_path(const Box& box, int mesh) {
  if (mesh == 0) {
    return {external_path(box.lower[0], box.upper[0]), external_path(box.lower[1], box.upper[1])};
  }
  return {external_path(planet(box.lower, mesh), planet(box.upper, mesh)),
          ring_path(ring(box.lower, mesh), ring(box.upper, mesh))};
}

Interval contact_ratio(const Box& box, int mesh) {
  const ContactPath path = contact_path(box, mesh);
  return path.first + path.mate;
}

}  // namespace torquewright::gearbox::proof
