// SPDX-License-Identifier: Apache-2.0
// Fields: URDF, <limit effort velocity> and <dynamics damping friction> of <joint>
// (wiki.ros.org/urdf/XML/joint). A box: |torque| <= effort (N m) and |speed| <= velocity (rad/s).
// The format says nothing of the torque past that speed, which is not to be reached.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/plateau_start.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

constexpr ShapeParameter kParameters[] = {{"greatest_torque_Nm"}, {"greatest_speed_rad_s"}};

/// The greatest torque that is there both ways at every speed up to this one.
double box_torque_Nm(const Subject& subject, double speed_rad_s) {
  double torque_Nm = std::numeric_limits<double>::infinity();
  const auto restrict_to = [&](const JointRange& range) {
    if (range.is_empty) torque_Nm = 0.0;
    torque_Nm = std::min({torque_Nm, range.greatest.torque_Nm, -range.least.torque_Nm});
  };
  for (const MorRow& row : subject.table.rows) {
    if (std::abs(row.speed_rad_s) <= speed_rad_s) restrict_to(row.range);
  }
  restrict_to(subject.region.at(speed_rad_s));
  restrict_to(subject.region.at(-speed_rad_s));
  return std::max(0.0, torque_Nm - subject.table.interpolation_error_Nm);
}

/// Conservative: the box of the greatest area inside the region. Best: what datasheets are copied
/// from, peak torque and no-load speed; least squares has no meaning for a box of any width.
Shape shape(const Subject& subject) {
  if (subject.fit == LawFit::kBest) {
    return {subject.table.peak_torque_Nm, plateaus_of(subject).no_load_rad_s};
  }
  std::vector<double> speeds_rad_s;
  constexpr int kSpeeds = 1000;
  for (int i = 1; i <= kSpeeds; ++i) {
    speeds_rad_s.push_back(subject.region.greatest_speed_rad_s() * i / kSpeeds);
  }
  for (const MorRow& row : subject.table.rows) speeds_rad_s.push_back(std::abs(row.speed_rad_s));
  Shape best{0.0, 0.0};
  for (const double speed_rad_s : speeds_rad_s) {
    const double torque_Nm = box_torque_Nm(subject, speed_rad_s);
    if (torque_Nm * speed_rad_s > best[0] * best[1]) best = {torque_Nm, speed_rad_s};
  }
  return best;
}

TorqueLimits law(std::span<const double> shape, double speed_rad_s) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (std::abs(speed_rad_s) > shape[1]) return {-kInfinity, kInfinity};
  return {-shape[0], shape[0]};
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const JointFriction friction = subject.friction.value_or(JointFriction{});
  return xml_comment(note) + fmt::format(R"(<robot name={0}>
  <link name="base"/>
  <link name="link"/>
  <joint name="joint" type="continuous">
    <parent link="base"/>
    <child link="link"/>
    <axis xyz="0 0 1"/>
    <limit effort="{1}" velocity="{2}"/>
    <dynamics damping="{3}" friction="{4}"/>
  </joint>
</robot>
)",
                                         xml_quoted(subject.actuator.name), shape[0], shape[1],
                                         friction.viscous_Nm_s_rad, friction.coulomb_Nm);
}

}  // namespace

const Exporter urdf = {
    .name = "urdf",
    .simulator = "URDF, <limit>",
    .source = "http://wiki.ros.org/urdf/XML/joint",
    .advice =
        "A box is not an operating region: a plan inside it may ask for torque that the motor does "
        "not have. URDF has no field for the armature; set it in your simulator. The fit \"best\" "
        "is "
        "peak torque and no-load speed, \"conservative\" the box of the greatest area inside the "
        "region.",
    .parameters = kParameters,
    .shape = shape,
    .law = law,
    .write = write,
    .friction =
        {DryFriction::kOneValue,
         "damping is in Nm s/rad; friction, in Nm, is called static, and readers take it for "
         "Coulomb's: MuJoCo as frictionloss, RaiSim 2 at rest and in motion.",
         ""},
};

}  // namespace torquewright::actuator::exporters
