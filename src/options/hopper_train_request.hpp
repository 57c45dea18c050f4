// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "src/options/operating_options.hpp"

namespace torquewright::cli {

/// What `hopper train` is asked, in the words of the command line. An empty name of a file: not
/// asked for.
struct HopperTrainRequest {
  std::string robot_file;
  std::string task = "flip";
  std::string limits = "mor";
  std::string engine = "own";
  std::string randomise_file;
  bool eases = false;  ///< Whether the randomisation comes by and by.
  std::string reference_file;
  OperatingOptions operating;
  double seconds = 600.0;
  std::uint64_t iterations = 0;  ///< 0: as many as the time allows.
  std::uint64_t seed = 1;
  int threads = 1;
  int judged_every = 10;
  std::uint64_t judged_runs = 10;
  bool resume = false;
  std::string policy_file;
  std::string curve_file;
};

/// Adds everything that `hopper train` takes.
void add_hopper_train_options(command_line::Command& command, HopperTrainRequest& request);

}  // namespace torquewright::cli
