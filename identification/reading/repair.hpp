// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/log/log.hpp"
#include "identification/reading/channel.hpp"

namespace torquewright::identification {

/// Counts by channel of what was repaired or masked.
struct Repairs {
  Tally wraps;      ///< Jumps of wrapped angles that were joined.
  Tally isolated;   ///< Isolated samples that were replaced and masked.
  Tally saturated;  ///< Saturated samples that were masked.
  Tally crowds;     ///< Samples that leave and return too often to be faults; left as they are.
};

/// Repairs the unambiguous faults of every run: joins wrapped angles, replaces and masks isolated
/// samples, masks saturated ones. Throws io::SpecError for a wrapped angle that turns so fast that
/// its direction cannot be told. Pieces of one stretch are each judged as a run, with the samples
/// around them in view, but for wrapped angles: whether an angle is one is judged over the whole
/// stretch, and turns are counted through it.
void repair(Runs& runs, const Rig& rig, Repairs& repairs);

void report(const Repairs& repairs, const Rig& rig, std::vector<DataFinding>& findings);

}  // namespace torquewright::identification
