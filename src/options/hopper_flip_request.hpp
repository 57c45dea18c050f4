// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hopper/planning/search/plan.hpp"
#include "hopper/planning/tasks/reserve.hpp"
#include "src/options/hopper_check_request.hpp"

namespace torquewright::cli {

/// How often the plans of a sweep, or of a search for a reserve, are replayed, each time as another
/// robot.
struct SweptTrials {
  std::uint64_t count = 0;  ///< 0: not at all.
  std::string randomise_file;
  std::uint64_t seed = 1;
  std::string controller = "lqr";
  std::string engine = "own";
};

/// What `hopper flip` is asked, in the words of the command line (hopper_flip_options.hpp). An
/// empty name of a file: not asked for.
struct HopperFlipRequest {
  /// Its command's options, of which results state some (command_line/option_echo.hpp).
  const command_line::DeclaredCommand* declared = nullptr;
  std::string task = "flip";
  std::string limits = "mor";
  std::optional<double> rise_m;         ///< Empty: the task's, if it has one.
  std::optional<double> stride_m;       ///< Likewise.
  std::optional<double> speed_m_s;      ///< Empty: free.
  std::vector<std::string> objectives;  ///< NAME[=WEIGHT]; empty: the task's.
  hopper::PlanOptions plan;             ///< What has an option of its own.
  /// The margin of each part (hopper::margin_parts()); empty: the usual one, or what the reserve
  /// makes of it.
  std::vector<std::optional<double>> margins =
      std::vector<std::optional<double>>(hopper::margin_parts().size());
  std::uint64_t guess_seed = 0;
  /// Robot and conditions; its motion, where one is named, is what is begun from.
  HopperCheckRequest warm;
  SweepOptions sweep;
  SweptTrials trials;
  std::string robust_file;  ///< Of kind randomisation, by whose trials the reserve is chosen.
  std::string motion_file;  ///< Of a sweep: its result.
  std::string best_file;    ///< For what comes closest where there is no plan.
  std::string momentum_file;
  std::string figures_file;
  std::string report_file;
  bool json = false;
  bool timing = false;
};

/// The weighted objectives that NAME[=WEIGHT] state. Throws io::SpecError, with the nearest name,
/// for one that there is not, that stands twice, or whose weight is no positive number.
std::vector<hopper::WeightedObjective> read_objectives(const std::vector<std::string>& texts);

}  // namespace torquewright::cli
