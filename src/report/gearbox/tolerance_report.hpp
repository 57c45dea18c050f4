// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearbox/tolerances/drawn_builds.hpp"
#include "gearbox/tolerances/worst_case.hpp"
#include "hopper/trials/success_rate.hpp"

namespace torquewright::report {

/// What parts' tolerances make of a design.
struct ToleranceReport {
  std::string name;
  gearbox::ToleratedTrain train;
  gearbox::DrawOptions options;
  gearbox::BuildDemands demands;
  std::optional<double> min_yield;
  gearbox::DrawnBuilds drawn;
  std::vector<gearbox::MeshWorstCase> meshes;
  gearbox::WorstCase output_rad;
  std::vector<double> shares;  ///< Of each limit in the variance of the output's backlash.

  double yield() const {
    return static_cast<double>(drawn.good) / static_cast<double>(drawn.builds);
  }
  hopper::ShareInterval yield_interval() const {
    return hopper::wilson_interval(drawn.good, drawn.builds);
  }
};

enum class YieldVerdict { kNone, kReached, kMissed, kOpen };

/// By Wilson's interval: open where the demanded yield lies within it.
YieldVerdict verdict_of(const ToleranceReport& report);

/// Where the limits come from that nobody stated.
extern const char* const kLimitSources;

}  // namespace torquewright::report
