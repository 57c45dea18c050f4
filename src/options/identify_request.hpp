// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/command_line/command_line.hpp"
#include "src/options/severity_option.hpp"

namespace torquewright::cli {

/// What `identify` and `identify residual` are asked.
struct IdentifyRequest {
  std::vector<std::string> logs;
  std::string rig_file;
  std::string robot_file;  ///< Of the robot that was moved; empty: the rig says what was.
  std::vector<std::string> actuators;  ///< FILE, or JOINT=FILE on a serial arm.
  std::vector<std::string> refined;    ///< The same for refined actuators.
  std::vector<std::string> outputs;    ///< Of -o: the report's one file.
  bool is_old_spelling = false;        ///< Refined actuators were named by -o.
  std::string report_file;
  std::vector<std::string> only, without;  ///< Effects.
  /// Its command's options, of which results state some (command_line/option_echo.hpp).
  const command_line::DeclaredCommand* declared = nullptr;
  double tolerance = 0.001;
  std::string as;  ///< An output's name; empty: the report.
  SeverityOption severity;
  bool json = false;
  bool empirical = false;
  bool select = true;
};

/// Returns the request with refined actuators' files where they belong: -o alone names them, as it
/// did before --refined. Throws io::SpecError where the report has several files.
IdentifyRequest with_refined(IdentifyRequest request);

/// Where the report goes as JSON; empty: not asked for.
std::string report_document(const IdentifyRequest& request);

/// Logs, --rig, --actuator and --json. None is required by the parser: a subcommand needs none.
void add_log_options(command_line::Command& command, IdentifyRequest& request);

/// Throws io::SpecError for the first that is missing.
void require_log_options(const IdentifyRequest& request);

}  // namespace torquewright::cli
