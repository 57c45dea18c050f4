// SPDX-License-Identifier: Apache-2.0
// Drake's JointActuator knows a box alone; a curve is a LeafSystem between controller and plant
// (RobotLocomotion/drake, systems/framework/leaf_system.h at commit 9e4de0b0:
// DeclareVectorInputPort, DeclareVectorOutputPort; issues 10725, 14735, 24110). N m, rad/s. Rotor
// inertia and gear ratio belong to the JointActuator (set_default_rotor_inertia,
// set_default_gear_ratio).
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/table_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const std::string name = identifier(subject.actuator.name);
  return line_comment(note, "// ") + fmt::format(R"(#pragma once

#include <algorithm>
#include <drake/systems/framework/leaf_system.h>
#include <utility>

{0}
/// Commanded torque and joint speed in, deliverable torque out: between controller and plant.
class {1}_limiter final : public drake::systems::LeafSystem<double> {{
 public:
  {1}_limiter() {{
    this->DeclareVectorInputPort("commanded_torque", 1);
    this->DeclareVectorInputPort("joint_speed", 1);
    this->DeclareVectorOutputPort("torque", 1, &{1}_limiter::CalcTorque);
  }}

 private:
  void CalcTorque(const drake::systems::Context<double>& context,
                  drake::systems::BasicVector<double>* output) const {{
    const double torque = this->get_input_port(0).Eval(context)[0];
    const double speed = this->get_input_port(1).Eval(context)[0];
    const auto [least, greatest] = {1}_torque_limits(speed);
    output->SetAtIndex(0, std::clamp(torque, least, greatest));
  }}
}};
)",
                                                 table_function(name + "_torque_limits", shape),
                                                 name);
}

}  // namespace

const Exporter drake = {
    .name = "drake",
    .simulator = "Drake, C++ LeafSystem",
    .source = "https://github.com/RobotLocomotion/drake systems/framework/leaf_system.h @ 9e4de0b0",
    .advice =
        "Leave the JointActuator's effort_limit at least as large as the greatest torque; give it "
        "rotor inertia and gear ratio instead of an armature.",
    .parameters = {},
    .shape = table_shape,
    .law = table_law,
    .write = write,
};

}  // namespace torquewright::actuator::exporters
