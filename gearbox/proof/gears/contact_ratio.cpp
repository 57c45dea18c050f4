// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/contact_ratio.hpp"

#include "gearbox/proof/gears/tooth_path.hpp"

namespace torquewright::gearbox::proof {

template <typename Number>
ContactPath<Number> contact_path(const TeethRange& range, int mesh) {
  const auto& [least, most] = range;
  if (mesh == 0) {
    return {external_path<Number>(least.sun, most.sun),
            external_path<Number>(least.planet_1, most.planet_1)};
  }
  return {external_path<Number>(planet(least, mesh), planet(most, mesh)),
          ring_path<Number>(ring(least, mesh), ring(most, mesh))};
}

template ContactPath<Interval> contact_path(const TeethRange&, int);
template ContactPath<RoughInterval> contact_path(const TeethRange&, int);

Interval contact_ratio(const TeethRange& range, int mesh) {
  const auto path = contact_path<Interval>(range, mesh);
  return path.first + path.mate;
}

}  // namespace torquewright::gearbox::proof
