// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/report/identification/identification_words.hpp"
#include "src/report/identification/robot_report.hpp"

namespace torquewright::report {

/// An actuator's region as stated and refined.
struct RegionSection {
  std::string joint;       ///< Empty unless a serial arm.
  std::string plot;        ///< A script for gnuplot, as SVG.
  std::string comparison;  ///< As text.
};

/// An identification as a page that holds all of its styles and pictures; what users wrote is
/// escaped. `robot`: where the rig's load is one that was simulated. Draws with gnuplot: throws
/// io::SpecError for --report where that is not installed.
std::string identification_html(const identification::Identification& found,
                                const IdentificationContext& context,
                                const std::vector<RegionSection>& regions,
                                const RobotReport* robot = nullptr);

}  // namespace torquewright::report
