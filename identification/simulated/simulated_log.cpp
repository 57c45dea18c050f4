// SPDX-License-Identifier: Apache-2.0
#include "identification/simulated/simulated_log.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <random>

#include "identification/log/run_loads.hpp"
#include "identification/simulated/rig_plant.hpp"
#include "io/faults/spec_error.hpp"
#include "io/files/csv.hpp"

namespace torquewright::identification {
namespace {

struct Source {
  Quantity quantity;
  simulation::DriveKind kind;
};
constexpr Source kSources[] = {{Quantity::kMotorCurrent, simulation::DriveKind::kCurrent},
                               {Quantity::kCommandedTorque, simulation::DriveKind::kTorque},
                               {Quantity::kWindingVoltage, simulation::DriveKind::kVoltage},
                               {Quantity::kDuty, simulation::DriveKind::kDuty}};

constexpr double kRoundOff = 1e-9;
/// About a minute of work.
constexpr double kMostSteps = 4e7;

[[noreturn]] void refuse(const std::string& file, const std::string& path, std::string what) {
  throw io::SpecError({{file, path, std::move(what)}});
}

/// The columns of an excitation that are of use; refuses what has no meaning there.
struct Header {
  std::size_t time = 0, drive = 0;
  simulation::DriveKind kind = simulation::DriveKind::kCurrent;
  std::optional<std::size_t> run, speed, position;
};

/// A column that nothing takes is a slip: a misspelt name, or another kind of load.
void require_used(const io::CsvReader& csv, const Header& header, const Rig& rig) {
  for (std::size_t i = 0; i < csv.header().size(); ++i) {
    if (i == header.time || i == header.drive || i == header.run || i == header.speed ||
        i == header.position) {
      continue;
    }
    const std::string& name = csv.header()[i];
    const bool is_motion = name == name_of(Quantity::kOutputVelocity);
    refuse(csv.file(), "",
           fmt::format(
               "the column \"{}\" would not be played{}; an excitation has time_s, run, what "
               "drives, output_position_rad (where it starts) and, on a dynamometer, "
               "output_velocity_rad_s",
               name,
               is_motion
                   ? fmt::format(": a load of type \"{}\" moves by itself", name_of(rig.load.type))
                   : ""));
  }
}

Header header_of(const io::CsvReader& csv, const Rig& rig) {
  Header header;
  const auto time = csv.find("time_s");
  if (!time) refuse(csv.file(), "", "an excitation needs a column time_s");
  header.time = *time;
  header.run = csv.find("run");
  header.position = csv.find("output_position_rad");
  bool has_drive = false;
  for (const Source& source : kSources) {
    const auto column = csv.find(name_of(source.quantity));
    if (!column) continue;
    if (has_drive) refuse(csv.file(), "", "an excitation has one column that drives, not several");
    header.drive = *column;
    header.kind = source.kind;
    has_drive = true;
  }
  if (!has_drive) {
    refuse(
        csv.file(), "",
        "nothing drives: a column motor_current_A, commanded_torque_Nm, winding_voltage_V or duty");
  }
  if (rig.load.type == LoadType::kDynamometer) {
    header.speed = csv.find("output_velocity_rad_s");
    if (!header.speed) {
      refuse(csv.file(), "", "a dynamometer imposes the motion: a column output_velocity_rad_s");
    }
  }
  require_used(csv, header, rig);
  return header;
}

/// In the unit of what drives; infinite where the drive's limits say nothing.
double greatest_drive(simulation::DriveKind kind, const actuator::Actuator& actuator) {
  switch (kind) {
    case simulation::DriveKind::kCurrent:
      return actuator.drive.peak_current_A;
    case simulation::DriveKind::kTorque:
      return actuator.drive.peak_current_A *
             std::abs(actuator.transmission.ratio * actuator.motor.torque_constant_Nm_A);
    case simulation::DriveKind::kDuty:
      return 1.0;
    case simulation::DriveKind::kVoltage:
    case simulation::DriveKind::kPosition:
    case simulation::DriveKind::kPositionLaw:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

double drive_value(const io::CsvReader& csv, const Header& header,
                   const actuator::Actuator& actuator) {
  const double value = csv.number(header.drive);
  const double greatest = greatest_drive(header.kind, actuator);
  if (std::abs(value) <= (1.0 + kRoundOff) * greatest) return value;
  if (header.kind == simulation::DriveKind::kDuty) {
    csv.refuse(header.drive,
               fmt::format("a duty of {:g} is not possible; it must be from -1 to 1", value));
  }
  const char* unit = header.kind == simulation::DriveKind::kCurrent ? "A" : "Nm";
  csv.refuse(
      header.drive,
      fmt::format("{0:g} {1} is beyond what the drive can do; it must be from -{2:g} to {2:g} "
                  "{1}, by the actuator's peak_current_A of {3:g} A",
                  value, unit, greatest, actuator.drive.peak_current_A));
}

ExcitationRun empty_run(const Header& header, std::string name) {
  ExcitationRun run;
  run.name = std::move(name);
  run.excitation.joints.resize(1);
  run.excitation.joints[0].kind = header.kind;
  return run;
}

/// One run's rows. Noise is drawn column by column, so that a column more changes no other's.
void append_run(std::string& text, const Rig& rig, const actuator::Actuator& truth,
                const ExcitationRun& run, std::size_t number, const SimulatedLogOptions& options) {
  const simulation::SimulatedRun simulated = simulation::simulate(
      *plant_of(load_of(rig, run.name)), {&truth}, run.excitation, {run.start}, options.simulation);
  if (!simulated.is_finite) {
    refuse(rig.file, "/load", fmt::format("run {} diverges under this excitation", run.name));
  }
  std::vector<std::vector<double>> columns;
  for (const ColumnUse& use : rig.columns) {
    if (use.quantity == Quantity::kRun) {
      columns.emplace_back();
      continue;
    }
    std::vector<double> values =
        simulated_quantity(use.quantity, truth, run.excitation, simulated.joints[0]);
    if (values.empty()) {
      refuse(rig.file, "/columns/" + use.column,
             fmt::format("a simulation has no {}", name_of(use.quantity)));
    }
    const auto sigma = options.noise.find(use.quantity);
    std::seed_seq seed{options.seed, static_cast<std::uint64_t>(use.quantity),
                       static_cast<std::uint64_t>(number)};
    std::mt19937_64 bits(seed);
    for (double& value : values) {
      if (sigma != options.noise.end()) {
        // Box and Muller: the library's own normal distribution differs between libraries.
        const double first = (static_cast<double>(bits() >> 11) + 0.5) * 0x1p-53;
        const double second = (static_cast<double>(bits() >> 11) + 0.5) * 0x1p-53;
        value += sigma->second * std::sqrt(-2.0 * std::log(first)) * std::cos(2.0 * M_PI * second);
      }
      value = (value - use.offset) / use.scale;
    }
    columns.push_back(std::move(values));
  }
  for (std::size_t i = 0; i < run.excitation.time_s.size(); ++i) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0) text += ',';
      text += columns[c].empty() ? run.name : fmt::format("{}", columns[c][i]);
    }
    text += '\n';
  }
}

}  // namespace

