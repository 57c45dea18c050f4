// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/candidates/candidates.hpp"

namespace torquewright::report {

/// What pictures and the page of a whole-body check are made of.
struct HopperPage {
  const hopper::Robot& robot;
  const hopper::Motion& motion;
  const hopper::CheckOptions& options;
  const hopper::HopperReport& report;
  const std::vector<hopper::CandidateResult>& candidates;
};

}  // namespace torquewright::report
