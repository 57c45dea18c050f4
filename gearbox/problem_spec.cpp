// SPDX-License-Identifier: Apache-2.0
#include "gearbox/problem_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>
#include <utility>

#include "gearbox/any_topology.hpp"
#include "gearbox/floors.hpp"
#include "gearbox/train_parts.hpp"
#include "io/documents/document.hpp"
#include "io/documents/schema.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::json;
using nlohmann::literals::operator""_json_pointer;

/// Whose train equations (1)...(9) describe.
std::string_view the_papers_topology() {
  const auto all = all_train_parts();
  return std::find_if(all.begin(), all.end(), [](const auto& each) { return each.is_the_papers; })
      ->name;
}

/// Half the angle left of a shaper's tip between two roundings, docs/derivations/tooth_outline.md
/// eq. (13), without profile shift.
double shaper_land_rad(double teeth, double addendum, double rounding) {
  constexpr double kAngle_rad = std::numbers::pi / 9.0;
  const double base = 0.5 * teeth * std::cos(kAngle_rad);
  const auto involute = [](double angle_rad) { return std::tan(angle_rad) - angle_rad; };
  const double profile_rad = std::acos(base / (0.5 * teeth + addendum - rounding));
  return std::numbers::pi / (2.0 * teeth) + involute(kAngle_rad) - involute(profile_rad) -
         rounding / base;
}

/// Reads the keys of one document; faults gather until all of it is read.
class Reader {
 public:
  explicit Reader(const io::Document& document) : document_(document) {}

  Problem read() {
    read_choice();
    read_limits();
    read_parts();
    read_values();
    read_synthesis();
    check_combinations();
    if (!faults_.empty()) throw io::SpecError(std::move(faults_));
    return std::move(problem_);
  }

 private:
  const json& root() const { return document_.root; }

  void report(const std::string& path, std::string message) {
    faults_.push_back({document_.file, document_.path + path, std::move(message)});
  }

  static Rational rational(const json& number) {
    return number.is_number_integer() ? Rational(mpz_class(number.dump()))
                                      : io::exact(number.get<double>());
  }

  std::optional<Rational> find(const char* pointer) const {
    const json::json_pointer key(pointer);
    if (!root().contains(key)) return std::nullopt;
    return rational(root()[key]);
  }

