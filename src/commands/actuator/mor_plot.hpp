// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/mor/need.hpp"
#include "actuator/region/joint_region.hpp"
#include "src/options/mor_request.hpp"
#include "src/report/parts/gnuplot.hpp"

namespace torquewright::cli {

/// A region of a picture, and what it is called there.
struct Overlay {
  std::string label;
  actuator::OperatingConditions conditions;
};

/// The region under the conditions; its continuous rating where the document has one; and what
/// other voltages and temperatures make of it. Throws io::SpecError where the actuator cannot be
/// under one of them.
std::vector<Overlay> overlays_of(const MorPlotOptions& options, const actuator::Actuator& actuator,
                                 const actuator::OperatingConditions& conditions);

/// A need and the first region's distance to it.
struct AnsweredNeed {
  actuator::Need need;
  actuator::NeedAnswer answer;
};

/// A script for gnuplot: the first of the regions shaded, the others dashed over it, and what is
/// needed.
std::string region_plot_of(report::PlotFormat format, const actuator::Actuator& actuator,
                           const std::vector<Overlay>& overlays, actuator::Side side,
                           const std::optional<AnsweredNeed>& needed = std::nullopt);

}  // namespace torquewright::cli
