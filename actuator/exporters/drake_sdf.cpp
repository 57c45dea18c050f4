// SPDX-License-Identifier: Apache-2.0
// Elements: Drake, drake.mit.edu/doxygen_cxx/group__multibody__parsing.html, and its
// multibody/parsing/detail_sdf_parser.cc, AddJointActuatorFromSpecification: <limit><effort>
// becomes the JointActuator's effort_limit, where 0 means no actuator at all and what is negative
// no limit; drake:rotor_inertia (kg m^2) and drake:gear_ratio stand in <joint>, and the plant adds
// gear_ratio^2 rotor_inertia to the joint. A joint of Drake's has damping and no dry friction. A
// box, as of URDF: N m, rad/s.
#include <fmt/format.h>

#include <cmath>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

constexpr ShapeParameter kParameters[] = {{"greatest_torque_Nm"}, {"greatest_speed_rad_s"}};

Shape shape(const Subject& subject) { return urdf.shape(subject); }

TorqueLimits law(std::span<const double> shape, double speed_rad_s) {
  return urdf.law(shape, speed_rad_s);
}

/// The armature as what turns at the rotor; left out where nobody states an inertia.
std::string rotor_elements(const Subject& subject) {
  const double armature_kg_m2 = subject.armature_kg_m2();
  if (armature_kg_m2 == 0.0) return "";
  const double ratio = std::abs(subject.ratio());
  return fmt::format(R"(
      <drake:rotor_inertia>{}</drake:rotor_inertia>
      <drake:gear_ratio>{}</drake:gear_ratio>)",
                     armature_kg_m2 / (ratio * ratio), ratio);
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  return xml_comment(note) + fmt::format(R"(<sdf version="1.9" xmlns:drake="https://drake.mit.edu">
  <model name={0}>
    <link name="base"/>
    <link name="link"/>
    <joint name="joint" type="continuous">
      <parent>base</parent>
      <child>link</child>
      <axis>
        <xyz>0 0 1</xyz>
        <limit>
          <effort>{1}</effort>
          <velocity>{2}</velocity>
        </limit>
      </axis>{3}
    </joint>
  </model>
</sdf>
)",
                                         xml_quoted(subject.actuator.name), shape[0], shape[1],
                                         rotor_elements(subject));
}

}  // namespace

const Exporter drake_sdf = {
    .name = "drake-sdf",
    .simulator = "Drake, SDFormat with drake: elements",
    .source =
        "https://drake.mit.edu/doxygen_cxx/group__multibody__parsing.html; "
        "https://github.com/RobotLocomotion/drake multibody/parsing/detail_sdf_parser.cc "
        "(AddJointActuatorFromSpecification)",
    .advice =
        "A box is not an operating region: a plan inside it may ask for torque that the motor does "
        "not have; the format drake writes the region as a system before the plant. The plant "
        "clips "
        "to the effort and has no dry friction of joints; the velocity is for whoever plans.",
    .parameters = kParameters,
    .shape = shape,
    .law = law,
    .write = write,
    .inertia_at_rotor = true,
};

}  // namespace torquewright::actuator::exporters
