// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "hopper/verdict/every_deed.hpp"

namespace torquewright::hopper {

// How far above its start the centre of mass gets in a flight. Not above its take-off: when that
// was, motions without forces say to some milliseconds only, and a low hop rises little more than
// that. A free flight of the planned time rises by g T^2/8, of which it may be off by twice the
// share.
std::vector<Deed> rises(const Attempt& attempt) {
  std::vector<Deed> deeds;
  for (std::size_t i = 0; i < attempt.flights.size(); ++i) {
    const MatchedFlight& flight = attempt.flights[i];
    if (!flight.begins_in_motion) continue;  // its take-off was not the run's to make
    const double time_s = flight.planned.duration_s();
    Deed& deed = deeds.emplace_back();
    deed.name = "rise";
    deed.of = fmt::format("flight {}", i + 1);
    deed.unit = "m";
    deed.planned = attempt.planned_path.rise_m(flight.planned);
    deed.done = attempt.run_path.rise_m(flight.flown.value_or(flight.planned));
    deed.off = std::abs(deed.done - deed.planned);
    deed.tolerance =
        2.0 * attempt.tolerances.share * attempt.robot.tree.gravity_m_s2 * time_s * time_s / 8.0;
    deed.is_done = deed.off <= deed.tolerance;
    deed.sentence = fmt::format("the centre of mass gets {:.1f} of {:.1f} mm above its start in {}",
                                1e3 * deed.done, 1e3 * deed.planned, deed.of);
  }
  return deeds;
}

}  // namespace torquewright::hopper
