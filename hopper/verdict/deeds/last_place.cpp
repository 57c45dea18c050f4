// SPDX-License-Identifier: Apache-2.0
#include "hopper/verdict/every_deed.hpp"
#include "hopper/verdict/place_deed.hpp"

namespace torquewright::hopper {

std::vector<Deed> last_place(const Attempt& attempt) {
  const TouchingPoints& touches = attempt.reference.modes().back().touches;
  if (!touches.any()) return {};
  Deed deed = place_deed(attempt, touches, attempt.reference.ends_s(), attempt.record.end_s);
  deed.name = "last_place";
  deed.sentence += " at the end";
  return {deed};
}

}  // namespace torquewright::hopper
