// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "gearbox/problem_spec.hpp"
#include "gearbox/synthesis_defaults_spec.hpp"
#include "io/documents/document.hpp"

namespace torquewright::gearbox::test {

/// 20:1 exactly in 79.4 mm for 120 Nm, of few choices.
inline nlohmann::json small_synthesis() {
  nlohmann::json problem{{"kind", "gearbox_problem"},
                         {"version", 1},
                         {"topology", "3k"},
                         {"target_ratio", 20},
                         {"ratio_tolerance", 0},
                         {"rotor_inner_diameter_mm", 79.4},
                         {"module_mm", 0.7},
                         {"planet_count", {3, 4}},
                         {"min_teeth", {{"sun", 20}, {"planet_1", 16}, {"planet_2", 14}}},
                         {"load", {{"output_torque_Nm", 120}, {"cycles", 1000000}}},
                         {"synthesis", nlohmann::json::object()}};
  assume_for_synthesis(problem);
  return problem;
}

/// A single stage of 5:1 for 60 Nm.
inline nlohmann::json small_stage() {
  nlohmann::json problem = small_synthesis();
  problem["topology"] = "planetary";
  problem["target_ratio"] = 5;
  problem["ratio_tolerance"] = 0.01;
  problem["min_teeth"] = {{"sun", 20}, {"planet", 16}};
  problem["load"]["output_torque_Nm"] = 60;
  return problem;
}

/// 12:1 of stepped planets for 60 Nm, inertia asked for.
inline nlohmann::json small_stepped(std::string_view topology) {
  nlohmann::json problem = small_synthesis();
  problem["topology"] = topology;
  problem["target_ratio"] = 12;
  problem["ratio_tolerance"] = topology == "compound" ? 0.002 : 0.0;
  problem["module_mm"] = 0.6;
  problem["planet_count"] = 3;
  problem["min_teeth"] = {{"sun", 18}, {"planet_1", 18}, {"planet_2", 14}};
  problem["load"]["output_torque_Nm"] = 60;
  problem["rotor_inertia_kg_m2"] = 0.00001;
  problem["max_reflected_inertia_kg_m2"] = 0.01;
  return problem;
}

/// 14:1 for 40 Nm that leaves the topology open, of few choices of each.
inline nlohmann::json small_open_problem() {
  nlohmann::json problem = small_synthesis();
  problem["topology"] = "any";
  problem["target_ratio"] = 14;
  problem["rotor_inner_diameter_mm"] = 60;
  problem["module_mm"] = 0.5;
  problem["planet_count"] = 3;
  problem["min_teeth"] = {{"sun", 14}, {"planet_1", 20}, {"planet_2", 14}, {"planet", 14}};
  problem["load"]["output_torque_Nm"] = 40;
  problem["synthesis"]["gap"] = 0.005;
  return problem;
}

inline Problem problem_from(const nlohmann::json& root) {
  return read_open_problem(io::check_document(root, "gearbox_problem", "test.json", ""));
}

}  // namespace torquewright::gearbox::test