std::vector<double> simulated_quantity(Quantity quantity, const actuator::Actuator& truth,
                                       const simulation::Excitation& excitation,
                                       const simulation::JointTrace& trace) {
  const std::size_t count = excitation.time_s.size();
  const double per_ampere_Nm = truth.transmission.ratio * truth.motor.torque_constant_Nm_A;
  std::vector<double> values(count);
  switch (quantity) {
    case Quantity::kTime:
      return excitation.time_s;
    case Quantity::kOutputPosition:
    case Quantity::kLinearPosition:
      return trace.position_rad;
    case Quantity::kOutputVelocity:
    case Quantity::kLinearVelocity:
      return trace.speed_rad_s;
    case Quantity::kMotorPosition:
      return trace.motor_position_rad;
    case Quantity::kMotorVelocity:
      return trace.motor_speed_rad_s;
    case Quantity::kMotorCurrent:
      return trace.current_A;
    case Quantity::kWindingVoltage:
      return trace.voltage_V;
    case Quantity::kBusVoltage:
      return trace.bus_V;
    case Quantity::kOutputTorque:
    case Quantity::kLinearForce:
      return trace.torque_Nm;
    case Quantity::kWindingTemperature:
      return trace.winding_K;
    case Quantity::kCaseTemperature:
      return trace.case_K;
    case Quantity::kReportedTorque:
    case Quantity::kCommandedTorque:
      for (std::size_t i = 0; i < count; ++i) values[i] = per_ampere_Nm * trace.current_A[i];
      return values;
    case Quantity::kDuty:
      for (std::size_t i = 0; i < count; ++i) values[i] = trace.voltage_V[i] / trace.bus_V[i];
      return values;
    case Quantity::kEnabled:
      return std::vector<double>(count, 1.0);
    case Quantity::kRun:
    case Quantity::kCommandedPosition:
    case Quantity::kFeedforwardTorque:
      break;
  }
  return {};
}

