// SPDX-License-Identifier: Apache-2.0
// Fields: SDFormat 1.11, sdf/1.11/joint.sdf of gazebosim/sdformat at commit 93e497e0: <axis> with
// <limit><effort> ("for enforcing the maximum joint effort applied"), <limit><velocity> and
// <dynamics><damping>, <friction> ("physical static friction value"). A box, as of URDF: N m,
// rad/s, N m s/rad.
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

constexpr ShapeParameter kParameters[] = {{"greatest_torque_Nm"}, {"greatest_speed_rad_s"}};

Shape shape(const Subject& subject) { return urdf.shape(subject); }

TorqueLimits law(std::span<const double> shape, double speed_rad_s) {
  return urdf.law(shape, speed_rad_s);
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const JointFriction friction = subject.friction.value_or(JointFriction{});
  return xml_comment(note) + fmt::format(R"(<sdf version="1.11">
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
        <dynamics>
          <damping>{3}</damping>
          <friction>{4}</friction>
        </dynamics>
      </axis>
    </joint>
  </model>
</sdf>
)",
                                         xml_quoted(subject.actuator.name), shape[0], shape[1],
                                         friction.viscous_Nm_s_rad, friction.coulomb_Nm);
}

}  // namespace

const Exporter sdf = {
    .name = "sdf",
    .simulator = "Gazebo, SDFormat 1.11 <axis>",
    .source = "https://github.com/gazebosim/sdformat sdf/1.11/joint.sdf",
    .advice =
        "A box is not an operating region: a plan inside it may ask for torque that the motor does "
        "not have. Whether a physics engine of Gazebo enforces effort and velocity is its own "
        "matter. SDFormat has no field for the armature: add it to the link's inertia about the "
        "axis.",
    .parameters = kParameters,
    .shape = shape,
    .law = law,
    .write = write,
    .friction = {DryFriction::kOneValue,
                 "damping is in Nm s/rad; friction, in Nm, is called static, and engines take it "
                 "for Coulomb's.",
                 ""},
};

}  // namespace torquewright::actuator::exporters
