// SPDX-License-Identifier: Apache-2.0
// identification_memory TORQUEWRIGHT FOLDER ROWS [RUNS] [RATE_HZ]: writes a log of so many rows in
// so many runs (1 at 1000 Hz), has it identified, and prints CPU seconds and the greatest resident
// memory. The drive of the log has Coulomb and load-dependent friction that its document lacks; the
// sensor is that of a dynamometer. The log is deleted again.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "bench/process.hpp"

namespace {

using torquewright::bench::ProcessOutcome;
using torquewright::bench::run_process;

constexpr double kTimeout_s = 3600.0;
constexpr double kRatio = 9.3, kTorqueConstant_Nm_A = 0.0865;
constexpr double kCoulomb_Nm = 0.6, kLoadFriction = 0.06, kNoise_Nm = 0.05;

struct Size {
  long rows = 1000000, runs = 1;
  double rate_Hz = 1000.0;
};

void write(const std::filesystem::path& file, const char* text) {
  std::FILE* const out = std::fopen(file.c_str(), "w");
  if (out == nullptr) std::exit(2);
  std::fputs(text, out);
  std::fclose(out);
}

void write_documents(const std::filesystem::path& folder) {
  write(folder / "rig.json", R"({"kind": "rig", "version": 1, "name": "long log",
 "columns": {"run": "run", "t_s": "time_s", "q_rad": "output_position_rad", "i_A": "motor_current_A",
   "tau_Nm": "output_torque_Nm", "winding_K": "winding_temperature_K"},
 "load": {"type": "dynamometer"}})");
  write(folder / "actuator.json", R"({"kind": "actuator", "version": 1, "name": "long log",
 "motor": {"torque_constant_Nm_A": 0.0865, "torque_constant_convention": "dc",
   "resistance_ohm": 0.237, "resistance_convention": "dc",
   "pole_pairs": 21, "rotor_inertia_kg_m2": 0.000173, "winding_temperature_K": 298.15},
 "drive": {"bus_voltage_V": 21, "peak_current_A": 28},
 "gearbox": {"ratio": 9.3, "forward_efficiency": 1, "backward_efficiency": 1}})");
}

/// Sums of sines that never repeat within the log.
void write_log(const std::filesystem::path& file, const Size& size) {
  std::FILE* const out = std::fopen(file.c_str(), "w");
  if (out == nullptr) std::exit(2);
  std::fputs("t_s,q_rad,i_A,tau_Nm,winding_K,run\n", out);
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, kNoise_Nm);
  const double pi = std::acos(-1.0);
  for (long k = 0; k < size.rows; ++k) {
    const long run = k * size.runs / size.rows;
    const double t_s = static_cast<double>(k) / size.rate_Hz;
    const double angle_rad = 2.0 * std::sin(1.1 * t_s) + 0.7 * std::sin(pi * t_s + 1.0);
    const double speed_rad_s = 2.2 * std::cos(1.1 * t_s) + 0.7 * pi * std::cos(pi * t_s + 1.0);
    const double current_A = 7.0 * std::sin(1.7 * t_s) + 3.0 * std::sin(0.31 * pi * t_s);
    const double motor_Nm = kRatio * kTorqueConstant_Nm_A * current_A;
    const double direction = std::tanh(speed_rad_s / 1e-3);
    const double acceleration_rad_s2 =
        -2.2 * 1.1 * std::sin(1.1 * t_s) - 0.7 * pi * pi * std::sin(pi * t_s + 1.0);
    const double torque_Nm = motor_Nm - 0.000173 * kRatio * kRatio * acceleration_rad_s2 -
                             direction * (kCoulomb_Nm + kLoadFriction * std::abs(motor_Nm)) +
                             noise(random);
    fmt::print(out, "{:.4f},{:.7f},{:.5f},{:.5f},{:.2f},r{}\n", t_s, angle_rad, current_A,
               torque_Nm, 310.0 + 8.0 * std::sin(1e-3 * t_s), run);
  }
  std::fclose(out);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) return 2;
  Size size;
  size.rows = std::atol(arguments[3]);
  if (count > 4) size.runs = std::atol(arguments[4]);
  if (count > 5) size.rate_Hz = std::atof(arguments[5]);
  const std::filesystem::path folder = arguments[2];
  write_documents(folder);
  write_log(folder / "log.csv", size);
  const ProcessOutcome outcome = run_process(
      {arguments[1], "identify", (folder / "log.csv").string(), "--rig",
       (folder / "rig.json").string(), "--actuator", (folder / "actuator.json").string()},
      kTimeout_s);
  std::filesystem::remove(folder / "log.csv");
  fmt::print("{} rows, {} runs, {} Hz: exit {}, {:.2f} s of CPU, {:.0f} MB\n", size.rows, size.runs,
             size.rate_Hz, outcome.exit_code, outcome.cpu_seconds, outcome.peak_MB);
  fmt::print("{}", outcome.output);
  return 0;
}
