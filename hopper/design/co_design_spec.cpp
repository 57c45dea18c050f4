// SPDX-License-Identifier: Apache-2.0
#include "hopper/design/co_design_spec.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "actuator/motor/gear_transmission.hpp"
#include "gearbox/topologies/topology.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/one_line.hpp"
#include "io/text/stepped_range.hpp"

namespace torquewright::hopper {
namespace {

using io::Rational;
using nlohmann::ordered_json;

constexpr std::size_t kMostRatios = 1000;

ordered_json or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? ordered_json(*value) : ordered_json();
}

ordered_json choice_json(const GearChoice& choice) {
  const gearbox::DesignReport& report = choice.report;
  ordered_json json;
  for (const gearbox::GearReport& gear : report.gears) json["teeth"][gear.name] = gear.teeth;
  json["topology"] = choice.problem.topology;
  json["planet_count"] = report.design.planet_count;
  json["module_mm"] = io::nearest(report.design.module_mm);
  if (report.design.layer_2_module_mm) {
    json["layer_2_module_mm"] = io::nearest(*report.design.layer_2_module_mm);
  }
  for (std::size_t i = 0; i < report.design.profile_shift.size(); ++i) {
    json["profile_shift"][report.gears[i].name] = report.design.profile_shift[i];
  }
  for (const auto& [layer, width_mm] : choice.problem.face_width_mm) {
    json["face_width_mm"][layer] = io::nearest(width_mm);
  }
  json["objective"] = report.objective;
  json["bound"] = or_null(choice.bound);
  json["mass_kg"] = or_null(report.mass_kg);
  json["forward_efficiency"] = choice.transmission.forward_efficiency;
  json["backward_efficiency"] = choice.transmission.backward_efficiency;
  json["inertia_kg_m2"] = choice.transmission.inertia_kg_m2;
  json["borne_Nm"] = or_null(choice.transmission.peak_torque_Nm);
  json["hollow_shaft_diameter_mm"] = report.hollow_shaft_diameter_mm;
  return json;
}

ordered_json gears_json(const GearsOfRatio& gears) {
  ordered_json json{{"ratio", io::nearest(gears.ratio)}, {"search", name_of(gears.search)}};
  json["choices"] = ordered_json::array();
  for (const GearChoice& choice : gears.choices) json["choices"].push_back(choice_json(choice));
  return json;
}

ordered_json pair_json(const CoDesignQuestion& question, const DesignedPair& pair) {
  const CandidateResult& result = pair.result;
  return {{"motor", question.shelf.motors[pair.motor].name},
          {"ratio", io::nearest(question.ratios[pair.ratio])},
          {"choice", pair.choice},
          {"verdict", actuator::name_of(result.verdict)},
          {"margin_share", or_null(result.margin_share)},
          {"speed_margin_rad_s", or_null(result.speed_margin_rad_s)},
          {"gears_kg", or_null(pair.gears_kg)},
          {"mass_kg", or_null(pair.mass_kg)},
          {"energy_J", or_null(result.energy_J)},
          {"copper_loss_J", or_null(result.copper_loss_J)},
          {"peak_torque_Nm", result.peak_torque_Nm},
          {"rotor_inertia_kg_m2", result.rotor_inertia_kg_m2},
          {"why", result.why}};
}

/// The document that a motor of the shelf was read from.
ordered_json document_of(const MotorShelf& shelf, const std::string& name) {
  for (const io::Document& document : shelf.documents) {
    if (document.root.value("kind", "") != "actuator") continue;
    if (io::stem_in_text(std::filesystem::path(document.file)) == name) return document.root;
  }
  throw std::logic_error("a motor without a document");
}

bool is_about_old_gears(const std::string& pointer) {
  return pointer.starts_with("/gearbox") || pointer.starts_with("/datasheet") ||
         pointer == "/mass_kg";
}

}  // namespace

