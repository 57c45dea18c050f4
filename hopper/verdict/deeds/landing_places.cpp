// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "hopper/verdict/every_deed.hpp"
#include "hopper/verdict/place_deed.hpp"

namespace torquewright::hopper {

std::vector<Deed> landing_places(const Attempt& attempt) {
  std::vector<Deed> deeds;
  for (std::size_t i = 0; i < attempt.flights.size(); ++i) {
    const MatchedFlight& flight = attempt.flights[i];
    const ContactMode& landed =
        attempt.reference.modes()[attempt.reference.mode_at(flight.planned.until_s)];
    const double run_s = flight.has_flown() ? flight.flown->until_s : flight.planned.until_s;
    Deed deed = place_deed(attempt, landed.touches, flight.planned.until_s, run_s);
    deed.name = "landing";
    deed.of = fmt::format("flight {}", i + 1);
    deed.sentence = fmt::format("{} at the landing of {}", deed.sentence, deed.of);
    deeds.push_back(std::move(deed));
  }
  return deeds;
}

}  // namespace torquewright::hopper
