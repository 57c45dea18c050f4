// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/strength_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "gearbox/strength/mesh_stiffness.hpp"
#include "gearbox/strength/ring_section.hpp"

namespace torquewright::report {
namespace {

using gearbox::StrengthCase;
using nlohmann::ordered_json;

ordered_json stress_json(const gearbox::ToothStress& stress) {
  return {{"stress_MPa", stress.stress_MPa},
          {"static_limit_MPa", stress.static_limit_MPa},
          {"life_limit_MPa", stress.life_limit_MPa},
          {"static_safety", stress.static_safety()},
          {"life_safety", stress.life_safety()}};
}

/// One torque on one set of gears.
ordered_json loading_json(const StrengthCase& strength, double sun_Nm) {
  const auto loads = gearbox::tooth_loads(strength, sun_Nm);
  ordered_json loading;
  loading["motor_torque_Nm"] = sun_Nm;
  loading["joint_torque_Nm"] = sun_Nm * std::abs(gearbox::reduction(strength.train));
  loading["has_demanded_safety"] = gearbox::has_demanded_safety(strength, loads);
  loading["gears"] = ordered_json::array();
  for (const gearbox::ToothLoad& load : loads) {
    loading["gears"].push_back({{"gear", load.gear},
                                {"mesh", load.mesh},
                                {"cutter_tip_radius", load.cutter_tip_radius},
                                {"tangential_force_N", load.tangential_force_N},
                                {"root", stress_json(load.root)},
                                {"flank", stress_json(load.flank)}});
    if (!strength.rim_mm.empty()) loading["gears"].back()["rim_factor"] = load.rim_factor;
  }
  return loading;
}

ordered_json limit_json(const gearbox::TorqueLimit& limit) {
  return {{"motor_torque_Nm", limit.motor_Nm},
          {"joint_torque_Nm", limit.joint_Nm},
          {"gear", limit.gear},
          {"mesh", limit.mesh},
          {"mode", limit.mode == gearbox::FailureMode::kBending ? "bending" : "contact"}};
}

ordered_json gears_json(const StrengthReport& report, const StrengthCase& strength) {
  const gearbox::TorqueLimits limits = gearbox::torque_limits(strength);
  ordered_json gears;
  gears["topology"] = strength.train.topology;
  gears["teeth"] = strength.train.teeth;
  gears["planet_count"] = strength.train.planet_count;
  gears["module_mm"] = strength.train.module_mm;
  if (strength.train.layer_2_module_mm) {
    gears["layer_2_module_mm"] = *strength.train.layer_2_module_mm;
  }
  const std::vector<double>& shifts = strength.train.shifts;
  if (std::any_of(shifts.begin(), shifts.end(), [](double x) { return x != 0.0; })) {
    gears["profile_shift"] = shifts;
  }
  gears["face_width_mm"] = strength.train.face_width_mm;
  gears["ratio"] = gearbox::reduction(strength.train);
  gears["stiffness_Nm_rad"] = gearbox::torsional_stiffness_Nm_rad(strength);
  gears["loadings"] = ordered_json::array();
  for (const double torque_Nm : report.torques_Nm) {
    gears["loadings"].push_back(
        loading_json(strength, gearbox::sun_torque_Nm(strength.train, torque_Nm, report.side)));
  }
  gears["greatest_torque"] = {{"once", limit_json(limits.once)},
                              {"for_cycles", limit_json(limits.for_cycles)}};
  return gears;
}

}  // namespace

ordered_json strength_json(const StrengthReport& report) {
  const StrengthCase& strength = report.read.strength;
  ordered_json document;
  document["kind"] = "strength_report";
  document["version"] = 1;
  document["name"] = report.read.name;
  document["verdict"] = report.passes() ? "pass" : "fail";
  document["side"] = report.side == gearbox::TorqueSide::kMotor ? "motor" : "joint";
  document["cycles"] = strength.cycles;
  document["demanded_safety"] = {{"root", strength.demanded_root_safety},
                                 {"flank", strength.demanded_flank_safety}};
  document["assumed"] = report.read.assumed;
  if (!report.read.statements.empty()) document["statements"] = report.read.statements;
  document["ring_root"] = gearbox::kRingSectionSentence;
  document["gearbox"] = gears_json(report, strength);
  document["other_sizes"] = ordered_json::array();
  for (const StrengthCase& variant : report.variants.cases) {
    document["other_sizes"].push_back(gears_json(report, variant));
  }
  document["left_out"] = report.variants.left_out;
  return document;
}

}  // namespace torquewright::report
