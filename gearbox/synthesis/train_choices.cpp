// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis/train_choices.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "gearbox/constraints/hob_reach.hpp"
#include "gearbox/constraints/spacing.hpp"
#include "gearbox/constraints/tooth_conditions.hpp"
#include "gearbox/strength/mesh_stiffness.hpp"
#include "gearbox/strength/problem_strength.hpp"
#include "gearbox/strength/steels.hpp"
#include "gearbox/strength/strength.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/train/assembly.hpp"
#include "gearbox/train/central_gears.hpp"
#include "gearbox/train_parts.hpp"
#include "gearbox/walls.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kSlack = 1e-9;

/// Where a gear stands in a choice: the sun, a layer's planet, a layer's ring.
std::size_t place_of(const TrainParts& parts, std::size_t gear) {
  if (gear == 0) return 0;
  const std::size_t layer = parts.gear_layers[gear];
  return parts.is_ring(gear) ? 3 + layer : 1 + layer;
}

/// The choice's teeth in the topology's order.
template <class Number>
std::vector<Number> gear_teeth(const TrainParts& parts, const TrainChoice& choice) {
  std::vector<Number> teeth;
  for (std::size_t gear = 0; gear < parts.gears.size(); ++gear) {
    teeth.emplace_back(static_cast<long>(choice.teeth[place_of(parts, gear)]));
  }
  return teeth;
}

/// Walks through the teeth of one planet count and pair of modules.
class ChoiceWalk {
 public:
  ChoiceWalk(const Problem& problem, const LayerModules& modules, std::size_t most,
             std::vector<TrainChoice>& found)
      : problem_(problem),
        modules_(modules),
        parts_(train_parts(problem.topology)),
        has_first_ring_(parts_.ring_of_layer(0)),
        has_second_layer_(parts_.layer_count() > 1),
        most_choices_(most),
        found_(found) {
    least_ratio_ = io::nearest(least_ratio(problem)) * (1.0 - kSlack);
    greatest_ratio_ = io::nearest(greatest_ratio(problem)) * (1.0 + kSlack);
  }

  void walk(std::int64_t planets, std::size_t first, std::size_t second) {
    choice_.planet_count = planets;
    choice_.module = {first, second};
    module_1_mm_ = modules_.first_mm[first];
    module_2_mm_ = modules_.second_mm.empty() ? module_1_mm_ : modules_.second_mm[second];
    shift_of_modules_ = io::nearest(Rational(module_1_mm_ / module_2_mm_));
    most_ = {most_teeth(module_1_mm_), most_teeth(module_2_mm_)};
    const std::int64_t off = problem_.synthesis->ring_teeth_off;
    // Planets without a ring roll inside the bore as a ring would stand there.
    const std::int64_t spare = has_first_ring_ ? off : 0;
    for (std::int64_t sun = minimum(0); sun < most_[0]; ++sun) {
      for (std::int64_t planet = minimum(1); sun + 2 * planet - spare <= most_[0]; ++planet) {
        const PlanetCircle circle{sun, planet, planets, module_1_mm_};
        if (!clears(circle)) break;
        if (has_first_ring_) {
          first_rings(sun, planet);
        } else {
          second_layer(sun, planet, 0);
        }
        if (found_.size() > most_choices_) return;
      }
    }
  }

 private:
  std::int64_t minimum(std::size_t gear) const {
    return problem_.min_teeth.at(std::string(parts_.gears[gear]));
  }

  std::int64_t most_teeth(const Rational& module_mm) const {
    const Rational bore = problem_.rotor_inner_diameter_mm / module_mm;
    return mpz_class(bore.get_num() / bore.get_den()).get_si();
  }

  void first_rings(std::int64_t sun, std::int64_t planet) {
    const std::int64_t off = problem_.synthesis->ring_teeth_off;
    for (std::int64_t ring = sun + 2 * planet - off;
         ring <= std::min(most_[0], sun + 2 * planet + off); ++ring) {
      if (spacing_remainder(sun, ring, choice_.planet_count) != 0) continue;
      if (has_second_layer_) {
        second_layer(sun, planet, ring);
      } else {
        consider({sun, planet, 0, ring, 0});
      }
    }
  }

