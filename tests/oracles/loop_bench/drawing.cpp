// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/oracles/loop_bench/draws.hpp"
#include "tests/oracles/loop_bench/hidden_laws.hpp"
#include "tests/oracles/loop_bench/recover.hpp"
#include "tests/oracles/loop_bench/situation.hpp"
#include "tests/oracles/loop_bench/undecidable.hpp"

namespace torquewright::oracles::loop {
namespace {

using std::numbers::pi;

struct Scale {
  double torque_Nm = 0.0;      ///< That the joint takes.
  double inertia_kg_m2 = 0.0;  ///< Of the load.
};

Link link_of(double mass_kg, double length_m, Draws& draws) {
  return {mass_kg, length_m, length_m * draws.uniform(0.35, 0.6),
          mass_kg * length_m * length_m / 12.0};
}

std::vector<Link> drawn_links(const std::string& shape, Draws& draws) {
  if (shape == "flywheel") return {{0.0, 0.0, 0.0, draws.log_uniform(0.003, 0.2)}};
  if (shape == "pendulum") {
    const double mass = draws.log_uniform(0.3, 8.0), length = draws.uniform(0.1, 0.5);
    return {{mass, length, length, mass * length * length * draws.uniform(0.0, 0.2)}};
  }
  if (shape == "leg")  // a heavy thigh and a light shank
    return {link_of(draws.uniform(0.8, 3.0), draws.uniform(0.18, 0.35), draws),
            link_of(draws.uniform(0.2, 0.7), draws.uniform(0.18, 0.35), draws)};
  return {link_of(draws.uniform(1.0, 5.0), draws.uniform(0.2, 0.45), draws),
          link_of(draws.uniform(0.8, 3.0), draws.uniform(0.2, 0.4), draws)};
}

std::vector<Scale> scales_of(const std::vector<Link>& links) {
  Rig rig;
  rig.links = links;
  std::vector<Scale> scales;
  const LinkTorques level = link_torques(rig, {0.5 * pi, 0.0}, {});
  scales.push_back({std::max(level.bias_Nm[0], 30.0 * level.m11), level.m11});
  if (links.size() > 1) scales.push_back({std::max(level.bias_Nm[1], 30.0 * level.m22), level.m22});
  return scales;
}

Drive drawn_drive(const Scale& scale, Draws& draws) {
  Drive drive;
  drive.ratio = std::round(draws.uniform(6.0, 30.0) * 100.0) / 100.0 + 0.003;
  drive.torque_constant_Nm_A = draws.log_uniform(0.03, 0.2);
  drive.peak_current_A =
      scale.torque_Nm * draws.uniform(3.0, 6.0) / drive.torque_per_current_Nm_A();
  drive.rotor_inertia_kg_m2 =
      scale.inertia_kg_m2 * draws.uniform(0.03, 0.4) / (drive.ratio * drive.ratio);
  // A winding that can drive its peak current and 15 rad/s at once, with a reserve.
  drive.resistance_ohm = draws.uniform(0.1, 0.3) * 48.0 / drive.peak_current_A;
  drive.bus_V = std::max(48.0, 1.6 * 15.0 * drive.torque_per_current_Nm_A());
  if (draws.chance(0.5))
    drive.stated.push_back(
        {"coulomb_friction", {{"coulomb_Nm", scale.torque_Nm * draws.uniform(0.02, 0.08)}}});
  if (draws.chance(0.5))
    drive.stated.push_back(
        {"viscous_friction", {{"viscous_Nm_s_rad", scale.torque_Nm * draws.uniform(0.003, 0.02)}}});
  return drive;
}

Reference drawn_reference(const Scale& scale, Draws& draws) {
  Reference asked;
  asked.middle_rad = draws.uniform(-0.6, 0.6);
  const double most_rad_s2 = 0.5 * scale.torque_Nm / scale.inertia_kg_m2;
  const int waves = draws.chance(0.3) ? 1 : draws.chance(0.5) ? 2 : 3;
  for (int k = 0; k < waves; ++k) {
    const double rate = draws.log_uniform(0.6, 12.0);
    asked.waves.push_back({std::min(draws.uniform(0.3, 1.2), most_rad_s2 / (rate * rate)) / waves,
                           rate, draws.uniform(-pi, pi)});
  }
  if (draws.chance(0.5)) {
    asked.ramp_rad = draws.uniform(0.2, 1.2);
    asked.ramp_period_s = draws.uniform(3.0, 6.0);
  }
  return asked;
}

Sensing drawn_sensing(const Situation& it, Draws& draws) {
  Sensing sensing;
  sensing.seed = it.seed;
  sensing.rate_Hz = draws.one_of(std::vector<double>{100, 200, 500, 1000, 2000, 5000});
  sensing.counts_per_turn = draws.one_of(std::vector<double>{16384, 65536, 262144});
  sensing.current_filter_Hz = draws.one_of(std::vector<double>{100, 200, 500, 1000});
  sensing.current_noise_A = it.rig.drives.front().peak_current_A * draws.log_uniform(0.001, 0.01);
  sensing.voltage_noise_V = draws.log_uniform(0.01, 0.1);
  sensing.logs_velocity = draws.chance(0.7);
  sensing.logs_voltage = it.rig.joints() == 1 && draws.chance(0.3);
  if (it.rig.joints() > 1)
    sensing.joint_names = it.rig.shape == "leg" ? std::vector<std::string>{"hip", "knee"}
                                                : std::vector<std::string>{"shoulder", "elbow"};
  return sensing;
}

void draw_loop_and_runs(const std::vector<Scale>& scales, Draws& draws, Situation& it) {
  it.loop.period_s = draws.one_of(std::vector<double>{2e-4, 1e-3});
  for (const Scale& scale : scales) {
    it.loop.stiffness_Nm_rad.push_back(scale.torque_Nm * draws.uniform(8.0, 25.0));
    it.loop.damping_Nm_s_rad.push_back(
        1.4 * std::sqrt(it.loop.stiffness_Nm_rad.back() * scale.inertia_kg_m2));
  }
  const bool is_fast = it.sensing.rate_Hz > 1500.0;
  const int count = is_fast ? 4 : 6;
  for (int k = 0; k < count; ++k) {
    Run run{is_fast ? 6.0 : 10.0, {}};
    for (const Scale& scale : scales) run.references.push_back(drawn_reference(scale, draws));
    it.runs.push_back(run);
  }
}

/// Two laws of dry friction that each state a level are one law; so are viscous and asymmetric.
bool may_stand_beside(const std::string& one, const std::string& other) {
  static const std::vector<std::string> kLevels{"coulomb_friction", "stribeck_friction",
                                                "asymmetric_friction",
                                                "position_dependent_friction"};
  const auto has_level = [&](const std::string& name) {
    return std::find(kLevels.begin(), kLevels.end(), name) != kLevels.end();
  };
  const auto is_pair = [&](const char* a, const char* b) {
    return (one == a && other == b) || (one == b && other == a);
  };
  return one != other && !(has_level(one) && has_level(other)) &&
         !is_pair("viscous_friction", "asymmetric_friction");
}

void draw_hidden(const std::vector<Scale>& scales, double share_factor, Draws& draws,
                 Situation& it) {
  const std::size_t count = it.kind == "none" ? 0 : it.kind == "two" ? 2 : 1;
  const auto names =
      it.kind == "outside" ? names_outside() : names_for(it.rig, it.sensing.logs_voltage);
  while (it.hidden.size() < count) {
    const std::string& name = draws.one_of(names);
    const double share = std::min(draws.log_uniform(0.003, 0.25) * share_factor, 0.3);
    if (it.hidden.empty() || may_stand_beside(it.hidden.front(), name))
      hide(name, share, scales[it.joint].torque_Nm, draws, it);
  }
}

Situation drawn_with(const std::string& kind, std::uint64_t seed, double share_factor) {
  Draws draws(seed * 7919 + static_cast<std::uint64_t>(kind.front()));
  Situation it;
  it.kind = kind;
  it.seed = seed;
  it.rig.shape = draws.one_of(std::vector<std::string>{"flywheel", "pendulum", "arm", "leg"});
  if (kind == "undecidable") it.rig.shape = "flywheel";
  it.rig.links = drawn_links(it.rig.shape, draws);
  const auto scales = scales_of(it.rig.links);
  for (const Scale& scale : scales) it.rig.drives.push_back(drawn_drive(scale, draws));
  it.sensing = drawn_sensing(it, draws);
  draw_loop_and_runs(scales, draws, it);
  it.joint = it.rig.joints() > 1 && draws.chance(0.5) ? 1 : 0;
  if (kind == "undecidable") {
    draw_undecidable(scales[0].torque_Nm, share_factor, draws, it);
    return it;
  }
  draw_hidden(scales, share_factor, draws, it);
  if (kind == "outside") {
    it.accept.clear();
    const std::string& name = it.hidden.front();
    it.coordinates = name == "tight_spot"          ? std::vector<std::string>{"output_position_rad"}
                     : name == "current_dead_band" ? std::vector<std::string>{"motor_current_A"}
                                                   : std::vector<std::string>{"time_s"};
  }
  return it;
}

Made recorded(Situation situation) {
  Made out;
  for (std::size_t run = 0; run < situation.runs.size(); ++run) {
    auto states = moved(situation.rig, situation.loop, situation.runs[run]);
    const auto before = static_cast<std::ptrdiff_t>(situation.runs[run].before_s / kStep_s);
    states.erase(states.begin(), states.begin() + before);
    out.records.push_back(sensed(situation.rig, situation.sensing, states, run));
  }
  out.situation = std::move(situation);
  recover(out);
  return out;
}

}  // namespace

Situation drawn(const std::string& kind, std::uint64_t seed) {
  static const std::vector<std::string> kKinds{"none", "one", "two", "undecidable", "outside"};
  if (std::find(kKinds.begin(), kKinds.end(), kind) == kKinds.end())
    throw std::invalid_argument("classes: none, one, two, undecidable, outside");
  return drawn_with(kind, seed, 1.0);
}

Made made(const std::string& kind, std::uint64_t seed) {
  Made out = recorded(drawn(kind, seed));
  double factor = 1.0;
  for (int tries = 0; tries < 8 && !out.size_floors.empty(); ++tries) {
    const auto [least, most] = std::minmax_element(out.size_floors.begin(), out.size_floors.end());
    if (*least >= 1.0 && *most <= 300.0) break;
    factor *= *least < 1.0 ? 1.7 : 0.6;
    out = recorded(drawn_with(kind, seed, factor));
  }
  return out;
}

}  // namespace torquewright::oracles::loop
