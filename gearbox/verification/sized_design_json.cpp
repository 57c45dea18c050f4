// SPDX-License-Identifier: Apache-2.0
#include "gearbox/verification/sized_design_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gearbox/strength/mesh_stiffness.hpp"
#include "gearbox/strength/problem_strength.hpp"
#include "gearbox/strength/torque_limit.hpp"
#include "gearbox/topologies/topology.hpp"
#include "gearbox/train_parts.hpp"

namespace torquewright::gearbox {
namespace {

using Json = nlohmann::json;

constexpr double kRounding = 1e-9;

bool is_offered(const std::vector<Rational>& offered, const Rational& module_mm) {
  return std::find(offered.begin(), offered.end(), module_mm) != offered.end();
}

/// With the widths, and with the modules of both layers offered to either, as `evaluate` reads it.
Problem with_widths(const Problem& problem, const std::array<double, 2>& face_width_mm) {
  Problem sized = problem;
  const std::vector<std::string> layers = train_parts(problem.topology).layer_names();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    sized.face_width_mm[layers[i]] = io::exact(face_width_mm[i]);
  }
  for (const Rational& module_mm : problem.synthesis->layer_2_module_mm) {
    if (!is_offered(sized.module_mm, module_mm)) sized.module_mm.push_back(module_mm);
  }
  std::sort(sized.module_mm.begin(), sized.module_mm.end());
  return sized;
}

class DesignCheck {
 public:
  DesignCheck(const Problem& problem, const Design& design,
              const std::array<double, 2>& face_width_mm, const std::string& place,
              proof::Faults& faults)
      : problem_(problem),
        request_(*problem.synthesis),
        parts_(train_parts(problem.topology)),
        design_(design),
        width_mm_(face_width_mm),
        sized_(with_widths(problem, face_width_mm)),
        place_(place),
        faults_(faults) {}

  void run() {
    check_choices();
    check_shifts();
    for (std::size_t layer = 0; layer < parts_.layer_count(); ++layer) check_width(layer);
    const std::size_t before = faults_.count();
    check_evaluation();
    if (faults_.count() == before) check_strength();
  }

 private:
  void add(const std::string& where, const std::string& sentence) {
    faults_.add(place_ + where, sentence);
  }

  void check_choices() {
    const auto& planets = problem_.planet_count;
    if (std::find(planets.begin(), planets.end(), design_.planet_count) == planets.end()) {
      add("/planet_count", "is none that the problem offers");
    }
    if (!is_offered(problem_.module_mm, design_.module_mm)) {
      add("/module_mm", "is none that the problem offers");
    }
    const auto& second = request_.layer_2_module_mm;
    const Rational second_mm = design_.layer_2_module_mm.value_or(design_.module_mm);
    const bool is_free = parts_.layer_count() > 1 && !second.empty();
    if (is_free ? !is_offered(second, second_mm) : second_mm != design_.module_mm) {
      add("/layer_2_module_mm", "is none that the problem offers");
    }
    for (const MeshedGears& mesh : parts_.meshes) {
      if (parts_.is_ring(mesh.gear_2)) check_ring(mesh);
    }
  }

  /// No farther from the coaxial ring than shifts may close.
  void check_ring(const MeshedGears& mesh) {
    const auto teeth = [&](std::size_t gear) { return static_cast<double>(design_.teeth[gear]); };
    const bool is_second = parts_.gear_layers[mesh.gear_2] == 1;
    const double modules =
        is_second ? io::nearest(Rational(design_.module_mm /
                                         design_.layer_2_module_mm.value_or(design_.module_mm)))
                  : 1.0;
    const double coaxial = teeth(mesh.gear_1) + modules * (teeth(0) + teeth(1));
    if (std::abs(teeth(mesh.gear_2) - coaxial) >
        static_cast<double>(request_.ring_teeth_off) + kRounding) {
      add("/teeth/" + std::string(parts_.gears[mesh.gear_2]),
          "is farther from the coaxial ring than /synthesis/ring_teeth_off allows");
    }
  }

  void check_shifts() {
    for (std::size_t gear = 0; gear < parts_.free_gears; ++gear) {
      const double shift = design_.profile_shift[gear];
      if (shift < io::nearest(request_.least_shift) - kRounding ||
          shift > io::nearest(request_.greatest_shift) + kRounding) {
        add("/profile_shift/" + std::string(parts_.gears[gear]),
            "is outside what /synthesis allows");
      }
    }
  }

