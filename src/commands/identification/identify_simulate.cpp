// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>
#include <vector>

#include "actuator/motor/actuator_spec.hpp"
#include "identification/rig/rig.hpp"
#include "identification/simulated/simulated_log.hpp"
#include "io/documents/document.hpp"
#include "io/files/atomic_file.hpp"
#include "src/commands/identification/identify_commands.hpp"
#include "src/options/noise_option.hpp"
#include "src/options/output_files.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct SimulateOptions {
  std::string actuator, rig, excitation, log;
  std::vector<std::string> noise;
  std::uint64_t seed = 1;
};

struct SimulateInputs {
  identification::SimulatedLogOptions options;
  identification::Rig rig;
  actuator::ReadActuator truth;
  std::vector<identification::ExcitationRun> runs;
};

SimulateInputs read(const SimulateOptions& options) {
  SimulateInputs inputs;
  inputs.options.seed = options.seed;
  inputs.rig = identification::read_rig(io::read_document(options.rig, "rig"));
  inputs.options.noise = read_noise(options.noise, inputs.rig);
  inputs.truth = actuator::read_wound_actuator(options.actuator);
  inputs.runs =
      identification::read_excitation(options.excitation, inputs.rig, inputs.truth.actuator);
  identification::require_few_steps(options.excitation, inputs.runs, inputs.options.simulation);
  check_written(named({options.log}), {});
  return inputs;
}

ExitCode run_simulate(const SimulateOptions& options) {
  const SimulateInputs inputs = read(options);
  const std::string log =
      identification::simulated_log(inputs.rig, inputs.truth.actuator, inputs.runs, inputs.options);
  deliver_result(log, options.log);
  return ExitCode::kPasses;
}

}  // namespace

void add_identify_simulate(command_line::Command& identify) {
  auto options = std::make_shared<SimulateOptions>();
  command_line::Command command =
      identify.add_command("simulate", "Simulate a log of an actuator that is taken as true");
  command
      .add_option("actuator", options->actuator,
                  "Document of kind actuator, which is taken as true")
      .required();
  command
      .add_option("--rig", options->rig,
                  "Document of kind rig, which says what the load and the columns are")
      .required();
  command
      .add_option(
          "--excitation", options->excitation,
          "CSV of what is played: time_s, what drives (motor_current_A, commanded_torque_Nm, "
          "winding_voltage_V or duty), on a dynamometer output_velocity_rad_s")
      .required();
  command
      .add_option(
          "--noise", options->noise,
          "QUANTITY=SIGMA: add white noise of that standard deviation, in the column's unit")
      .otherwise("none");
  command.add_option("--seed", options->seed, "Seed of the noise").needs("--noise");
  command.add_option("-o,--output", options->log, "Write the log to this file")
      .otherwise("-, standard output")
      .names_a_file();
  command.example(
      "torquewright identify simulate specs/actuator/d151_knee.json "
      "--rig specs/rig/knee_sweep.json --excitation specs/excitation/knee_sweep.csv "
      "--noise output_torque_Nm=0.2");
  command.works([options] { return run_simulate(*options); });
}

}  // namespace torquewright::cli
