// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "tests/oracles/involute_meshes.hpp"
#include "tests/oracles/reals.hpp"
#include "tests/oracles/rule_families.hpp"

namespace torquewright::oracles {
namespace {

using Count = std::int64_t Teeth::*;
using Margin = long double (*)(std::int64_t, std::int64_t);
using Path = ContactPath (*)(std::int64_t, std::int64_t);

// A margin that is not a number (a ring's tip inside its base circle) fails.
Judgement not_negative(long double margin) {
  return {margin >= 0, std::fabs(margin) < kNearTie, margin};
}

Judgement positive(long double margin) {
  return {margin > 0, std::fabs(margin) < kNearTie, margin};
}

Rule carrier_clearance(const Setting& setting) {
  const std::int64_t planets = setting.planet_count;
  const long double half_pitch_rad = kPi / real(planets);
  const long double least_rad = to_long_double(setting.problem.min_carrier_clearance_rad);
  return {"carrier_clearance", [=](const Teeth& teeth) {
            // Without a clearance this is sin(pi/n) >= P1/(S + P1), and by Niven's theorem the only
            // equality is sin(pi/6) = 1/2. With one there is none: e^(i x) is transcendental.
            if (least_rad == 0 && planets == 6 && teeth.sun == teeth.planet_1) {
              return Judgement{true, false, 0};
            }
            const long double angle_rad =
                std::asin(real(teeth.planet_1) / real(teeth.sun + teeth.planet_1));
            return not_negative(half_pitch_rad - angle_rad - least_rad);
          }};
}

// 2 a sin(pi/n) - m (P + 2) - limit as a fraction, for the counts whose sine is one.
Rational clearance_of_six(const Teeth& teeth, Count planet, const Rational& module,
                          const Rational& limit) {
  return module * Rational(teeth.sun + teeth.planet_1) / 2 - module * (teeth.*planet + 2) - limit;
}

Rule neighbour_clearance(const Setting& setting, std::string name, Count planet) {
  const Rational module = setting.module_mm;
  const Rational limit = setting.problem.min_neighbour_clearance_mm;
  const long double module_mm = to_long_double(module);
  const long double limit_mm = to_long_double(limit);
  const long double sine = std::sin(kPi / real(setting.planet_count));
  const bool rational_sine = setting.planet_count == 6;
  return {std::move(name), [=](const Teeth& teeth) {
            const long double distance_mm = module_mm * real(teeth.sun + teeth.planet_1) / 2;
            const long double margin_mm =
                2 * distance_mm * sine - module_mm * real(teeth.*planet + 2) - limit_mm;
            if (rational_sine && std::fabs(margin_mm) < kNearTie) {
              return Judgement{clearance_of_six(teeth, planet, module, limit) > 0, false, 0};
            }
            return positive(margin_mm);
          }};
}

Rule undercut(const Setting& setting, std::string name, Count gear) {
  const long double sine = std::sin(pressure_angle_rad());
  const auto& cutters = setting.problem.cutters;
  const long double addendum = to_long_double(cutters.hob_depth());
  const long double depth = cutters.hob_tip_radius
                                ? straight_depth(addendum, to_long_double(*cutters.hob_tip_radius))
                                : std::max(1.0L, straight_depth(addendum, 0.38L));
  const long double least = 2 * depth / (sine * sine);
  return {std::move(name),
          [=](const Teeth& teeth) { return not_negative(real(teeth.*gear) - least); }};
}

Rule ring_tip(const Setting& setting, std::string name, Count ring) {
  const long double module_mm = to_long_double(setting.module_mm);
  const long double cosine = std::cos(pressure_angle_rad());
  return {std::move(name), [=](const Teeth& teeth) {
            const long double z = real(teeth.*ring);
            return positive(module_mm * (z - 2 - z * cosine) / 2);
          }};
}

Rule interference(std::string name, Margin margin, Count planet, Count ring) {
  return {std::move(name),
          [=](const Teeth& teeth) { return not_negative(margin(teeth.*planet, teeth.*ring)); }};
}

Rule contact_ratio(const Setting& setting, std::string name, Path path, Count first, Count second) {
  const long double least = to_long_double(setting.problem.min_contact_ratio);
  return {std::move(name), [=](const Teeth& teeth) {
            return not_negative(path(teeth.*first, teeth.*second).ratio() - least);
          }};
}

// Of stated cutters only; of assumed ones a test shows that they never fail.
void add_root_form(const Setting& setting, const std::string& mesh, Count planet, Count ring,
                   std::vector<Rule>& list) {
  const gearbox::StatedCutters& cutters = setting.problem.cutters;
  if (cutters.hob_tip_radius || cutters.hob_addendum) {
    const long double depth = straight_depth(to_long_double(cutters.hob_depth()),
                                             to_long_double(cutters.hob_tip_radius.value_or(0)));
    list.push_back({"root_form.hob." + mesh, [=](const Teeth& teeth) {
                      return not_negative(depth - depth_at_ring_tip(teeth.*ring));
                    }});
  }
  const long double radius = to_long_double(cutters.shaper_tip_radius.value_or(0));
  const long double addendum = to_long_double(cutters.shaper_depth());
  const std::optional<std::int64_t> stated = cutters.shaper_teeth;
  if (stated || (cutters.shaper_addendum && cutters.shaper_tip_radius)) {
    list.push_back({"root_form.shaper." + mesh, [=](const Teeth& teeth) {
                      const std::int64_t shaper = stated.value_or(teeth.*planet);
                      if (teeth.*ring <= shaper) return Judgement{false, false, 0};
                      return not_negative(reach_of_shaper(shaper, addendum, radius) -
                                          reach_of_planet(teeth.*planet));
                    }});
  }
  if (stated) {
    // The simulation is slow, and rings repeat.
    auto known = std::make_shared<std::map<std::int64_t, long double>>();
    list.push_back({"shaper_feed." + mesh, [=](const Teeth& teeth) {
                      const std::int64_t z = teeth.*ring;
                      if (z <= *stated) return Judgement{false, false, 0};
                      if (!known->contains(z)) {
                        (*known)[z] = height_over_fed_shaper(z, *stated, addendum, radius);
                      }
                      return not_negative(known->at(z));
                    }});
  }
}

void add_root_form_of_gears(const Setting& setting, const std::string& mesh,
                            std::vector<Rule>& list) {
  const gearbox::StatedCutters& cutters = setting.problem.cutters;
  if (!cutters.hob_tip_radius || !cutters.hob_addendum) return;
  const long double depth = straight_depth(to_long_double(*cutters.hob_addendum),
                                           to_long_double(*cutters.hob_tip_radius));
  list.push_back({"root_form.hob." + mesh, [=](const Teeth& teeth) {
                    return not_negative(depth - std::max(depth_at_gear_tip(teeth.sun),
                                                         depth_at_gear_tip(teeth.planet_1)));
                  }});
}

std::vector<Rule> rules_of_3k(const Setting& setting) {
  const auto S = &Teeth::sun, P1 = &Teeth::planet_1, P2 = &Teeth::planet_2;
  const auto F = &Teeth::fixed_ring, O = &Teeth::output_ring;
  return {
      neighbour_clearance(setting, "neighbour_clearance.layer_1", P1),
      neighbour_clearance(setting, "neighbour_clearance.layer_2", P2),
      undercut(setting, "undercut.sun", S),
      undercut(setting, "undercut.planet_1", P1),
      undercut(setting, "undercut.planet_2", P2),
      ring_tip(setting, "ring_tip.fixed_ring", F),
      ring_tip(setting, "ring_tip.output_ring", O),
      interference("interference.involute.planet_1_fixed_ring", involute_margin, P1, F),
      interference("interference.involute.planet_2_output_ring", involute_margin, P2, O),
      interference("interference.trochoid.planet_1_fixed_ring", trochoid_margin_rad, P1, F),
      interference("interference.trochoid.planet_2_output_ring", trochoid_margin_rad, P2, O),
      contact_ratio(setting, "contact_ratio.sun_planet_1", external_path, S, P1),
      contact_ratio(setting, "contact_ratio.planet_1_fixed_ring", internal_path, P1, F),
      contact_ratio(setting, "contact_ratio.planet_2_output_ring", internal_path, P2, O),
  };
}

std::vector<Rule> rules_of_planetary(const Setting& setting) {
  const auto S = &Teeth::sun, P = &Teeth::planet_1, R = &Teeth::fixed_ring;
  return {
      neighbour_clearance(setting, "neighbour_clearance.layer_1", P),
      undercut(setting, "undercut.sun", S),
      undercut(setting, "undercut.planet", P),
      ring_tip(setting, "ring_tip.ring", R),
      interference("interference.involute.planet_ring", involute_margin, P, R),
      interference("interference.trochoid.planet_ring", trochoid_margin_rad, P, R),
      contact_ratio(setting, "contact_ratio.sun_planet", external_path, S, P),
      contact_ratio(setting, "contact_ratio.planet_ring", internal_path, P, R),
  };
}

}  // namespace

std::vector<Rule> real_rules(const Setting& setting) {
  std::vector<Rule> list{carrier_clearance(setting)};
  if (!is_buildable(setting.problem)) return list;
  const auto buildable = is_3k(setting.problem) ? rules_of_3k : rules_of_planetary;
  for (Rule& rule : buildable(setting)) list.push_back(std::move(rule));
  if (is_3k(setting.problem)) {
    add_root_form_of_gears(setting, "sun_planet_1", list);
    add_root_form(setting, "planet_1_fixed_ring", &Teeth::planet_1, &Teeth::fixed_ring, list);
    add_root_form(setting, "planet_2_output_ring", &Teeth::planet_2, &Teeth::output_ring, list);
  } else {
    add_root_form_of_gears(setting, "sun_planet", list);
    add_root_form(setting, "planet_ring", &Teeth::planet_1, &Teeth::fixed_ring, list);
  }
  return list;
}

}  // namespace torquewright::oracles
