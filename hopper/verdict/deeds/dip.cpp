// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "hopper/verdict/every_deed.hpp"

namespace torquewright::hopper {

namespace {

constexpr double kSway_m = 0.01;  ///< A regulator that holds a posture sways by so much.

}  // namespace

// How deep the centre of mass goes below where it begins: what a squat does, and a robot whose
// drives stand still does not. Deeper is no failure: a heavier landing gives way further.
std::vector<Deed> dip(const Attempt& attempt) {
  Deed deed;
  deed.name = "dip";
  deed.unit = "m";
  deed.planned = attempt.planned_path.dip_m();
  deed.done = attempt.run_path.dip_m();
  deed.off = std::max(0.0, deed.planned - deed.done);
  deed.tolerance = std::max(kSway_m, 2.0 * attempt.tolerances.share * deed.planned);
  deed.is_done = deed.off <= deed.tolerance;
  deed.sentence = fmt::format("the centre of mass goes down by {:.1f} of {:.1f} mm",
                              1e3 * deed.done, 1e3 * deed.planned);
  if (deed.planned <= deed.tolerance) return {};  // too small to be missed
  return {deed};
}

}  // namespace torquewright::hopper