std::string name_of(GearSearch search) {
  switch (search) {
    case GearSearch::kProved:
      return "proved";
    case GearSearch::kNone:
      return "none";
    case GearSearch::kLimit:
      return "limit";
    case GearSearch::kSkipped:
      break;
  }
  return "skipped";
}

std::vector<Rational> read_ratios(const std::string& text) {
  const io::RangeRule rule{
      .refuse =
          [&text](const std::string& why) {
            io::refuse(
                "--ratios",
                fmt::format("\"{}\": {}; the form is RATIO, FROM:TO or FROM:TO:STEP", text, why));
          },
      .most = kMostRatios,
      .what = "ratios",
      .least = 0.01,
      .greatest = 1e4};
  if (!io::is_range(text)) return {io::read_range_number(text, rule)};
  return io::values_of(io::read_stepped_range(text, rule));
}

ordered_json co_design_json(const Robot& robot, const CoDesignQuestion& question,
                            const CoDesign& design) {
  ordered_json json{{"kind", "drive_design"}, {"version", 1}};
  json["status"] = design.is_whole ? "whole" : "limit";
  json["drives"] = robot.drivetrains[question.drivetrain].actuator_names;
  json["motors"] = ordered_json::array();
  for (const ShelfMotor& motor : question.shelf.motors) {
    json["motors"].push_back({{"motor", motor.name}, {"mass_kg", or_null(motor.mass_kg)}});
  }
  json["gearboxes"] = ordered_json::array();
  for (const GearsOfRatio& gears : design.gears) json["gearboxes"].push_back(gears_json(gears));
  json["pairs"] = ordered_json::array();
  for (const DesignedPair& pair : design.pairs) json["pairs"].push_back(pair_json(question, pair));
  json["not_searched"] = ordered_json::array();
  for (const PrunedPair& pair : design.pruned) {
    json["not_searched"].push_back({{"motor", question.shelf.motors[pair.motor].name},
                                    {"ratio", io::nearest(question.ratios[pair.ratio])},
                                    {"why", pair.why}});
  }
  json["left_out"] = question.shelf.left_out;
  return json;
}

ordered_json designed_actuator_json(const CoDesignQuestion& question, const CoDesign& design,
                                    const DesignedPair& pair) {
  const ShelfMotor& motor = question.shelf.motors[pair.motor];
  const actuator::Transmission& gears = design.gears[pair.ratio].choices[pair.choice].transmission;
  ordered_json json{{"kind", "actuator"}, {"version", 1}};
  json["name"] = fmt::format("{} behind {:g}:1", motor.name, std::abs(gears.ratio));
  ordered_json own = document_of(question.shelf, motor.name);
  for (const char* key :
       {"kind", "version", "name", "mass_kg", "gearbox", "datasheet", "sources"}) {
    own.erase(key);
  }
  json.update(own);
  if (pair.mass_kg) json["mass_kg"] = *pair.mass_kg;
  json["gearbox"] = {{"ratio", gears.ratio},
                     {"forward_efficiency", gears.forward_efficiency},
                     {"backward_efficiency", gears.backward_efficiency},
                     {"inertia_kg_m2", gears.inertia_kg_m2}};
  if (std::isfinite(gears.peak_torque_Nm)) json["gearbox"]["peak_torque_Nm"] = gears.peak_torque_Nm;
  actuator::Actuator behind = motor.actuator;
  behind.transmission = gears;
  actuator::carry_joint_rating(motor.actuator.transmission, behind);
  if (behind.datasheet && behind.datasheet->rated_torque_Nm) {
    json["datasheet"] = {{"side", actuator::is_rated_at_joint(behind) ? "joint" : "motor"},
                         {"rated_torque_Nm", *behind.datasheet->rated_torque_Nm}};
  }
  ordered_json assumed = ordered_json::array();
  for (const auto& pointer : json.value("assumed", ordered_json::array())) {
    if (!is_about_old_gears(pointer)) assumed.push_back(pointer);
  }
  json.erase("assumed");
  if (!assumed.empty()) json["assumed"] = assumed;
  return json;
}

}  // namespace torquewright::hopper
