// SPDX-License-Identifier: Apache-2.0
#include "src/commands/identify_commands.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "actuator/actuator_spec.hpp"
#include "identification/rig.hpp"
#include "identification/simulated_log.hpp"
#include "io/atomic_file.hpp"
#include "io/document.hpp"
#include "io/spec_error.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct SimulateOptions {
  std::string actuator, rig, excitation, log;
  std::vector<std::string> noise;
  std::uint64_t seed = 1;
};

/// QUANTITY=SIGMA.
void add_noise(const std::string& text, identification::SimulatedLogOptions& options) {
  const std::size_t equals = text.find('=');
  const auto refuse = [&](const std::string& why) {
    throw io::SpecError({{"command line", "--noise " + text, why}});
  };
  if (equals == std::string::npos) refuse("QUANTITY=SIGMA is expected");
  const auto quantity = identification::find_quantity(text.substr(0, equals));
  if (!quantity) refuse("no such quantity; docs/logs.md lists them");
  char* end = nullptr;
  const double sigma = std::strtod(text.c_str() + equals + 1, &end);
  if (end == text.c_str() + equals + 1 || *end != '\0' || !std::isfinite(sigma) || sigma < 0.0) {
    refuse("SIGMA is a standard deviation: a number, 0 or more, in the quantity's unit");
  }
  options.noise[*quantity] = sigma;
}

ExitCode run_simulate(const SimulateOptions& options) {
  identification::SimulatedLogOptions log_options;
  log_options.seed = options.seed;
  for (const std::string& noise : options.noise) add_noise(noise, log_options);
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
