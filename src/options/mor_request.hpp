// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "actuator/mor/mor_table.hpp"
#include "actuator/mor/need.hpp"
#include "actuator/region/joint_region.hpp"
#include "src/options/operating_options.hpp"

namespace torquewright::cli {

/// The options by which `actuator mor` draws.
struct MorPlotOptions {
  std::string file;
  std::vector<double> voltages_V;  ///< Drawn over the region that was asked for.
  std::vector<double> temperatures_K;
};

/// What `actuator mor` is asked, in the words of the command line.
struct MorRequest {
  std::string actuator_file;
  OperatingOptions operating;
  std::string side = "joint";
  std::string format;    ///< Empty: none was named.
  std::string fit;       ///< Empty: none was named, which is conservative.
  std::string friction;  ///< Empty: wherever the simulator can have it.
  double accuracy = actuator::kTableAccuracy;
  std::vector<double> speeds_rad_s;
  std::string need;  ///< TORQUE@SPEED
  std::optional<double> lever_m;
  std::string ratios;  ///< LOW:HIGH
  std::string compare_file;
  std::string output_file;
  std::string export_file;
  MorPlotOptions plot;
  bool table = false;
  bool watch = false;
  bool json = false;
};

/// Adds everything that `actuator mor` takes.
void add_mor_options(command_line::Command& command, MorRequest& request);

actuator::Side side_of(const MorRequest& request);

/// Asked for by --json, by --format, by the ending of -o, or by --export beside -o.
bool is_json(const MorRequest& request);

/// Throws io::SpecError where what was asked for does not go together.
void require_formats(const MorRequest& request);

/// Throws io::SpecError where the table could not be so accurate.
void require_accuracy(const MorRequest& request);

/// Nothing where none was stated. Throws io::SpecError for what is no need.
std::optional<actuator::Need> need_of(const MorRequest& request);

/// Least and greatest of the gear ratios to be tried. Throws io::SpecError for what is no range.
std::pair<double, double> ratio_range_of(const MorRequest& request);

}  // namespace torquewright::cli
