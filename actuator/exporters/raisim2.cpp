// SPDX-License-Identifier: Apache-2.0
// Fields and law: raisim2Lib, docs/sections/Actuators.rst at commit fa53dfd3. <motor_group
// gear_ratio bus_voltage> with one <motor resistance torque_constant velocity_constant
// peak_torque>, all at the rotor, SI (velocity_constant in rad/s/V). -V <= R/Kt torque + speed/Kv
// <= V and |torque| <= peak. "Beyond the overspeed limit ... the only physical torque left is the
// voltage limit closest to the peak band": the region is that point.
// output_damping (N m s/rad) and output_friction (N m) of <motor> are at the joint
// (docs/sections/articulated_system/JointDampingAndFriction.rst at commit 4cd815d1).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

Shape shape(const Subject& subject) { return fitted(subject, raisim2, line_start(subject)); }

TorqueLimits law(std::span<const double> shape, double speed_rad_s) {
  const Parallelogram line = parallelogram_of(shape);
  const double drop_Nm = line.stall_torque_Nm / line.no_load_speed_rad_s * speed_rad_s;
  const TorqueLimits voltage{-line.stall_torque_Nm - drop_Nm, line.stall_torque_Nm - drop_Nm};
  const double peak_Nm = line.greatest_torque_Nm;
  if (voltage.greatest_Nm < -peak_Nm) return {voltage.greatest_Nm, voltage.greatest_Nm};
  if (voltage.least_Nm > peak_Nm) return {voltage.least_Nm, voltage.least_Nm};
  return {std::max(voltage.least_Nm, -peak_Nm), std::min(voltage.greatest_Nm, peak_Nm)};
}

std::string friction_attributes(const std::optional<JointFriction>& friction) {
  if (!friction) return "";
  return fmt::format(" output_damping=\"{}\" output_friction=\"{}\"", friction->viscous_Nm_s_rad,
                     friction->coulomb_Nm);
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const Parallelogram line = parallelogram_of(shape);
  const double bus_V = subject.bus_voltage_V();
  const double ratio = std::abs(subject.ratio());
  const double velocity_constant_rad_s_V = line.no_load_speed_rad_s * ratio / bus_V;
  // Only Kt / R has an effect. Kt = 1 / Kv is the motor without losses.
  const double torque_constant_Nm_A = 1.0 / velocity_constant_rad_s_V;
  const double resistance_ohm = torque_constant_Nm_A * bus_V * ratio / line.stall_torque_Nm;
  return xml_comment(note) +
         fmt::format(R"(<motor_group name={0} gear_ratio="{1}" bus_voltage="{2}">
  <motor resistance="{3}" torque_constant="{4}" velocity_constant="{5}" peak_torque="{6}"{7}/>
</motor_group>
)",
                     xml_quoted(subject.actuator.name), subject.ratio(), bus_V, resistance_ohm,
                     torque_constant_Nm_A, velocity_constant_rad_s_V,
                     line.greatest_torque_Nm / ratio, friction_attributes(subject.friction));
}

}  // namespace

const Exporter raisim2 = {
    .name = "raisim2",
    .simulator = "RaiSim 2, motor_group file",
    .source = "https://github.com/jhwangbo/raisim2Lib docs/sections/Actuators.rst @ fa53dfd3",
    .advice =
        "All values are at the rotor. Link it in the URDF: <actuator name=... joints=... "
        "file=.../>, "
        "put the armature into the joint's <dynamics rotor_inertia=.../>, leave output_damping and "
        "output_friction out, and make the joint's effort no smaller than the greatest torque. "
        "Past "
        "the overspeed RaiSim 2 follows the voltage limit, which exceeds the peak torque.",
    .parameters = kLineParameters,
    .shape = shape,
    .law = law,
    .write = write,
    .friction =
        {DryFriction::kOneValue,
         "output_damping and output_friction are at the joint, behind the gear, and Coulomb's "
         "at rest and in motion "
         "(docs/sections/articulated_system/JointDampingAndFriction.rst @ 4cd815d1).",
         "All other values are at the rotor. Link it in the URDF: <actuator name=... "
         "joints=... file=.../>, put the armature into the joint's <dynamics "
         "rotor_inertia=.../>, whose damping and friction would add to these, and make the "
         "joint's effort no smaller than the greatest torque. Past the overspeed RaiSim 2 "
         "follows the voltage limit, which exceeds the peak torque."},
};

}  // namespace torquewright::actuator::exporters
