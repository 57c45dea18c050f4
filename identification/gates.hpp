// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/balance.hpp"
#include "identification/leftover.hpp"
#include "identification/search.hpp"
#include "identification/signal_source.hpp"

namespace torquewright::identification {

/// Why a member of a model is no confident name yet; empty: it is one. A name has to explain most
/// of what can be explained, hold in runs that no fit saw, keep one amplitude over the log and its
/// parameters from run to run, and leave nothing along its own coordinate. `left`: what is left of
/// the model along each coordinate. docs/derivations/identification.md section 6.
struct Doubts {
  std::vector<std::string> of_member;
};
Doubts doubts(const Fitter& fitter, const Selection& selection, const SignalSource& source,
              const Target& target, const BandOptions& band, double floor_loss,
              const std::vector<Structure>& left);

}  // namespace torquewright::identification
