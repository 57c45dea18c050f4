// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "hopper/verdict/every_deed.hpp"

namespace torquewright::hopper {

std::vector<Deed> flight_times(const Attempt& attempt) {
  std::vector<Deed> deeds;
  for (std::size_t i = 0; i < attempt.flights.size(); ++i) {
    const MatchedFlight& flight = attempt.flights[i];
    if (!flight.begins_in_motion) continue;  // its take-off was not the run's to make
    Deed& deed = deeds.emplace_back();
    deed.name = "flight";
    deed.of = fmt::format("flight {}", i + 1);
    deed.unit = "s";
    deed.planned = flight.planned.duration_s();
    deed.done = flight.flown ? flight.flown->duration_s() : 0.0;
    deed.off = std::abs(deed.done - deed.planned);
    deed.tolerance = attempt.tolerances.share * deed.planned;
    deed.is_done = deed.off <= deed.tolerance;
    deed.sentence =
        fmt::format("{} lasts {:.1f} of {:.1f} ms", deed.of, 1e3 * deed.done, 1e3 * deed.planned);
  }
  return deeds;
}

}  // namespace torquewright::hopper
