// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <vector>

#include "actuator/motor/actuator_spec.hpp"
#include "identification/rig.hpp"
#include "identification/simulated_log.hpp"
#include "io/atomic_file.hpp"
#include "io/document.hpp"
#include "src/commands/identify_commands.hpp"
#include "src/options/noise_option.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct SimulateOptions {
  std::string actuator, rig, excitation, log;
  std::vector<std::string> noise;
  std::uint64_t seed = 1;
};

ExitCode run_simulate(const SimulateOptions& options) {
  identification::SimulatedLogOptions log_options;
  log_options.seed = options.seed;
  log_options.noise = read_noise(options.noise);
  const identification::Rig rig = identification::read_rig(io::read_document(options.rig, "rig"));
  const actuator::ReadActuator truth = actuator::read_actuator(options.actuator);
  const auto runs = identification::read_excitation(options.excitation, rig);
  const std::string log = identification::simulated_log(rig, truth.actuator, runs, log_options);
  if (options.log.empty()) {
    print_result(log);
  } else {
    io::write_whole_file(options.log, log);
  }
  return ExitCode::kPasses;
}

}  // namespace

void add_identify_simulate(CLI::App& identify, ExitCode& result) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = identify.add_subcommand("simulate", "A log of an actuator taken as true");
  command->add_option("actuator", options->actuator, "Document of kind actuator: the truth")
      ->required();
  command->add_option("--rig", options->rig, "Document of kind rig: load and columns")->required();
  command
      ->add_option("--excitation", options->excitation,
                   "CSV: time_s, what drives (motor_current_A, commanded_torque_Nm, "
                   "winding_voltage_V or duty), on a dynamometer output_velocity_rad_s")
      ->required();
  command->add_option("--noise", options->noise,
                      "QUANTITY=SIGMA: white noise on a column, repeatable");
  command->add_option("--seed", options->seed, "Of the noise");
  command->add_option("-o,--output", options->log, "The log; else stdout");
  command->footer(
      "Example:\n  torquewright identify simulate specs/actuator/d151_knee.json "
      "--rig specs/rig/knee_sweep.json --excitation specs/excitation/knee_sweep.csv "
      "--noise output_torque_Nm=0.2");
  command->callback([options, &result] { result = run_simulate(*options); });
}

}  // namespace torquewright::cli
