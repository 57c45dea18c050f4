// SPDX-License-Identifier: Apache-2.0
#include "tests/simulation/simple_drive.hpp"

#include <utility>

#include "actuator/effects/library.hpp"
#include "simulation/plants/dynamometer.hpp"
#include "simulation/plants/serial_arm.hpp"
#include "simulation/plants/single_joint.hpp"

namespace torquewright::simulation {

actuator::Actuator simple_actuator() {
  actuator::Actuator actuator;
  actuator.motor.torque_constant_Nm_A = 0.1;
  actuator.motor.resistance_ohm = 0.5;
  actuator.motor.rotor_inertia_kg_m2 = 1e-4;
  actuator.drive.bus_voltage_V = 48.0;
  actuator.drive.peak_current_A = 40.0;
  actuator.transmission.ratio = 10.0;
  return actuator;
}

std::unique_ptr<Plant> simple_plant(Load load) {
  switch (load) {
    case Load::kFree:
      return std::make_unique<SingleJoint>(0.02);
    case Load::kPendulum:
      return std::make_unique<SingleJoint>(0.02 + 1.0 * 0.3 * 0.3, 1.0 * 9.81 * 0.3);
    case Load::kLinearAxis:
      return std::make_unique<SingleJoint>(1.0);
    case Load::kDynamometer:
      break;
  }
  return std::make_unique<Dynamometer>();
}

std::unique_ptr<Plant> simple_arm() {
  std::vector<dynamics::SerialLink> links = {{1.0, 0.3, 0.15, 0.01}, {0.6, 0.25, 0.12, 0.005}};
  return std::make_unique<SerialArm>(std::move(links), 9.81);
}

actuator::Effect effect(std::string_view name, std::vector<double> values) {
  actuator::Effect effect;
  effect.kind = actuator::find_effect(name);
  effect.values = std::move(values);
  return effect;
}

actuator::Effect harmonic_effect(std::string_view name, std::vector<actuator::Harmonic> harmonics,
                                 bool proportional) {
  actuator::Effect made = effect(name, {});
  made.harmonics = std::move(harmonics);
  made.proportional = proportional;
  return made;
}

Excitation excitation(double duration_s, double step_s, const std::function<double(double)>& drive,
                      DriveKind kind) {
  Excitation made;
  made.joints.resize(1);
  made.joints[0].kind = kind;
  const int count = static_cast<int>(duration_s / step_s + 0.5);
  for (int i = 0; i <= count; ++i) {
    made.time_s.push_back(i * step_s);
    made.joints[0].value.push_back(drive(i * step_s));
  }
  return made;
}

SimulatedRun run(Load load, const actuator::Actuator& actuator, const Excitation& excitation,
                 const JointStart& start, double longest_step_s) {
  SimulationOptions options;
  options.longest_step_s = longest_step_s;
  return simulate(*simple_plant(load), {&actuator}, excitation, {start}, options);
}

}  // namespace torquewright::simulation