  /// A number or a list of numbers as an ascending list; an entry that stands twice is a slip.
  template <typename Number, typename Convert>
  std::vector<Number> read_list(const std::string& key, Convert convert) {
    const json& value = root()[key];
    if (!value.is_array()) return {convert(value)};
    std::vector<Number> numbers;
    for (std::size_t i = 0; i < value.size(); ++i) {
      numbers.push_back(convert(value[i]));
      if (std::count(numbers.begin(), numbers.end(), numbers.back()) > 1) {
        report(fmt::format("/{}/{}", key, i),
               value[i].dump() + " stands twice in this list; keep one");
      }
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  }

  void read_choice() {
    // The name of the file stands in for a name that is not given.
    problem_.name = root().value("name", io::stem_in_text(document_.file));
    problem_.topology = root()["topology"];
    problem_.constraints =
        root()["constraints"] == "paper" ? ConstraintSet::kPaper : ConstraintSet::kBuildable;
    const auto* objective =
        std::find_if(kObjectives.begin(), kObjectives.end(),
                     [&](const auto& entry) { return root()["objective"] == entry.second; });
    problem_.objective = objective->first;  // the schema admits no other word
    problem_.module_mm = read_list<Rational>("module_mm", rational);
    problem_.planet_count = read_list<std::int64_t>(
        "planet_count", [](const json& count) { return count.get<std::int64_t>(); });
  }

  void read_limits() {
    problem_.target_ratio = rational(root()["target_ratio"]);
    problem_.ratio_tolerance = find("/ratio_tolerance").value_or(0);
    problem_.rotor_inner_diameter_mm = rational(root()["rotor_inner_diameter_mm"]);
    problem_.min_carrier_clearance_rad = rational(root()["min_carrier_clearance_rad"]);
    problem_.min_contact_ratio = find("/min_contact_ratio").value_or(problem_.min_contact_ratio);
    problem_.min_neighbour_clearance_mm = find("/min_neighbour_clearance_mm").value_or(0);
    problem_.ring_outer_diameter_mm = find("/ring_outer_diameter_mm");
    problem_.ring_wall_mm = find("/ring_wall_mm");
    problem_.sun_under_second_layer =
        root().value("sun_under_second_layer", problem_.sun_under_second_layer);
    problem_.cutters.hob_tip_radius = find("/cutter/hob_tip_radius");
    problem_.cutters.hob_addendum = find("/cutter/hob_addendum");
    problem_.cutters.shaper_tip_radius = find("/cutter/shaper_tip_radius");
    problem_.cutters.shaper_addendum = find("/cutter/shaper_addendum");
    if (root().contains("/cutter/shaper_teeth"_json_pointer)) {
      problem_.cutters.shaper_teeth = root()["cutter"]["shaper_teeth"].get<std::int64_t>();
    }
  }

  void read_parts() {
    const std::vector<std::string> gears = gears_with_minima(problem_.topology);
    for (const std::string& gear : check_members("min_teeth", gears)) {
      problem_.min_teeth[gear] = root()["min_teeth"][gear];
    }
    if (!root().contains("face_width_mm")) return;
    for (const std::string& layer : check_members("face_width_mm", layers_of(problem_.topology))) {
      problem_.face_width_mm[layer] = rational(root()["face_width_mm"][layer]);
    }
  }

  /// The members that both the topology and the document have; faults for those only one has.
  std::vector<std::string> check_members(const std::string& key,
                                         const std::vector<std::string>& known) {
    std::vector<std::string> present;
    for (const auto& member : root()[key].items()) {
      if (std::find(known.begin(), known.end(), member.key()) != known.end()) {
        present.push_back(member.key());
      } else {
        report(fmt::format("/{}/{}", key, member.key()),
               fmt::format("the topology \"{}\" has none, only {}", problem_.topology,
                           fmt::join(known, ", ")));
      }
    }
    for (const std::string& name : known) {
      if (root()[key].contains(name)) continue;
      report(fmt::format("/{}/{}", key, name),
             fmt::format("missing; the topology \"{}\" has {}", problem_.topology,
                         fmt::join(known, ", ")));
    }
    return present;
  }

  void read_values() {
    problem_.friction_coefficient = find("/friction_coefficient");
    problem_.load_output_torque_Nm = find("/load/output_torque_Nm");
    problem_.load_cycles = find("/load/cycles");
    if (root().contains("/materials/steel"_json_pointer)) {
      problem_.steel = root()["materials"]["steel"].get<std::string>();
    }
    problem_.hollow_shaft_wall_mm = find("/hollow_shaft_wall_mm");
    problem_.density_kg_m3 = find("/materials/density_kg_m3");
    problem_.rotor_inertia_kg_m2 = find("/rotor_inertia_kg_m2").value_or(0);
    problem_.assumed = root().value("assumed", problem_.assumed);
  }

  void read_synthesis() {
    read_floors();
    if (!root().contains("synthesis")) return;
    const json& keys = root()["synthesis"];
    SynthesisRequest request;
    const auto take = [&](const char* key, Rational& value) {
      if (keys.contains(key)) value = rational(keys[key]);
    };
    if (keys.contains("layer_2_module_mm")) {
      request.layer_2_module_mm = numbers_of(keys["layer_2_module_mm"]);
    }
    request.ring_teeth_off = keys.value("ring_teeth_off", request.ring_teeth_off);
    take("min_profile_shift", request.least_shift);
    take("max_profile_shift", request.greatest_shift);
    take("min_tip_thickness", request.least_tip_thickness);
    take("min_face_width_mm", request.least_face_width_mm);
    request.greatest_face_width_mm = find("/synthesis/max_face_width_mm");
    request.greatest_face_width_over_module = find("/synthesis/max_face_width_over_module");
    request.greatest_face_width_over_diameter = find("/synthesis/max_face_width_over_diameter");
    problem_.floors.torque_borne_Nm = find("/synthesis/min_torque_borne_Nm");
    problem_.floors.stiffness_Nm_rad = find("/synthesis/min_stiffness_Nm_rad");
    take("gap", request.gap);
    problem_.synthesis = request;
    check_synthesis(keys, request);
  }

  /// A number or a list of numbers, ascending, each once.
  static std::vector<Rational> numbers_of(const json& value) {
    std::vector<Rational> numbers;
    if (value.is_array()) {
      for (const json& each : value) numbers.push_back(rational(each));
    } else {
      numbers.push_back(rational(value));
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
  }

  void read_floors() {
    for (const FloorRecord& floor : kFloors) {
      const std::string key(floor.key);
      problem_.floors.*floor.limit = find(key.c_str());
      if (!(problem_.floors.*floor.limit)) continue;
      const std::string whom = key.substr(1);
      if (floor.needs_friction) require_for("/friction_coefficient", whom);
      if (root().contains("synthesis")) continue;  // It chooses widths, and needs a density.
      if (floor.needs_widths) require_for("/face_width_mm", whom);
      if (floor.needs_density) require_for("/materials/density_kg_m3", whom);
    }
  }

  void check_synthesis(const json& keys, const SynthesisRequest& request) {
    const auto written = [&](const char* key, const Rational& value) {
      return keys.contains(key) ? keys[key].dump() : fmt::format("{:g}", io::nearest(value));
    };
    if (request.least_shift > request.greatest_shift) {
      report("/synthesis/min_profile_shift",
             fmt::format("{} is more than /synthesis/max_profile_shift, {}",
                         written("min_profile_shift", request.least_shift),
                         written("max_profile_shift", request.greatest_shift)));
    }
    const auto& greatest = request.greatest_face_width_mm;
    if (greatest && request.least_face_width_mm > *greatest) {
      report("/synthesis/min_face_width_mm",
             fmt::format("{} is more than /synthesis/max_face_width_mm, {}",
                         written("min_face_width_mm", request.least_face_width_mm),
                         written("max_face_width_mm", *greatest)));
    }
    if (keys.contains("layer_2_module_mm") && layers_of(problem_.topology).size() < 2) {
      report("/synthesis/layer_2_module_mm",
             fmt::format("the topology \"{}\" has one layer only", problem_.topology));
    }
    if (problem_.constraints == ConstraintSet::kPaper) {
      report("/constraints", "\"paper\" knows no shifts; synthesis needs \"buildable\"");
    }
    if (problem_.objective != Objective::kMass) {
      report("/objective", "synthesis can only make the mass least so far; use \"mass\"");
    }
    if (root().contains("face_width_mm")) {
      report("/face_width_mm", "is chosen by synthesis; leave it out");
    }
    for (const char* pointer :
         {"/load/output_torque_Nm", "/materials/steel", "/materials/density_kg_m3"}) {
      require_for(pointer, "synthesis");
    }
    if (problem_.load_output_torque_Nm && *problem_.load_output_torque_Nm == 0) {
      report("/load/output_torque_Nm", "0 loads no tooth; synthesis needs a load");
    }
  }

  /// What only a synthesis searches.
  void check_topology() {
    const TrainParts* parts = find_train_parts(problem_.topology);
    if (parts == nullptr || !parts->is_the_papers) refuse_the_papers();
    if (problem_.synthesis || (parts != nullptr && !parts->needs_synthesis)) return;
    report("/synthesis", fmt::format("missing; the topology \"{}\" is searched with it only ({{}} "
                                     "will do)",
                                     problem_.topology));
  }

  void check_combinations() {
    check_topology();
    check_hob();
    check_shaper();
    const std::string objective = root()["objective"];
    const bool needs_friction = objective.ends_with("_efficiency");
    const bool needs_masses = objective == "mass" || objective == "reflected_inertia";
    if (needs_friction) require("/friction_coefficient", objective);
    if (needs_masses && !problem_.synthesis) require("/face_width_mm", objective);
    if (needs_masses) require("/materials/density_kg_m3", objective);
  }

  /// Of a train that its equations do not describe.
  void refuse_the_papers() {
    const std::string other = fmt::format("the topology \"{}\"", problem_.topology);
    if (problem_.constraints == ConstraintSet::kPaper) {
      report("/constraints",
             fmt::format("\"paper\" does not go with {}: equations (2)-(9) describe the {} gearbox "
                         "only; use \"buildable\"",
                         other, the_papers_topology()));
    }
    if (problem_.objective == Objective::kPaperCost) {
      report(
          "/objective",
          fmt::format("\"paper_cost\" does not go with {}: equation (1) describes the {} gearbox "
                      "only; use \"hollow_shaft\", \"mass\", \"forward_efficiency\", "
                      "\"backward_efficiency\" or \"reflected_inertia\"",
                      other, the_papers_topology()));
    }
  }

  /// Only a hob that is longer than the standard one is straight deep enough with more.
  void check_hob() {
    const StatedCutters& cutters = problem_.cutters;
    if (!cutters.hob_tip_radius || cutters.hob_addendum) return;
    if (*cutters.hob_tip_radius <= Rational(38, 100)) return;
    report("/cutter/hob_tip_radius",
           root()["cutter"]["hob_tip_radius"].dump() +
               " is more than the 0.38 of a hob of addendum 1.25; state /cutter/hob_addendum too");
  }

  void check_shaper() {
    const StatedCutters& cutters = problem_.cutters;
    if (!cutters.shaper_teeth) return;
    const auto teeth = static_cast<double>(*cutters.shaper_teeth);
    const double addendum = io::nearest(cutters.shaper_depth());
    if (shaper_land_rad(teeth, addendum, 0.0) < 0.0) {
      report("/cutter/shaper_addendum",
             fmt::format("a shaper of {} teeth is pointed before an addendum of {:g}", teeth,
                         addendum));
      return;
    }
    if (!cutters.shaper_tip_radius) return;
    const double stated = io::nearest(*cutters.shaper_tip_radius);
    if (shaper_land_rad(teeth, addendum, stated) >= 0.0) return;
    double most = 0.0;  // To a hundredth; the land falls with the rounding.
    while (shaper_land_rad(teeth, addendum, most + 0.01) >= 0.0) most += 0.01;
    report("/cutter/shaper_tip_radius",
           fmt::format("{} does not fit on the tip of a shaper of {} teeth; at most {:.2f}",
                       root()["cutter"]["shaper_tip_radius"].dump(), teeth, most));
  }

  void require(const char* pointer, const std::string& objective) {
    require_for(pointer, fmt::format("the objective \"{}\"", objective));
  }

  void require_for(const char* pointer, const std::string& whom) {
    if (root().contains(json::json_pointer(pointer))) return;
    report(pointer, fmt::format("missing; {} needs it", whom));
  }

  const io::Document& document_;
  Problem problem_;
  std::vector<io::Fault> faults_;
};

}  // namespace

Problem read_problem(const io::Document& document) {
  if (document.root["topology"] == kAnyTopology) {
    throw io::SpecError({{document.file, document.path + "/topology",
                          "\"any\" leaves it open, which optimize, pareto and design of a problem "
                          "with /synthesis close; state one"}});
  }
  return read_open_problem(document);
}

Problem read_open_problem(const io::Document& document) { return Reader(document).read(); }

json as_topology(const json& problem, const TrainParts& parts) {
  json own = problem;
  own["topology"] = parts.name;
  const std::vector<std::string> gears = gears_with_minima(parts.name);
  for (const auto& minimum : problem["min_teeth"].items()) {
    if (std::find(gears.begin(), gears.end(), minimum.key()) == gears.end()) {
      own["min_teeth"].erase(minimum.key());
    }
  }
  if (parts.layer_count() < 2) own["synthesis"].erase("layer_2_module_mm");
  return own;
}

bool may_be_stated(const std::string& pointer, double value) {
  std::string place = pointer;
  for (std::size_t slash = 0; (slash = place.find('/', slash)) != std::string::npos;) {
    place.replace(slash, 1, "/properties/");
    slash += std::string_view("/properties/").size();
  }
  const json& property = io::schema_of("gearbox_problem").at(json::json_pointer(place));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return value >= property.value("minimum", -kInfinity) &&
         value <= property.value("maximum", kInfinity);
}

}  // namespace torquewright::gearbox
