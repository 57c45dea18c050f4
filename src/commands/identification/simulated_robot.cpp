// SPDX-License-Identifier: Apache-2.0
#include "src/commands/identification/simulated_robot.hpp"

#include <fmt/format.h>

#include "src/report/parts/progress_line.hpp"

namespace torquewright::cli {
namespace {

using Actuators = std::vector<const actuator::Actuator*>;

}  // namespace

std::optional<identification::SimulatedErrors> simulated_errors(const IdentifyRequest& request,
                                                                const IdentifyInputs& inputs,
                                                                const RefinedActuators& refined) {
  if (!identification::can_roll_out(inputs.rig)) return std::nullopt;
  const identification::Log log =
      identification::read_log({request.logs.begin(), request.logs.end()}, inputs.rig);
  report::ProgressLine progress;
  const auto run = [&](const char* what, const Actuators& actuators) {
    return identification::roll_out(
        inputs.rig, log, actuators, identification::kWindows_s, identification::kMostWindows,
        [&](double share) {
          progress.show(fmt::format("simulating the robot {}: {:.0f} %", what, 100.0 * share));
        });
  };
  Actuators stated, changed;
  for (const auto& each : inputs.actuators) stated.push_back(&each.nominal.actuator);
  for (const RefinedActuator& each : refined.of_joints) changed.push_back(&each.read.actuator);
  identification::SimulatedErrors errors{inputs.rig.joints, run("as stated", stated), {}};
  if (!changed.empty()) errors.after = run("as refined", changed);
  return errors;
}

}  // namespace torquewright::cli
