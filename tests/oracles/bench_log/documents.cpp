// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/bench_log/documents.hpp"

namespace torquewright::oracles {
namespace {

using nlohmann::json;

json declared_effects(const Friction& friction) {
  json effects = json::array();
  const auto add = [&](const char* effect, const char* parameter, double value) {
    if (value == 0.0) return;
    effects.push_back(
        {{"effect", effect}, {"parameters", {{parameter, value}}}, {"provenance", "measured"}});
  };
  add("coulomb_friction", "coulomb_Nm", friction.coulomb_positive_Nm);
  add("viscous_friction", "viscous_Nm_s_rad", friction.viscous_positive_Nm_s_rad);
  return effects;
}

json load_of(const Bench& bench) {
  const StatedLoad& stated = bench.stated;
  switch (bench.nominal.load.type) {
    case Load::Type::kDynamometer:
      return {{"type", "dynamometer"}};
    case Load::Type::kFree:
      return {{"type", "free"}, {"inertia_kg_m2", stated.inertia_kg_m2}};
    case Load::Type::kPendulum:
      return {{"type", "pendulum"},
              {"mass_kg", stated.mass_kg},
              {"length_m", stated.length_m},
              {"inertia_kg_m2", stated.inertia_kg_m2}};
    case Load::Type::kLinearAxis:
      return {{"type", "linear_axis"}, {"mass_kg", stated.mass_kg}};
  }
  return {};
}

json effect_of(const TrueEffect& effect) {
  json parameters = effect.parameters;
  if (!effect.channel.empty()) parameters["channel"] = effect.channel;
  const char* amplitude = effect.proportional ? "amplitude_ratio" : "amplitude_Nm";
  for (const Harmonic& term : effect.harmonics) {
    parameters["harmonics"].push_back(
        {{"order", term.order}, {amplitude, term.amplitude}, {"phase_rad", term.phase_rad}});
  }
  if (effect.effect == "gear_ripple") parameters["proportional"] = effect.proportional;
  return {{"effect", effect.effect},
          {"family", effect.family},
          {"parameters", parameters},
          {"corrected", effect.corrected},
          {"equation", effect.equation},
          {"residual_rms", effect.residual_rms},
          {"noise_multiple", effect.noise_multiple},
          {"same_as", effect.same_as}};
}

}  // namespace

json actuator_document(const Bench& bench) {
  const Machine& machine = bench.nominal;
  return {{"kind", "actuator"},
          {"version", 1},
          {"name", "drive on the bench"},
          {"motor",
           {{"torque_constant_Nm_A", machine.torque_constant_Nm_A},
            {"torque_constant_convention", "dc"},
            {"resistance_ohm", machine.resistance_ohm},
            {"resistance_convention", "dc"},
            {"pole_pairs", machine.pole_pairs},
            {"rotor_inertia_kg_m2", machine.rotor_inertia_kg_m2},
            {"winding_temperature_K", machine.reference_K}}},
          {"drive", {{"bus_voltage_V", machine.bus_V}, {"peak_current_A", machine.peak_current_A}}},
          {"thermal",
           {{"winding_to_case_K_W", machine.winding_to_case_K_W},
            {"case_to_ambient_K_W", machine.case_to_ambient_K_W},
            {"winding_J_K", machine.winding_J_K},
            {"case_J_K", machine.case_J_K},
            {"winding_limit_K", 420.0}}},
          {"gearbox",
           {{"ratio", machine.ratio},
            {"forward_efficiency", machine.forward_efficiency},
            {"backward_efficiency", machine.backward_efficiency}}},
          {"effects", declared_effects(machine.friction)}};
}

json rig_document(const Bench& bench) {
  json columns{{"t_s", "time_s"}};
  for (const Channel& channel : bench.channels) {
    if (channel.column_scale == 1.0) {
      columns[channel.column] = channel.quantity;
    } else {
      columns[channel.column] = {{"quantity", channel.quantity}, {"scale", channel.column_scale}};
    }
  }
  if (bench.one_file) columns["run"] = "run";
  json rig{{"kind", "rig"},
           {"version", 1},
           {"name", "bench"},
           {"columns", columns},
           {"load", load_of(bench)}};
  if (bench.has_ignored_column) rig["ignore"] = {"row"};
  if (bench.runs.size() > 2) {
    for (std::size_t r = bench.runs.size() - 2; r < bench.runs.size(); ++r) {
      rig["holdout_runs"].push_back(bench.runs[r].name);
    }
  }
  if (!bench.uncertain.empty()) rig["uncertain"] = bench.uncertain;
  return rig;
}

json truth_document(const Scenario& scenario) {
  const Truth& truth = scenario.truth;
  json effects = json::array();
  for (const TrueEffect& effect : truth.effects) effects.push_back(effect_of(effect));
  json noise = json::array();
  for (const ChannelNoise& channel : truth.noise) {
    noise.push_back({{"quantity", channel.quantity},
                     {"sigma", channel.sigma},
                     {"resolution", channel.resolution}});
  }
  return {{"scenario", scenario.name},
          {"class", name_of(truth.log_class)},
          {"seed", scenario.seed},
          {"effects", effects},
          {"phenomenon", truth.phenomenon},
          {"phenomenon_rms", truth.phenomenon_rms},
          {"coordinates", truth.coordinates},
          {"acceptable", truth.acceptable},
          {"situation", truth.situation},
          {"noise", noise},
          {"band_hz", truth.band_hz},
          {"noise_floor_rms", truth.noise_floor_rms}};
}

}  // namespace torquewright::oracles
