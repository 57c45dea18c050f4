// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/command_line/command_line.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::cli {

/// What `hopper calibrate` is asked, in the words of the command line. An empty name of a file: not
/// asked for.
struct CalibrationRequest {
  std::string robot_file;
  std::vector<std::string> targets;   ///< cam=6.0; cav=7.4:10.6 (takeoff, tuck); cav@NAME=7.4
  std::vector<std::string> free;      ///< POINTER[,POINTER...][=LOW:HIGH]
  std::vector<std::string> postures;  ///< NAME=JOINT:POSITION,...
  /// Its command's options, of which results state some (command_line/option_echo.hpp).
  const command_line::DeclaredCommand* declared = nullptr;
  double tolerance = 0.01;
  std::string output_file;       ///< Of the report.
  std::string refined_file;      ///< Of the robot with the fitted values.
  bool is_old_spelling = false;  ///< The robot's file was named by -o.
  std::string plot_file;
  bool json = false;
};

/// Returns the request with the robot's file where it belongs: -o alone names it, as it did before
/// --refined.
CalibrationRequest with_refined(CalibrationRequest request);

/// Adds everything that `hopper calibrate` takes.
void add_calibration_options(command_line::Command& command, CalibrationRequest& request);

}  // namespace torquewright::cli
