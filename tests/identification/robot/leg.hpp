// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace torquewright::test {

/// What a joint of the leg does of itself, in the document and in the engine that makes the log.
struct LegJoint {
  double armature_kg_m2 = 0.0;
  double damping_Nm_s_rad = 0.0;
  double friction_Nm = 0.0;
};

inline const std::vector<std::string> kLegJoints = {"hip_joint", "thigh_joint", "calf_joint"};

/// A leg on a held body: a hip that rolls, a thigh and a calf that pitch.
inline nlohmann::json leg_json(const std::vector<LegJoint>& joints) {
  const auto body = [](const char* name, double mass_kg, std::vector<double> center_m,
                       std::vector<double> inertia_kg_m2) {
    return nlohmann::json{
        {"name", name},
        {"mass_kg", mass_kg},
        {"center_of_mass_m", std::move(center_m)},
        {"inertia_kg_m2",
         {{"xx", inertia_kg_m2[0]}, {"yy", inertia_kg_m2[1]}, {"zz", inertia_kg_m2[2]}}}};
  };
  nlohmann::json robot{{"kind", "robot"}, {"version", 1}, {"name", "leg"}};
  robot["base"] = {{"body", "body"}, {"motion", "spatial"}};
  robot["bodies"] = {body("body", 7.0, {0, 0, 0}, {0.03, 0.1, 0.1}),
                     body("hip", 0.7, {0, 0.01, 0}, {5e-4, 9e-4, 6e-4}),
                     body("thigh", 1.2, {-0.004, -0.02, -0.03}, {6e-3, 6e-3, 1e-3}),
                     body("calf", 0.3, {0.006, 0, -0.12}, {2e-3, 2e-3, 6e-5})};
  const std::vector<std::vector<double>> axes = {{1, 0, 0}, {0, 1, 0}, {0, 1, 0}};
  const std::vector<std::vector<double>> places_m = {{0.2, 0.05, 0}, {0, 0.1, 0}, {0, 0, -0.21}};
  const std::vector<std::string> bodies = {"body", "hip", "thigh", "calf"};
  for (std::size_t i = 0; i < 3; ++i) {
    robot["joints"].push_back({{"name", kLegJoints[i]},
                               {"type", "revolute"},
                               {"parent", bodies[i]},
                               {"child", bodies[i + 1]},
                               {"position_m", places_m[i]},
                               {"axis", axes[i]},
                               {"reflected_inertia_kg_m2", joints[i].armature_kg_m2},
                               {"damping_Nm_s_rad", joints[i].damping_Nm_s_rad},
                               {"dry_friction_Nm", joints[i].friction_Nm}});
  }
  return robot;
}

/// How such a leg's log was taken: commands and positions in columns by the joint's name.
inline nlohmann::json leg_rig_json() {
  return {{"kind", "rig"},
          {"version", 1},
          {"columns",
           {{"time_s", "time_s"},
            {"{part}_command", {{"quantity", "commanded_position_rad"}, {"joint", "{part}_joint"}}},
            {"{part}_rad", {{"quantity", "output_position_rad"}, {"joint", "{part}_joint"}}}}},
          {"load", {{"type", "robot"}, {"file", "leg.json"}, {"base", "held"}}},
          {"controller", {{"type", "pd"}, {"stiffness_Nm_rad", 20}, {"damping_Nm_s_rad", 0.5}}}};
}

}  // namespace torquewright::test
