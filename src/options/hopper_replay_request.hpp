// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hopper/verdict/deed.hpp"
#include "src/options/hopper_check_request.hpp"

namespace torquewright::cli {

/// What `hopper replay` is asked, in the words of the command line. An empty name of a file: not
/// asked for.
struct HopperReplayRequest {
  HopperCheckRequest motion;  ///< Robot, motion and how it is read, conditions.
  /// Its command's options, of which results state some (command_line/option_echo.hpp).
  const command_line::DeclaredCommand* declared = nullptr;
  std::string engine = "own";
  std::string limits = "mor";
  std::string controller = "lqr";
  std::string tasks_file;  ///< Of a controller that weighs tasks; empty: the robot's usual.
  std::string impact = "default";
  std::string impact_metric = "euclidean";
  std::string impact_contact = "first";
  bool fixed_clock = false;
  double impact_window_s = 0.05;
  double impact_blend_s = 0.005;
  double step_s = 1e-4;
  double control_period_s = 5e-4;
  double latency_s = 0.0;
  double stand_s = 1.0;
  double ground_rise_m = 0.0;
  std::optional<double> contact_time_constant_s;
  std::vector<std::string> pushes;    ///< As read_pushes() takes them.
  std::string task;                   ///< Of a policy; empty: as its document says.
  std::optional<double> forward_m_s;  ///< Command to a policy or a controller that follows one.
  hopper::DeedTolerances deeds;
  bool sweep = false;
  std::uint64_t trials = 0;  ///< 0: one run as documented.
  std::string randomise_file;
  std::uint64_t seed = 1;
  std::int64_t only_trial = -1;  ///< Negative: all.
  double success_rate = 1.0;
  bool without_filter = false;
  bool explains = false;    ///< Whether each thing that varies is tried alone as well.
  PointOptions points;      ///< Of trials by processes.
  std::size_t threads = 0;  ///< 0: as many as the processor runs at once.
  std::string report_file;
  std::string series_file;
  std::string output_file;
  bool json = false;
};

/// Adds everything that `hopper replay` takes.
void add_hopper_replay_options(command_line::Command& command, HopperReplayRequest& request);

}  // namespace torquewright::cli
