// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Chooses which runs no fit may see: those that the rig names, else the last third of the runs (at
/// least one), else the last third of the only run, which is cut there. The latter two are
/// findings. Throws io::SpecError for a name that no run has (with the nearest), where no run is
/// left to fit, and where a run has no load.
void choose_holdout(Log& log, const Rig& rig);

/// Holds out these runs in the place of those that were chosen where the rig names none; `why`
/// becomes the finding, to which the names are added.
void hold_out_instead(Log& log, const std::vector<std::string>& names, const std::string& why);

}  // namespace torquewright::identification