std::vector<ExcitationRun> read_excitation(const std::filesystem::path& file, const Rig& rig,
                                           const actuator::Actuator& actuator) {
  io::CsvReader csv(file);
  const Header header = header_of(csv, rig);
  std::vector<ExcitationRun> runs;
  while (csv.next()) {
    const std::string name = header.run ? std::string(csv.text(*header.run)) : "";
    if (runs.empty() || runs.back().name != name) {
      runs.push_back(empty_run(header, name));
      if (header.position) runs.back().start.position_rad = csv.number(*header.position);
    }
    simulation::Excitation& excitation = runs.back().excitation;
    const double time_s = csv.number(header.time);
    if (!excitation.time_s.empty() && time_s <= excitation.time_s.back()) {
      csv.refuse(header.time, "time does not ascend");
    }
    excitation.time_s.push_back(time_s);
    excitation.joints[0].value.push_back(drive_value(csv, header, actuator));
    if (header.speed) excitation.joints[0].speed_rad_s.push_back(csv.number(*header.speed));
  }
  if (runs.empty()) refuse(csv.file(), "", "no rows");
  return runs;
}

void require_few_steps(const std::filesystem::path& file, const std::vector<ExcitationRun>& runs,
                       const simulation::SimulationOptions& options) {
  double duration_s = 0.0;
  for (const ExcitationRun& run : runs) {
    duration_s += run.excitation.time_s.back() - run.excitation.time_s.front();
  }
  const double steps = duration_s / options.longest_step_s;
  if (steps <= kMostSteps) return;
  refuse(file.string(), "",
         fmt::format("its runs last {:.6g} s in all, {:.3g} steps of {:g} s; at most {:.3g} steps "
                     "are simulated, {:g} s: shorten the runs, or play them in several excitations",
                     duration_s, steps, options.longest_step_s, kMostSteps,
                     kMostSteps * options.longest_step_s));
}

std::string simulated_log(const Rig& rig, const actuator::Actuator& truth,
                          const std::vector<ExcitationRun>& runs,
                          const SimulatedLogOptions& options) {
  if (rig.joints.size() != 1) refuse(rig.file, "/load", "only rigs of one joint are simulated");
  std::string text;
  for (std::size_t c = 0; c < rig.columns.size(); ++c) {
    text += (c > 0 ? "," : "") + rig.columns[c].column;
  }
  text += '\n';
  std::vector<ExcitationRun> named = runs;
  std::vector<std::string> names;
  for (ExcitationRun& run : named) {
    if (run.name.empty()) run.name = std::to_string(names.size());
    names.push_back(run.name);
  }
  check_run_loads(names, rig);
  for (std::size_t number = 0; number < named.size(); ++number) {
    append_run(text, rig, truth, named[number], number, options);
  }
  return text;
}

}  // namespace torquewright::identification
