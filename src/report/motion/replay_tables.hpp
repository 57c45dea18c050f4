// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/motion/replay_page.hpp"

namespace torquewright::report {

/// Tables of a replay's page; empty where there is nothing to tell.
std::string end_table(const ReplayPage& page);
/// Which of the things that vary in trials the robot does not bear, each alone; empty: not tried.
std::string causes_table(const ReplayPage& page);
/// The same run with other steps of the engine.
std::string sweep_table(const ReplayPage& page);
std::string replayed_drives_table(const ReplayPage& page);
/// What passes the gears beside limits, and what the contacts ask for.
std::string loads_table(const ReplayPage& page);
std::string replay_findings_table(const ReplayPage& page);

}  // namespace torquewright::report
