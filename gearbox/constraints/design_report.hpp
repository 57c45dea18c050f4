// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearbox/problem.hpp"

namespace torquewright::gearbox {

/// A constraint at one design. It is satisfied by margin >= 0 (> 0 where strict); the margin says
/// how far inside the value is, in its unit.
struct ConstraintReport {
  std::string name;  ///< Name as in docs/gearbox_constraints.md.
  std::string key;   ///< JSON pointer of the bound that sets the limit; empty: none.
  double value = 0.0;
  double limit = 0.0;
  double margin = 0.0;
  std::string unit;
  bool satisfied = false;
  std::string sentence;
};

/// A note that forbids nothing: trimming, hunting tooth, phasing, ring blank.
struct Remark {
  std::string name;
  std::string sentence;
};

struct GearReport {
  std::string name;  ///< Name of the gear: sun, planet_1, ...
  std::int64_t teeth = 0;
  std::string layer;  ///< Layer: layer_1 or layer_2.
  bool internal = false;
  double module_mm = 0.0;
  double profile_shift = 0.0;  ///< Profile shift in modules; of a ring positive outwards.
  double pitch_diameter_mm = 0.0;
  double tip_diameter_mm = 0.0;
  double root_diameter_mm = 0.0;
  double base_diameter_mm = 0.0;
  double speed_per_input = 0.0;  ///< Absolute speed over the sun's. Dimensionless, signed.
};

struct MeshReport {
  std::string name;         ///< Name of the mesh: sun_planet_1, planet_1_fixed_ring, ...
  double efficiency = 1.0;  ///< Basic (carrier fixed). NaN-free: 1 if friction is absent.
  double contact_ratio = 0.0;
  double approach_ratio = 0.0;  ///< epsilon_A: path beyond the pitch point at the mate's tip.
  double recess_ratio = 0.0;    ///< epsilon_R
  /// Working angle of a shifted design; 0 where the gears do not mesh.
  double working_angle_rad = 0.0;
  double forward_loss = 0.0;   ///< Share of the input power, sun driving; sum 1 - efficiency.
  double backward_loss = 0.0;  ///< Share of the input power, output driving; all 0 if self-locking.
  /// Share of the forward loss, without friction of its limit; all sum to 1.
  double loss_share = 0.0;
  /// Share of the output backlash for equal mesh backlash; all sum to 1.
  double backlash_share = 0.0;
  double tangential_force_N = 0.0;  ///< Force per planet at the load; 0 if no load is given.
};

/// All results for one design.
struct DesignReport {
  Design design;
  std::vector<GearReport> gears;  ///< Gears in the topology's order.
  std::vector<MeshReport> meshes;
  std::int64_t planet_types = 1;  ///< Number of different planets needed; 1: all alike.
  Rational ratio;                 ///< Sun over output, signed.
  double carrier_speed_per_input = 0.0;
  double centre_distance_mm = 0.0;  ///< Centre distance of sun and planet 1, of a shifted design.
  double objective = 0.0;           ///< Value of the problem's objective, as the user reads it.
  std::string objective_unit;
  double forward_efficiency = 1.0;   ///< 1 where no friction coefficient is given.
  double backward_efficiency = 1.0;  ///< 0 if self-locking.
  bool self_locking = false;
  double hollow_shaft_diameter_mm = 0.0;
  double ring_blank_diameter_mm = 0.0;  ///< Largest ring's root circle plus two walls.
  std::optional<double> mass_kg;        ///< Mass of the gears; needs face widths and density.
  std::optional<double> reflected_inertia_kg_m2;        ///< Inertia at the output; needs the same.
  std::optional<double> rotor_inertia_at_output_kg_m2;  ///< The motor's share, if it is given.
  std::optional<double> input_torque_Nm;                ///< Lossless, at the given load.
  /// Torque at the sun that delivers the load in spite of losses.
  std::optional<double> driving_torque_Nm;
  std::optional<double>
      backdriven_torque_Nm;  ///< Torque at the sun when the load drives; 0: self-locking.
  std::optional<double> fixed_ring_torque_Nm;    ///< Lossless, at the given load.
  std::optional<double> planet_tilting_force_N;  ///< Force in each layer that tilts a planet.
  /// Backlash at the output for the same normal backlash in every mesh.
  double output_backlash_rad_per_mm = 0.0;
  std::vector<ConstraintReport> constraints;
  std::vector<Remark> remarks;

  bool feasible() const;
};

}  // namespace torquewright::gearbox
