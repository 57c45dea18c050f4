// SPDX-License-Identifier: Apache-2.0
// Fits four friction models to the servo's training runs by simulation and prints their errors on
// the runs that were held out. docs/derivations/simulation.md section 6 holds what it prints.
#include <cstdio>
#include <cstring>

#include "tests/real_data/bam_servos/servo.hpp"

using namespace torquewright::identification;

int main(int argc, char** argv) {
  const bool closed_loop = argc > 1 && std::strcmp(argv[1], "goal") == 0;
  const std::size_t starts = argc > 2 ? static_cast<std::size_t>(std::atoi(argv[2])) : 2;
  const std::size_t evaluations = argc > 3 ? static_cast<std::size_t>(std::atoi(argv[3])) : 200;
  const auto log = read_servo(closed_loop);
  if (!log) return 1;
  PositionScoreOptions options;
  options.longest_step_s = 3e-3;
  const PositionScore nominal = position_score(log->rig, {&log->nominal}, log->held_out, options);
  std::printf("published constants: held out mean %.4f rms %.4f rad\n", nominal.mean_absolute_rad,
              nominal.rms_rad);
  const char* names[] = {"viscous", "coulomb", "stribeck", "load"};
  for (int model = 0; model < 4; ++model) {
    if (argc > 4 && std::strchr(argv[4], names[model][0]) == nullptr) continue;
    const FittedServo fitted = fit_servo(*log, static_cast<ServoModel>(model), starts, evaluations);
    std::printf(
        "%-9s train mean %.4f; held out mean %.4f rms %.4f rad; spread %.4f, %zu evaluations, %s:",
        names[model], fitted.train.mean_absolute_rad, fitted.held_out.mean_absolute_rad,
        fitted.held_out.rms_rad, fitted.fit.value_spread, fitted.fit.evaluations,
        std::string(torquewright::optimization::name_of(fitted.fit.stop)).c_str());
    for (const double value : fitted.fit.point) std::printf(" %.5g", value);
    for (const RunScore& run : fitted.held_out.runs) {
      std::printf(" [%s %.4f]", run.name.c_str(), run.mean_absolute_rad);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  return 0;
}
