// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/random_plant.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::oracles::sampled {
namespace {

double random_ratio(bool is_linear, Draw& draw) {
  if (is_linear) return draw.uniform(40.0, 600.0);  // rad of the rotor per metre
  if (draw.chance(0.1)) return 1.0;
  const double ratio = draw.log_uniform(3.0, 160.0);
  return draw.chance(0.5) ? std::round(ratio) : std::round(ratio * 100.0) / 100.0;
}

/// Motion that the rig allows: speeds of some Hz on a pendulum, of a drive elsewhere.
void size_motion(Plant& plant, Draw& draw) {
  if (plant.load.kind == LoadKind::kPendulum) {
    plant.used_angle_rad = draw.uniform(0.7, 1.8);
    plant.used_speed_rad_s = plant.used_angle_rad * kTwoPi * draw.uniform(0.4, 0.9);
  } else if (plant.load.kind == LoadKind::kLinearAxis) {
    plant.used_angle_rad = draw.uniform(0.1, 0.5);
    plant.used_speed_rad_s = plant.used_angle_rad * kTwoPi * draw.uniform(0.3, 0.8);
  } else {
    plant.used_speed_rad_s = std::min(draw.log_uniform(2.0, 30.0), 700.0 / plant.ratio);
    plant.used_angle_rad = plant.used_speed_rad_s / kTwoPi;
  }
}

/// All that moves takes `share` of the torque at the used speed and a hertz or so.
void size_inertia(Plant& plant, Draw& draw) {
  Load& load = plant.load;
  const double scale = plant.used_torque_Nm / (plant.used_speed_rad_s * kTwoPi);
  const double moved = scale * draw.log_uniform(0.2, 1.0);
  if (load.kind == LoadKind::kImposedSpeed) {
    plant.rotor_inertia_kg_m2 = 0.3 * moved / (plant.ratio * plant.ratio);
    return;
  }
  const double rotor_share = draw.uniform(0.1, 0.5);
  plant.rotor_inertia_kg_m2 = rotor_share * moved / (plant.ratio * plant.ratio);
  load.inertia_kg_m2 = (1.0 - rotor_share) * moved;
  if (load.kind != LoadKind::kPendulum) return;
  // A weight of a share of the torque, so long that its inertia is what was drawn.
  const double weight_Nm = draw.uniform(0.2, 0.45) * plant.used_torque_Nm;
  const double slender = draw.uniform(0.05, 0.3);
  load.length_m = load.inertia_kg_m2 * kGravity_m_s2 / (weight_Nm * (1.0 + slender));
  load.mass_kg = weight_Nm / (kGravity_m_s2 * load.length_m);
  load.inertia_kg_m2 = slender * load.mass_kg * load.length_m * load.length_m;
}

void size_winding(Plant& plant, Draw& draw) {
  static const std::vector<double> kBuses_V{12, 24, 36, 48, 60, 100, 325};
  plant.bus_V = draw.one_of(kBuses_V);
  const double rotor_rad_s = plant.ratio * plant.used_speed_rad_s;
  plant.torque_constant_Nm_A = plant.bus_V / (draw.uniform(1.6, 2.6) * rotor_rad_s);
  const double used_A = plant.used_torque_Nm / plant.Nm_per_A();
  plant.peak_current_A = draw.uniform(2.2, 3.0) * used_A;
  plant.resistance_ohm = draw.uniform(0.1, 0.25) * plant.bus_V / (1.5 * used_A);
  // So small that what it takes in the band of the motion stays below the noise: it is not stated.
  plant.inductance_H = plant.resistance_ohm * draw.log_uniform(2e-5, 1e-4);
}

/// Runs warm the winding by 5 to 40 K.
void size_heating(Plant& plant, Draw& draw) {
  const double used_A = 0.5 * plant.used_torque_Nm / plant.Nm_per_A();
  const double copper_W = plant.resistance_ohm * used_A * used_A;
  plant.heating.winding_to_case_K_W = draw.uniform(20.0, 50.0) / copper_W;
  plant.heating.case_to_ambient_K_W = draw.uniform(20.0, 40.0) / copper_W;
  plant.heating.winding_J_K = draw.uniform(10.0, 40.0) / plant.heating.winding_to_case_K_W;
  plant.heating.case_J_K = plant.heating.winding_J_K * draw.uniform(5.0, 15.0);
}

/// Values of a machine that a shop would sell.
bool is_plausible(const Plant& plant) {
  const double used_A = plant.used_torque_Nm / plant.Nm_per_A();
  const bool winds = used_A > 0.2 && used_A < 300.0 && plant.torque_constant_Nm_A < 9.0 &&
                     plant.torque_constant_Nm_A > 5e-4 && plant.resistance_ohm < 500.0;
  const double length = plant.load.length_m;
  const bool swings = plant.load.kind != LoadKind::kPendulum || (length > 0.02 && length < 3.0);
  const auto within = [](double value, double least, double most) {
    return value >= least && value <= most;
  };
  const Heating& heat = plant.heating;
  return winds && swings && within(plant.rotor_inertia_kg_m2, 1e-9, 5.0) &&
         within(heat.winding_to_case_K_W, 0.002, 900.0) &&
         within(heat.case_to_ambient_K_W, 0.002, 900.0);
}

}  // namespace

Plant random_plant(LoadKind load, DriveKind drive, Draw& draw) {
  for (;;) {  // half of the draws are plausible
    Plant plant;
    plant.load.kind = load;
    plant.drive = drive;
    plant.ratio = random_ratio(load == LoadKind::kLinearAxis, draw);
    plant.used_torque_Nm = 0.5 * draw.log_uniform(0.1, 1000.0);
    size_motion(plant, draw);
    size_inertia(plant, draw);
    size_winding(plant, draw);
    size_heating(plant, draw);
    if (draw.chance(0.5)) {
      plant.forward_efficiency = std::round(draw.uniform(0.82, 0.98) * 1000.0) / 1000.0;
      plant.backward_efficiency = std::round(draw.uniform(0.75, 0.97) * 1000.0) / 1000.0;
    }
    if (is_plausible(plant)) return plant;
  }
}

}  // namespace torquewright::oracles::sampled
