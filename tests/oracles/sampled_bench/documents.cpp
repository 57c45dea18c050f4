// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/documents.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "tests/oracles/sampled_bench/outside.hpp"
#include "tests/oracles/sampled_bench/sizes.hpp"

namespace torquewright::oracles::sampled {
namespace {

using nlohmann::json;

std::string nine_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

/// All numbers to nine significant digits.
void shorten(json& node) {
  if (node.is_number_float()) {
    node = std::strtod(nine_digits(node.get<double>()).c_str(), nullptr);
  } else if (node.is_structured()) {
    for (json& child : node) shorten(child);
  }
}

json nine_digit_numbers(json node) {
  shorten(node);
  return node;
}

json effects_of(const std::vector<Effect>& effects, bool is_statement) {
  json list = json::array();
  for (const Effect& effect : effects) {
    list.push_back({{"effect", effect.name}, {"parameters", effect.parameters}});
    if (is_statement) list.back()["provenance"] = "stated";
  }
  return list;
}

json load_of(const Load& load) {
  switch (load.kind) {
    case LoadKind::kFree:
      return {{"type", "free"}, {"inertia_kg_m2", load.inertia_kg_m2}};
    case LoadKind::kPendulum:
      return {{"type", "pendulum"},
              {"mass_kg", load.mass_kg},
              {"length_m", load.length_m},
              {"inertia_kg_m2", load.inertia_kg_m2}};
    case LoadKind::kLinearAxis:
      return {{"type", "linear_axis"}, {"mass_kg", load.inertia_kg_m2}};
    default:
      return {{"type", "dynamometer"}};
  }
}

const char* drive_name(DriveKind drive) {
  switch (drive) {
    case DriveKind::kDuty:
      return "duty";
    case DriveKind::kWindingVoltage:
      return "winding_voltage";
    case DriveKind::kCommandedTorque:
      return "commanded_torque";
    default:
      return "current";
  }
}

const char* unit_of(Equation equation, bool is_linear) {
  if (equation == Equation::kVelocity) return is_linear ? "m/s" : "rad/s";
  if (equation == Equation::kTwist) return "rad";
  if (equation == Equation::kBus) return "V";
  return is_linear ? "N" : "Nm";
}

Equation shown_in(const Situation& situation) {
  if (!situation.odd_kind.empty()) return equation_of_outside(situation.odd_kind);
  return situation.hidden.empty() ? Equation::kTorque : equation_of(situation.hidden.front().name);
}

/// Encoders of odd seeds are logged in counts.
bool is_in_counts(const Situation& situation, std::size_t channel) {
  return situation.seed % 3 == 1 && (channel == kOutputPosition || channel == kMotorPosition);
}

void write_row(const Bench& bench, std::size_t run, std::size_t row, std::string& text) {
  const Situation& s = bench.situation;
  const RunLog& log = bench.log.runs[run];
  text += "r" + std::to_string(run) + "," + nine_digits(log.stamp_s[row]);
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (!s.chain.sensors[c].is_logged) continue;
    const double value = log.measured[row][c];
    text += ',';
    text += is_in_counts(s, c) ? std::to_string(std::llround(value / s.chain.sensors[c].resolution))
                               : nine_digits(value);
  }
  text += '\n';
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace

json actuator_document(const Situation& situation) {
  const Plant& p = situation.plant;
  const json motor{{"torque_constant_Nm_A", p.torque_constant_Nm_A},
                   {"torque_constant_convention", "dc"},
                   {"resistance_ohm", p.resistance_ohm},
                   {"resistance_convention", "dc"},
                   {"rotor_inertia_kg_m2", p.rotor_inertia_kg_m2},
                   {"winding_temperature_K", kReference_K}};
  return nine_digit_numbers(
      {{"kind", "actuator"},
       {"version", 1},
       {"name", "sampled " + situation.kind + " " + std::to_string(situation.seed)},
       {"motor", motor},
       {"drive", {{"bus_voltage_V", p.bus_V}, {"peak_current_A", p.peak_current_A}}},
       {"gearbox",
        {{"ratio", p.ratio},
         {"forward_efficiency", p.forward_efficiency},
         {"backward_efficiency", p.backward_efficiency}}},
       {"effects", effects_of(situation.declared, true)}});
}

json rig_document(const Situation& situation) {
  json columns{{"run", "run"}, {"t_s", "time_s"}};
  for (std::size_t c = 0; c < kChannels; ++c) {
    const Sensor& sensor = situation.chain.sensors[c];
    if (!sensor.is_logged) continue;
    const std::string quantity = quantity_name(situation.plant, c);
    columns[quantity] = quantity;
    if (is_in_counts(situation, c)) {
      columns[quantity] = {{"quantity", quantity}, {"scale", sensor.resolution}};
    }
  }
  json rig{{"kind", "rig"},
           {"version", 1},
           {"name", "sampled bench"},
           {"columns", columns},
           {"load", load_of(situation.plant.load)},
           {"uncertain", situation.uncertain}};
  if (situation.seed % 5 == 0) {
    rig["holdout_runs"] = {"r" + std::to_string(situation.runs.size() - 1)};
  }
  shorten(rig);
  return rig;
}

json truth_document(const Bench& bench) {
  const Situation& s = bench.situation;
  const Equation equation = shown_in(s);
  const bool linear = s.plant.load.kind == LoadKind::kLinearAxis;
  const double noise = noise_rms(s, bench.faultless, equation);
  json truth{
      {"class", s.kind},
      {"seed", s.seed},
      {"generator", "sampled"},
      {"rig", load_of(s.plant.load).at("type")},
      {"drive", drive_name(s.plant.drive)},
      {"effects", effects_of(s.hidden, false)},
      {"size_floors", bench.size_floors},
      {"accept", s.accept},
      {"noise_rms", {{"unit", unit_of(equation, linear)}, {"value", noise}, {"band_hz", kBand_hz}}},
      {"note", s.note}};
  if (!s.odd_kind.empty()) {
    truth["outside"] = {{"kind", s.odd_kind}, {"coordinates", s.odd_coordinates}};
  }
  shorten(truth);
  return truth;
}

std::string log_csv(const Bench& bench) {
  const Situation& s = bench.situation;
  std::string text = "run,t_s";
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (s.chain.sensors[c].is_logged) text += "," + quantity_name(s.plant, c);
  }
  text += '\n';
  Draw lost(s.seed + 99);
  for (std::size_t run = 0; run < bench.log.runs.size(); ++run) {
    int in_a_row = 0;  // so few that no gap exceeds a few periods
    for (std::size_t row = 0; row < bench.log.runs[run].truth.size(); ++row) {
      const bool is_lost = lost.chance(s.chain.missing_share) && in_a_row < 2;
      in_a_row = is_lost ? in_a_row + 1 : 0;
      if (!is_lost) write_row(bench, run, row, text);
    }
  }
  return text;
}

void write_bench(const Bench& bench, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_file(folder / "log.csv", log_csv(bench));
  write_file(folder / "rig.json", rig_document(bench.situation).dump(1) + "\n");
  write_file(folder / "actuator.json", actuator_document(bench.situation).dump(1) + "\n");
  write_file(folder / "truth.json", truth_document(bench).dump(1) + "\n");
}

}  // namespace torquewright::oracles::sampled