  /// The paper's planet 2 is smaller than planet 1; where the second ring is held, the bore limits
  /// it.
  std::int64_t greatest_planet_2(std::int64_t planet, std::int64_t ring_from_planet) const {
    return parts_.is_the_papers ? planet - choice_.planet_count : most_[1] - ring_from_planet;
  }

  bool clears(const PlanetCircle& circle) const {
    const auto planet = static_cast<double>(circle.planet);
    const double clearance_rad = std::numbers::pi / static_cast<double>(circle.planet_count) -
                                 std::asin(planet / (static_cast<double>(circle.sun) + planet));
    const double margin_rad = clearance_rad - io::nearest(problem_.min_carrier_clearance_rad);
    if (std::abs(margin_rad) > kSlack) return margin_rad > 0.0;
    return carrier_clearance(circle, problem_.min_carrier_clearance_rad).satisfied;
  }

  void second_layer(std::int64_t sun, std::int64_t planet, std::int64_t first_ring) {
    const double between = shift_of_modules_ * static_cast<double>(sun + planet);
    const auto off = static_cast<double>(problem_.synthesis->ring_teeth_off);
    const std::int64_t low = std::llround(std::ceil(between - off - kSlack));
    const std::int64_t high = std::llround(std::floor(between + off + kSlack));
    for (std::int64_t planet_2 = minimum(2); planet_2 <= greatest_planet_2(planet, low);
         ++planet_2) {
      for (std::int64_t ring = planet_2 + low; ring <= planet_2 + high; ++ring) {
        if (!parts_.is_the_papers && ring > most_[1]) continue;
        consider({sun, planet, planet_2, first_ring, ring});
      }
    }
  }

  void consider(const std::array<std::int64_t, 5>& z) {
    choice_.teeth = z;
    const double ratio = near_ratio();
    if (!(ratio >= least_ratio_ && ratio <= greatest_ratio_)) return;
    const std::vector<Rational> teeth = gear_teeth<Rational>(parts_, choice_);
    const Rational exact = basic_ratios<Rational>(parts_, teeth).reduction();
    if (exact < least_ratio(problem_) || exact > greatest_ratio(problem_)) return;
    // The sun takes the place of a ring that planet 1 lacks (docs/derivations/kinematics.md (20)).
    if (has_second_layer_ &&
        !has_identical_planets({z[0], z[1], z[2], has_first_ring_ ? z[3] : -z[0], z[4]},
                               choice_.planet_count)) {
      return;
    }
    if (may_meet_ceilings(ratio)) found_.push_back(choice_);
  }

  /// Infinite, negative or no number where the output stands still or turns backwards. As
  /// basic_ratios() has it, of the choice's own places: it is asked of millions.
  double near_ratio() const {
    const auto z = [&](std::size_t place) { return static_cast<double>(choice_.teeth[place]); };
    const std::size_t held = parts_.gear_layers[parts_.held_ring];
    const double roll = z(3 + held) / z(1 + held);
    const double first = roll * z(1) / z(0);
    if (!parts_.output_ring) return 1.0 + first;
    const std::size_t output = parts_.gear_layers[*parts_.output_ring];
    return (1.0 + first) / (1.0 - roll * z(1 + output) / z(3 + output));
  }

  /// What no shift changes: the rotor's inertia, and backlash, which goes with base circles.
  bool may_meet_ceilings(double ratio) const {
    const auto& inertia_kg_m2 = problem_.floors.reflected_inertia_kg_m2;
    const double rotor_kg_m2 = square(ratio) * io::nearest(problem_.rotor_inertia_kg_m2);
    if (inertia_kg_m2 && rotor_kg_m2 >= io::nearest(*inertia_kg_m2)) return false;
    const auto& backlash = problem_.floors.backlash_rad_per_mm;
    return !backlash || backlash_rad_per_mm() <= io::nearest(*backlash) * (1.0 + kSlack);
  }

  double backlash_rad_per_mm() const {
    const std::vector<double> teeth = gear_teeth<double>(parts_, choice_);
    std::vector<double> base_mm;
    for (std::size_t gear = 0; gear < teeth.size(); ++gear) {
      const Rational& module_mm = parts_.gear_layers[gear] == 0 ? module_1_mm_ : module_2_mm_;
      base_mm.push_back(0.5 * kReferenceCosine * io::nearest(module_mm) * teeth[gear]);
    }
    const auto by_mesh = mesh_backlash_rad_per_m(parts_, teeth, base_mm);
    return std::accumulate(by_mesh.begin(), by_mesh.end(), 0.0);
  }

