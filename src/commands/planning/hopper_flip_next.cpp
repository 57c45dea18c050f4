// SPDX-License-Identifier: Apache-2.0
#include "src/commands/planning/hopper_flip_next.hpp"

#include <fmt/format.h>

#include "src/interrupt.hpp"
#include "src/report/parts/shell_word.hpp"

namespace torquewright::cli {
namespace {

/// The conditions that a check or a replay must be told too.
std::string conditions(const HopperFlipRequest& request) {
  const OperatingOptions& operating = request.warm.operating;
  const OperatingOptions usual;
  std::string text;
  const auto add = [&text](const char* option, const auto& value, const auto& unless) {
    if (value != unless) text += fmt::format(" {} {}", option, value);
  };
  add("--rating", operating.rating, usual.rating);
  add("--bus-voltage", operating.bus_voltage_V, usual.bus_voltage_V);
  add("--state-of-charge", operating.state_of_charge, usual.state_of_charge);
  add("--winding-temperature", operating.winding_temperature_K, usual.winding_temperature_K);
  add("--load-window", request.warm.check.load_window_s, hopper::CheckOptions().load_window_s);
  return text;
}

std::vector<std::string> after_a_plan(const HopperFlipRequest& request) {
  const std::string files = report::shell_word(request.warm.robot_file) + " " +
                            report::shell_word(request.motion_file) + conditions(request);
  std::vector<std::string> lines{"torquewright hopper check " + files,
                                 "torquewright hopper replay " + files};
  if (request.limits == "box") {
    lines.back() += " --limits box";
    lines.push_back("torquewright hopper replay " + files + "   (within the drives' true regions)");
  }
  return lines;
}

}  // namespace

std::vector<std::string> next_commands(const HopperFlipRequest& request,
                                       const hopper::PlanResult& result) {
  if (result.status == hopper::PlanStatus::kPlanned) return after_a_plan(request);
  std::vector<std::string> lines;
  if (is_interrupted()) {
    lines.push_back("the same command begins anew");
  } else if (result.status == hopper::PlanStatus::kLimit) {
    lines.push_back(
        fmt::format("--time-limit {:g} gives it more time", 2.0 * request.plan.most_seconds));
  } else {
    lines.push_back(
        fmt::format("--guess-noise {:g} --seed {} begins elsewhere",
                    request.plan.guess_noise_rad > 0.0 ? request.plan.guess_noise_rad : 0.1,
                    request.guess_seed + 1));
    lines.push_back("--warm FILE begins from a motion that is near to what is wanted");
    if (!request.plan.explain) {
      lines.push_back(
          "--explain looks for the smallest change of voltage, current, mass or a ratio that "
          "makes a plan");
    }
  }
  if (request.best_file.empty()) {
    lines.push_back("--write-best FILE writes the motion that comes closest");
  }
  return lines;
}

}  // namespace torquewright::cli