  void check_width(std::size_t layer) {
    const std::string where = "/face_width_mm/" + parts_.layer_names()[layer];
    const double module_mm = io::nearest(
        layer == 0 ? design_.module_mm : design_.layer_2_module_mm.value_or(design_.module_mm));
    const auto fewest = static_cast<double>(
        layer == 0 ? std::min(design_.teeth[0], design_.teeth[1]) : design_.teeth[2]);
    const auto at_most = [&](const std::optional<Rational>& limit, double size_mm) {
      return !limit || width_mm_[layer] <= io::nearest(*limit) * size_mm * (1.0 + kRounding);
    };
    if (!(width_mm_[layer] >= io::nearest(request_.least_face_width_mm) * (1.0 - kRounding))) {
      add(where, "is less than /synthesis/min_face_width_mm");
    }
    if (!at_most(request_.greatest_face_width_mm, 1.0) ||
        !at_most(request_.greatest_face_width_over_module, module_mm) ||
        !at_most(request_.greatest_face_width_over_diameter, module_mm * fewest)) {
      add(where, "is more than /synthesis allows");
    }
  }

  void check_evaluation() {
    const DesignReport report = find_topology(problem_.topology)->evaluate(sized_, design_);
    for (const ConstraintReport& constraint : report.constraints) {
      if (!constraint.satisfied) {
        add("", fmt::format("violates {}: {}", constraint.name, constraint.sentence));
      }
    }
    for (const GearReport& gear : report.gears) {
      for (const ConstraintReport& constraint : report.constraints) {
        const double least_mm = io::nearest(request_.least_tip_thickness) * gear.module_mm;
        if (constraint.name == "tip_thickness." + gear.name &&
            constraint.value < least_mm - kRounding) {
          add("", fmt::format("violates /synthesis/min_tip_thickness: {}", constraint.sentence));
        }
      }
    }
  }

  void check_strength() {
    const double load_Nm = io::nearest(torque_to_bear_Nm(problem_));
    const auto strength = strength_of_design(sized_, design_);
    if (!strength) return add("", "has stresses that cannot be computed");
    const double borne_Nm = torque_limits(*strength).for_cycles.joint_Nm;
    check_stiffness(*strength);
    if (borne_Nm < load_Nm) {
      add("", fmt::format("bears {:.6g} Nm at the output, where {:.6g} Nm are asked for", borne_Nm,
                          load_Nm));
    }
  }

  void check_stiffness(const StrengthCase& strength) {
    const auto& least_Nm_rad = problem_.floors.stiffness_Nm_rad;
    if (!least_Nm_rad) return;
    const double stiffness_Nm_rad = torsional_stiffness_Nm_rad(strength);
    if (stiffness_Nm_rad < io::nearest(*least_Nm_rad)) {
      add("", fmt::format("has {:.6g} Nm/rad at the output, where {:.6g} are asked for",
                          stiffness_Nm_rad, io::nearest(*least_Nm_rad)));
    }
  }

  const Problem& problem_;
  const SynthesisRequest& request_;
  const TrainParts& parts_;
  const Design& design_;
  std::array<double, 2> width_mm_;
  Problem sized_;
  std::string place_;
  proof::Faults& faults_;
};

}  // namespace

std::optional<Design> shifted_design(const Problem& problem, const Json& json,
                                     const std::string& place, proof::Faults& faults) {
  const TrainParts& parts = train_parts(problem.topology);
  Design design;
  for (const std::string_view gear : parts.gears) {
    const std::string name(gear);
    if (!json["teeth"].contains(name)) {
      faults.add(place + "/teeth/" + name, "is missing");
      return std::nullopt;
    }
    const Json shifts = json.value("profile_shift", Json::object());
    if (!shifts.contains(name) || !shifts[name].is_number()) {
      faults.add(place + "/profile_shift/" + name, "is missing");
      return std::nullopt;
    }
    design.teeth.push_back(json["teeth"][name]);
    design.profile_shift.push_back(shifts[name]);
  }
  design.planet_count = json["planet_count"];
  design.module_mm = io::exact(json["module_mm"].get<double>());
  const Json second_mm = json.value("layer_2_module_mm", Json());
  if (second_mm.is_number()) design.layer_2_module_mm = io::exact(second_mm.get<double>());
  return design;
}

void check_sized_design(const Problem& problem, const Design& design,
                        const std::array<double, 2>& face_width_mm, const std::string& place,
                        proof::Faults& faults) {
  DesignCheck(problem, design, face_width_mm, place, faults).run();
}

}  // namespace torquewright::gearbox
