// SPDX-License-Identifier: Apache-2.0
// Fields: PhysX 5.6.1, PxPerformanceEnvelope, and the "Drive Performance Envelope" note of Omni
// Physics 107.3: |effort| <= maxEffort - velocityDependentResistance |v| and
// |v| <= maxActuatorVelocity - speedEffortGradient |effort|, in USD as
// physxDrivePerformanceEnvelope:angular:*, maxEffort as drive:angular:physics:maxForce.
// USD counts rotation in degrees: a speed in deg/s, the gradient in deg/(s N m), the resistance in
// N m s/deg (ovphysx 0.6.3, PhysxDrivePerformanceEnvelopeAPI: "every instance except linear is
// treated as rotational and converted"; Isaac Sim's articulation reader does the same). Armature
// and friction: PhysxJointAxisAPI, kg m^2 and N m; viscousFrictionCoefficient in N m s/deg (ovphysx
// 0.7.0, PhysxJointAxisAPI: "the parser ... multiplies viscousFrictionCoefficient by
// 57.29577951308232"). Law: PhysX 5.6.1, jointFriction.pdf: static effort until it moves, dynamic
// effort and -c v in motion.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/exporters/plateau_start.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

constexpr ShapeParameter kParameters[] = {{"greatest_torque_Nm"},
                                          {"no_load_speed_rad_s"},
                                          {"speed_effort_gradient_rad_s_Nm", Scales::kNot}};

Shape shape(const Subject& subject) {
  const Plateaus start = plateaus_of(subject);
  const double stall_Nm = line_start(subject)[0];
  return fitted(subject, physx,
                {start.drive_Nm, start.no_load_rad_s, start.no_load_rad_s / stall_Nm});
}

TorqueLimits law(std::span<const double> shape, double speed_rad_s) {
  const double line_Nm = (shape[1] - std::abs(speed_rad_s)) / shape[2];
  const double limit_Nm = std::clamp(line_Nm, 0.0, shape[0]);
  return {-limit_Nm, limit_Nm};
}

std::string armature_line(double armature_kg_m2) {
  if (armature_kg_m2 == 0.0) return "";
  return fmt::format("    float physxJointAxis:angular:armature = {}\n", armature_kg_m2);
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const JointFriction friction = subject.friction.value_or(JointFriction{});
  return "#usda 1.0\n" + line_comment(note, "# ") +
         fmt::format(R"(over "{0}" (
    prepend apiSchemas = ["PhysicsDriveAPI:angular", "PhysxDrivePerformanceEnvelopeAPI:angular", "PhysxJointAxisAPI:angular"]
)
{{
    float drive:angular:physics:maxForce = {1}
    float physxDrivePerformanceEnvelope:angular:maxActuatorVelocity = {2}
    float physxDrivePerformanceEnvelope:angular:speedEffortGradient = {3}
    float physxDrivePerformanceEnvelope:angular:velocityDependentResistance = 0
{4}    float physxJointAxis:angular:staticFrictionEffort = {5}
    float physxJointAxis:angular:dynamicFrictionEffort = {6}
    float physxJointAxis:angular:viscousFrictionCoefficient = {7}
}}
)",
                     identifier(subject.actuator.name), shape[0], shape[1] * kDegreesPerRadian,
                     shape[2] * kDegreesPerRadian, armature_line(subject.armature_kg_m2()),
                     friction.breakaway_Nm, friction.coulomb_Nm,
                     friction.viscous_Nm_s_rad / kDegreesPerRadian);
}

}  // namespace

const Exporter physx = {
    .name = "physx",
    .simulator = "PhysX 5.6, Isaac Sim 5: drive performance envelope in USD",
    .source =
        "https://nvidia-omniverse.github.io/PhysX/physx/5.6.1/_api_build/"
        "structPxPerformanceEnvelope.html",
    .advice =
        "Speeds are in degrees: maxActuatorVelocity in deg/s, speedEffortGradient in deg/(s Nm). "
        "The "
        "envelope is the same for driving and braking, so braking is derated too and ends at "
        "maxActuatorVelocity. Lay it over the prim of your joint, which must be in an "
        "articulation.",
    .parameters = kParameters,
    .derates_braking = true,
    .shape = shape,
    .law = law,
    .write = write,
    .friction = {DryFriction::kBreakaway,
                 "staticFrictionEffort holds until the joint moves, dynamicFrictionEffort and "
                 "viscousFrictionCoefficient in Nm s/deg act in motion (PhysX 5.6.1, "
                 "jointFriction.pdf; ovphysx 0.7.0, PhysxJointAxisAPI).",
                 ""},
};

}  // namespace torquewright::actuator::exporters
