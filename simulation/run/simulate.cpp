// SPDX-License-Identifier: Apache-2.0
#include "simulation/run/simulate.hpp"

#include <stdexcept>

#include "simulation/run/run_simulation.hpp"

namespace torquewright::simulation {
namespace {

void require_sizes(const Plant& plant, std::size_t actuators, const Excitation& excitation,
                   std::size_t starts) {
  const auto joints = static_cast<std::size_t>(plant.joint_count());
  const std::size_t count = excitation.time_s.size();
  bool fits = joints > 0 && actuators == joints && excitation.joints.size() == joints &&
              starts == joints && count > 0;
  for (const JointDrive& drive : excitation.joints) {
    fits = fits && drive.value.size() == count &&
           (drive.bus_V.empty() || drive.bus_V.size() == count) &&
           (drive.enabled.empty() || drive.enabled.size() == count) &&
           (drive.winding_K.empty() || drive.winding_K.size() == count) &&
           (!plant.is_imposed() || drive.speed_rad_s.size() == count);
  }
  if (!fits) throw std::invalid_argument("simulate: sizes do not agree");
}

}  // namespace

SimulatedRun simulate(Plant& plant, const std::vector<const actuator::Actuator*>& actuators,
                      const Excitation& excitation, const std::vector<JointStart>& start,
                      const SimulationOptions& options) {
  require_sizes(plant, actuators.size(), excitation, start.size());
  return RunSimulation(plant, actuators, excitation, start, 0, options)
      .run(excitation.time_s.size() - 1);
}

SimulatedRun simulate_part(Plant& plant, const std::vector<const actuator::Actuator*>& actuators,
                           const Excitation& excitation, const std::vector<JointStart>& start,
                           std::size_t first, std::size_t last, const SimulationOptions& options) {
  require_sizes(plant, actuators.size(), excitation, start.size());
  if (first > last || last >= excitation.time_s.size()) {
    throw std::invalid_argument("simulate: no such part");
  }
  return RunSimulation(plant, actuators, excitation, start, first, options).run(last);
}

}  // namespace torquewright::simulation
