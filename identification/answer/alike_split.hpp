// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/motor/actuator.hpp"
#include "identification/log/log.hpp"
#include "identification/selection/analysis_options.hpp"

namespace torquewright::identification {

/// Splits the runs of a log anew where the rig names none to hold out and the last third shows far
/// more, or far less, of what the stated actuators leave than the rest: no fit could learn it, or
/// nothing confirm it. Then every third run is held out in the order of what is left in them, so
/// that both parts have as much to be explained (docs/logs.md).
/// `options`: those of the analysis that follows, whose bands and interruptions hold here too.
/// Requires that the hold-out is chosen; a log of one or two runs stays as it is.
void split_alike(Log& log, const Rig& rig, const std::vector<const actuator::Actuator*>& actuators,
                 AnalysisOptions options = {});

}  // namespace torquewright::identification