  const Problem& problem_;
  const LayerModules& modules_;
  const TrainParts& parts_;
  bool has_first_ring_;
  bool has_second_layer_;
  std::size_t most_choices_;
  std::array<std::int64_t, 2> most_{};  ///< Teeth whose pitch circle fits the bore, by layer.
  std::vector<TrainChoice>& found_;
  TrainChoice choice_;
  Rational module_1_mm_, module_2_mm_;
  double shift_of_modules_ = 1.0;
  double least_ratio_ = 0.0, greatest_ratio_ = 0.0;
};

RootLimit root_limit(const GearMaterial& material, double cycles) {
  // The life curve at two notches gives the static limit's line; its ends are the standard's.
  const LifeCurve at_one = root_life(material, 1.0, 1.0);
  const LifeCurve at_two = root_life(material, 2.0, 1.0);
  RootLimit limit;
  limit.static_MPa = 1.0;
  limit.notch_slope = at_two.static_MPa - at_one.static_MPa;
  limit.notch_constant = at_one.static_MPa - limit.notch_slope;
  limit.endurance_MPa = at_one.endurance_MPa;
  const double range = std::log(at_one.endurance_cycles / at_one.static_cycles);
  limit.static_weight = std::clamp(std::log(at_one.endurance_cycles / cycles) / range, 0.0, 1.0);
  return limit;
}

void set_strength(const Problem& problem, InnerCase& inner) {
  const GearMaterial& steel = find_steel(*problem.steel)->material;
  const LoadFactors factors = assumed_factors(static_cast<std::int64_t>(inner.planets));
  const double cycles = problem.load_cycles ? io::nearest(*problem.load_cycles) : kAssumedCycles;
  const double common = factors.application * factors.dynamic * factors.load_sharing;
  inner.root = root_limit(steel, cycles);
  inner.alternating_bending = inner.held_layer == 0 ? factors.alternating_bending : 1.0;
  inner.root_factors = common * factors.face_load_root * kAssumedRootSafety;
  inner.flank_factors = common * factors.face_load_flank * square(kAssumedFlankSafety);
  const LifeCurve flank = flank_life(steel);
  inner.flank_limit_MPa = std::min(flank.static_MPa, flank.at_MPa(cycles));
  inner.elasticity =
      elasticity_factor(steel.young_MPa, steel.poisson, steel.young_MPa, steel.poisson);
}

/// F_t on the reference circle: torque over n m z/2, whatever the shifts.
void set_forces(const Problem& problem, InnerCase& inner) {
  const auto& z = inner.teeth;
  const double output_Nmm = 1e3 * io::nearest(torque_to_bear_Nm(problem));
  const double sun_Nmm = output_Nmm / inner.ratio;
  const auto force = [&](double torque_Nmm, std::size_t layer, double teeth) {
    return torque_Nmm / (inner.planets * inner.module_mm[layer] * teeth / 2.0);
  };
  const auto of_ring = [&](std::size_t layer) {
    const double torque_Nmm = layer == inner.held_layer ? output_Nmm - sun_Nmm : output_Nmm;
    return z[3 + layer] > 0.0 ? force(torque_Nmm, layer, z[3 + layer]) : 0.0;
  };
  inner.reference_force_N = {force(sun_Nmm, 0, z[0]), of_ring(0), of_ring(1)};
}

void set_stiffness(const Problem& problem, const TrainParts& parts, const GearMaterial& steel,
                   const std::vector<double>& teeth, InnerCase& inner) {
  const auto& least_Nm_rad = problem.floors.stiffness_Nm_rad;
  if (!least_Nm_rad) return;
  inner.most_softness_rad_Nm = 1.0 / io::nearest(*least_Nm_rad);
  std::vector<double> base_mm;
  for (std::size_t gear = 0; gear < teeth.size(); ++gear) {
    base_mm.push_back(0.5 * kReferenceCosine * inner.module_mm[parts.gear_layers[gear]] *
                      teeth[gear]);
  }
  const std::vector<double> turns = mesh_backlash_rad_per_m(parts, teeth, base_mm);
  const double pair =
      mesh_stiffness_N_mm_um(1.0) * steel.young_MPa / kStiffnessYoung_MPa * inner.planets;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const std::size_t gear = parts.meshes[i].gear_2;
    inner.mesh_softness[parts.is_ring(gear) ? 1 + parts.gear_layers[gear] : 0] =
        square(turns[i]) / pair;
  }
}

