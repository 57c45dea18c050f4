// SPDX-License-Identifier: Apache-2.0
#include "gearbox/front/front_spec.hpp"

#include <nlohmann/json.hpp>

#include "gearbox/problem_spec.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::ordered_json;

ordered_json point_json(const ShownFront& shown, const FrontPoint& point) {
  const Design& design = point.report.design;
  ordered_json json{{"first", point.first}, {"bound", point.first_bound}, {"second", point.second}};
  json["from"] = point.from ? ordered_json(*point.from) : ordered_json();
  for (std::size_t i = 0; i < design.teeth.size(); ++i) {
    json["teeth"][point.report.gears[i].name] = design.teeth[i];
  }
  json["topology"] = point.problem.topology;
  json["planet_count"] = design.planet_count;
  json["module_mm"] = io::nearest(design.module_mm);
  if (design.layer_2_module_mm) json["layer_2_module_mm"] = io::nearest(*design.layer_2_module_mm);
  for (std::size_t i = 0; i < design.profile_shift.size(); ++i) {
    json["profile_shift"][point.report.gears[i].name] = design.profile_shift[i];
  }
  for (const auto& [layer, width_mm] : point.problem.face_width_mm) {
    json["face_width_mm"][layer] = io::nearest(width_mm);
  }
  for (const Objective objective :
       {Objective::kMass, Objective::kHollowShaft, Objective::kForwardEfficiency,
        Objective::kBackwardEfficiency, Objective::kReflectedInertia}) {
    if (objective == shown.first || objective == shown.second) continue;
    const auto value = objective_value(objective, point.report);
    if (value) json["others"][std::string(objective_name(objective))] = *value;
  }
  return json;
}

}  // namespace

Problem read_front_problem(const io::Document& document, Objective first, Objective second) {
  io::Document asked = document;
  if (!document.root.contains("synthesis")) {
    asked.root["objective"] = objective_name(second);
    read_open_problem(asked);  // For its faults.
  } else if (first != Objective::kMass || !can_be_limited(second)) {
    io::refuse("--objectives",
               "a synthesis weighs mass alone, against forward_efficiency, backward_efficiency, "
               "hollow_shaft or reflected_inertia: mass,forward_efficiency");
  }
  asked.root["objective"] = objective_name(first);
  return read_open_problem(asked);
}

std::string_view objective_unit(Objective objective) {
  switch (objective) {
    case Objective::kMass:
      return "kg";
    case Objective::kHollowShaft:
      return "mm";
    case Objective::kReflectedInertia:
      return "kg m^2";
    case Objective::kForwardEfficiency:
    case Objective::kBackwardEfficiency:
    case Objective::kPaperCost:
      break;
  }
  return "1";
}

ordered_json front_json(const ShownFront& shown) {
  const Front& front = shown.front;
  ordered_json json{{"kind", "gearbox_front"}, {"version", 1}};
  json["status"] = !front.is_whole ? "limit" : front.points.empty() ? "infeasible" : "optimal";
  json["first"] = {{"objective", objective_name(shown.first)},
                   {"unit", objective_unit(shown.first)}};
  json["second"] = {{"objective", objective_name(shown.second)},
                    {"unit", objective_unit(shown.second)}};
  json["points"] = ordered_json::array();
  for (const FrontPoint& point : front.points) json["points"].push_back(point_json(shown, point));
  json["none_from"] = front.none_from ? ordered_json(*front.none_from) : ordered_json();
  return json;
}

}  // namespace torquewright::gearbox
