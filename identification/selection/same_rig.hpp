// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/selection/model_fit.hpp"

namespace torquewright::identification {

/// Returns why the runs do not belong to one rig: a value that the rig calls uncertain, fitted to
/// single runs with all else as fitted to all, differs by more than its errors allow. Empty:
/// nothing speaks against it. `name_of_run` is by Signals::run; runs of one name are one
/// (docs/derivations/identification.md section 8).
std::string runs_that_disagree(const ForwardEquation& equation, const Rows& rows,
                               const ModelFit& fit, const std::vector<std::string>& name_of_run);

}  // namespace torquewright::identification
