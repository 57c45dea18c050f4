// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/demand/checked_motion.hpp"
#include "hopper/motion/bare_rows.hpp"
#include "src/options/operating_options.hpp"
#include "src/options/severity_option.hpp"
#include "src/options/sweep_options.hpp"
#include "src/options/window_options.hpp"

namespace torquewright::cli {

/// What `hopper check` is asked, in the words of the command line. An empty name of a file: not
/// asked for.
struct HopperCheckRequest {
  std::string command_group = "hopper";  ///< Under which word the command was called.
  std::string robot_file;
  std::string trajectory_file;
  std::vector<std::string> columns;  ///< NAME=OWNER.QUANTITY[:unit][*factor]
  std::vector<std::string> columns_files;
  hopper::BareRows bare;
  int hops = 0;  ///< Flights that the motion is made to have; 0: as it is.
  WindowOptions window;
  OperatingOptions operating;
  hopper::CheckOptions check;  ///< The numbers that have an option of their own.
  /// Its command's options, of which results state some (command_line/option_echo.hpp).
  const command_line::DeclaredCommand* declared = nullptr;
  std::string torques = "best";
  std::string late_columns = "find";
  std::string candidates_folder;
  std::string ratios;  ///< FROM:TO[:STEP]
  std::size_t threads = 1;
  SweepOptions sweep;
  std::string plot_file;
  std::string loads_file;
  std::string momentum_file;
  std::string figures_file;
  std::string report_file;
  std::string series_file;
  std::string output_file;
  SeverityOption severity;
  bool all = false;  ///< Every drive and finding, not one screen.
  bool watch = false;
  bool json = false;
};

/// Adds what says which of a motion's columns and rows are read. `of`, where it is not empty, names
/// the option that must be there too.
void add_column_options(command_line::Command& command, HopperCheckRequest& request,
                        const std::string& of = "");
/// Adds the options of columns and rows, and which of its torques and late rows count.
void add_motion_options(command_line::Command& command, HopperCheckRequest& request);
/// Adds what says where the ground is and which points touch it.
void add_contact_options(command_line::Command& command, hopper::ContactRule& contact);

/// Adds --load-window.
command_line::Option add_load_window(command_line::Command& command, hopper::CheckOptions& check);

/// Adds everything that `hopper check` takes.
void add_hopper_check_options(command_line::Command& command, HopperCheckRequest& request);

}  // namespace torquewright::cli
