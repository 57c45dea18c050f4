// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/candidates/candidates.hpp"

namespace torquewright::report {

/// What the page of a whole-body check is made of.
struct HopperPage {
  const hopper::Robot& robot;
  const hopper::Motion& motion;
  const hopper::CheckOptions& options;
  const hopper::HopperReport& report;
  const std::vector<hopper::CandidateResult>& candidates;
};

/// A page that holds its styles and pictures; what users wrote is escaped. Draws with gnuplot:
/// throws io::SpecError for --report where that is not installed. Requires kept traces.
std::string hopper_html(const HopperPage& page);

}  // namespace torquewright::report
