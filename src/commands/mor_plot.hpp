// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "actuator/region/joint_region.hpp"

namespace torquewright::cli {

/// The options by which `actuator mor` draws.
struct MorPlotOptions {
  std::string file;
  std::vector<double> voltages_V;  ///< Drawn over the region that was asked for.
  std::vector<double> temperatures_K;
};

/// Adds --plot, --plot-voltage and --plot-temperature.
void add_mor_plot_options(CLI::App& command, MorPlotOptions& options);

/// Draws the region under the conditions; over it, dashed, the continuous rating where the document
/// has one, and what other voltages and temperatures make of it. Throws io::SpecError.
void draw_region(const MorPlotOptions& options, const actuator::Actuator& actuator,
                 const actuator::OperatingConditions& conditions, actuator::Side side);

}  // namespace torquewright::cli