/// Which rings there are, and how all turn.
void set_motion(const TrainParts& parts, const std::vector<double>& teeth, InnerCase& inner) {
  inner.has_first_ring = parts.ring_of_layer(0).has_value();
  inner.has_second_layer = parts.layer_count() > 1;
  inner.held_layer = parts.gear_layers[parts.held_ring];
  if (parts.output_ring) inner.output_layer = parts.gear_layers[*parts.output_ring];
  const auto ratios = basic_ratios<double>(parts, teeth);
  const TrainSpeeds speeds = train_speeds(parts, teeth);
  inner.basic_ratio = {ratios.first, ratios.second};
  inner.carrier_speed_per_sun = speeds.carrier;
  inner.planet_speed_per_sun = speeds.gears[1];
  inner.ratio = ratios.reduction();
}

std::optional<double> number(const std::optional<Rational>& value) {
  if (!value) return std::nullopt;
  return io::nearest(*value);
}

void set_bounds(const Problem& problem, const Rational& module_mm, InnerCase& inner) {
  const Cutters cutters = stated_cutters(problem);
  inner.hob_depth = cutters.hob_depth();
  inner.shaper_depth = cutters.shaper_depth();
  inner.undercut_depth = undercut_depth(cutters);
  inner.hob_tip_radius = cutters.hob_tip_radius;
  inner.shaper_tip_radius = cutters.shaper_tip_radius;
  if (cutters.shaper_teeth) inner.shaper_teeth = static_cast<double>(*cutters.shaper_teeth);
  inner.ring_space_mm = io::nearest(ring_space_mm(problem));
  inner.min_contact_ratio = io::nearest(problem.min_contact_ratio);
  inner.min_neighbour_clearance_mm = io::nearest(problem.min_neighbour_clearance_mm);
  inner.sun_under_second_layer =
      may_sun_pass(train_parts(problem.topology)) && problem.sun_under_second_layer;
  inner.min_tip_thickness = io::nearest(problem.synthesis->least_tip_thickness);
  inner.least_shift = io::nearest(problem.synthesis->least_shift);
  inner.greatest_shift = io::nearest(problem.synthesis->greatest_shift);
  inner.min_face_width_mm = io::nearest(problem.synthesis->least_face_width_mm);
  inner.min_hollow_shaft_mm = number(problem.floors.hollow_shaft_mm);
  inner.hollow_shaft_wall_mm = io::nearest(hollow_shaft_wall_mm(problem, module_mm));
  inner.max_axial_length_mm = number(problem.floors.axial_length_mm);
  inner.friction = number(problem.friction_coefficient);
  inner.min_forward_efficiency = number(problem.floors.forward_efficiency);
  inner.min_backward_efficiency = number(problem.floors.backward_efficiency);
  inner.density_kg_m3 = io::nearest(*problem.density_kg_m3);
  inner.max_mass_kg = number(problem.floors.mass_kg);
}

}  // namespace

std::array<Rational, 2> greatest_face_widths_mm(const Problem& problem, const Design& design) {
  constexpr int kNone = 1'000'000;
  const SynthesisRequest& request = *problem.synthesis;
  const auto widest = [&](const Rational& module_mm, std::int64_t least_teeth) {
    Rational width_mm = request.greatest_face_width_mm.value_or(kNone);
    if (request.greatest_face_width_over_module) {
      width_mm = std::min(width_mm, Rational(*request.greatest_face_width_over_module * module_mm));
    }
    if (request.greatest_face_width_over_diameter) {
      width_mm = std::min(
          width_mm, Rational(*request.greatest_face_width_over_diameter * module_mm * least_teeth));
    }
    return width_mm;
  };
  return {widest(design.module_mm, std::min(design.teeth[0], design.teeth[1])),
          widest(design.layer_2_module_mm.value_or(design.module_mm), design.teeth[2])};
}

LayerModules layer_modules(const Problem& problem) {
  return {problem.module_mm, problem.synthesis->layer_2_module_mm};
}

Design design_of(const TrainParts& parts, const LayerModules& modules, const TrainChoice& choice) {
  Design design{gear_teeth<std::int64_t>(parts, choice), choice.planet_count,
                modules.first_mm[choice.module[0]]};
  if (!modules.second_mm.empty()) {
    const Rational& second_mm = modules.second_mm[choice.module[1]];
    if (second_mm != design.module_mm) design.layer_2_module_mm = second_mm;
  }
  return design;
}

std::vector<TrainChoice> train_choices(const Problem& problem, const LayerModules& modules,
                                       std::size_t most) {
  std::vector<TrainChoice> found;
  ChoiceWalk walk(problem, modules, most, found);
  for (const std::int64_t planets : problem.planet_count) {
    for (std::size_t first = 0; first < modules.first_mm.size(); ++first) {
      const std::size_t seconds = std::max<std::size_t>(1, modules.second_mm.size());
      for (std::size_t second = 0; second < seconds; ++second) walk.walk(planets, first, second);
    }
  }
  return found;
}

InnerCase inner_case(const Problem& problem, const LayerModules& modules,
                     const TrainChoice& choice) {
  const TrainParts& parts = train_parts(problem.topology);
  const Design design = design_of(parts, modules, choice);
  const Rational& second_mm = design.layer_2_module_mm.value_or(design.module_mm);
  InnerCase inner;
  for (std::size_t i = 0; i < 5; ++i) inner.teeth[i] = static_cast<double>(choice.teeth[i]);
  set_motion(parts, gear_teeth<double>(parts, choice), inner);
  inner.planets = static_cast<double>(choice.planet_count);
  inner.sine_of_half_spacing = std::sin(std::numbers::pi / inner.planets);
  inner.module_mm = {io::nearest(design.module_mm), io::nearest(second_mm)};
  inner.wall_mm = {io::nearest(ring_wall_mm(problem, design.module_mm)),
                   io::nearest(ring_wall_mm(problem, second_mm))};
  const auto widest_mm = greatest_face_widths_mm(problem, design);
  inner.max_face_width_mm = {io::nearest(widest_mm[0]), io::nearest(widest_mm[1])};
  set_bounds(problem, design.module_mm, inner);
  set_strength(problem, inner);
  set_forces(problem, inner);
  set_stiffness(problem, parts, find_steel(*problem.steel)->material,
                gear_teeth<double>(parts, choice), inner);
  if (const auto most = number(problem.floors.reflected_inertia_kg_m2)) {
    inner.max_gear_inertia_kg_m2 =
        *most - square(inner.ratio) * io::nearest(problem.rotor_inertia_kg_m2);
  }
  return inner;
}

std::optional<InnerBox> inner_box(const Problem& problem, const InnerCase& inner) {
  const double low = io::nearest(problem.synthesis->least_shift);
  const double high = io::nearest(problem.synthesis->greatest_shift);
  const double between = inner.teeth[0] + inner.teeth[1];
  const auto centre_mm = [&](double shifts) {
    const double involute =
        std::max(0.0, kReferenceInvolute + 2.0 * kReferenceTangent * shifts / between);
    const double tangent = tangent_of_involute(involute);
    return 0.5 * inner.module_mm[0] * between * kReferenceCosine *
           std::sqrt(1.0 + tangent * tangent);
  };
  const double first_mm =
      0.5 * inner.module_mm[0] * (inner.teeth[3] - inner.teeth[1]) * kReferenceCosine;
  // Below 0 where a layer has no ring.
  const double second_mm =
      0.5 * inner.module_mm[1] * (inner.teeth[4] - inner.teeth[2]) * kReferenceCosine;
  const double least_mm = std::max({centre_mm(2.0 * low), first_mm, second_mm}) * (1.0 + 1e-12);
  const double greatest_mm = centre_mm(2.0 * high);
  if (!(least_mm < greatest_mm)) return std::nullopt;
  return InnerBox{Interval{least_mm, greatest_mm}, Interval{low, high}};
}

}  // namespace torquewright::gearbox
