// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "actuator/catalogue/drive_set.hpp"
#include "actuator/catalogue/shortlist.hpp"
#include "io/faults/refusal.hpp"
#include "src/commands/actuator/actuator_commands.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/options/needs.hpp"
#include "src/options/output_files.hpp"
#include "src/report/actuator/shortlist.hpp"
#include "src/report/actuator/shortlist_json.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct FindOptions {
  std::vector<std::string> needs;
  std::optional<double> lever_m;
  std::optional<double> continuous_Nm;
  std::optional<double> mass_below_kg;
  std::string ratios;
  std::string folder;
  std::string output_file;
  bool json = false;
};

actuator::Wanted wanted_of(const FindOptions& options) {
  actuator::Wanted wanted;
  require_use_of_lever(options.lever_m, options.needs);
  for (const std::string& text : options.needs) {
    wanted.needs.push_back(read_need("--need", text, options.lever_m));
    if (wanted.needs.back().torque_Nm == 0.0) {
      io::refuse("--need", "\"" + text + "\" asks for no torque: every drive has it");
    }
  }
  wanted.continuous_Nm = options.continuous_Nm;
  wanted.mass_below_kg = options.mass_below_kg;
  if (!options.ratios.empty()) {
    const auto [least, greatest] = read_ratio_range("--ratio", options.ratios);
    wanted.ratios = actuator::Wanted::Ratios{least, greatest};
  }
  return wanted;
}

/// Those that fit come first, then those of which too little is known; in each part by the margin.
std::vector<report::RankedDrive> ranked(const actuator::DriveSet& set,
                                        const actuator::Wanted& wanted) {
  std::vector<report::RankedDrive> drives;
  for (const actuator::NamedActuator& drive : set.drives) {
    drives.push_back({&drive, actuator::suitability(drive.actuator, wanted)});
  }
  const auto is_better = [](const report::RankedDrive& one, const report::RankedDrive& other) {
    if (one.suitability.fits != other.suitability.fits) return one.suitability.fits;
    if (one.suitability.is_unknown != other.suitability.is_unknown) {
      return one.suitability.is_unknown;
    }
    return one.suitability.margin_share > other.suitability.margin_share;
  };
  std::stable_sort(drives.begin(), drives.end(), is_better);
  return drives;
}

ExitCode run_find(const FindOptions& options) {
  const actuator::Wanted wanted = wanted_of(options);
  const actuator::DriveSet set =
      options.folder.empty() ? actuator::catalogue() : actuator::drives_in(options.folder);
  check_written(named({options.output_file}), {});
  const std::vector<report::RankedDrive> drives = ranked(set, wanted);
  deliver_report({result_text(report::shortlist_json(wanted, drives, set.left_out), set.documents),
                  report::shortlist_text(drives, set.left_out)},
                 options.output_file, options.json);
  const actuator::Suitability& best = drives.front().suitability;
  if (best.fits) return ExitCode::kPasses;
  return best.is_unknown ? ExitCode::kUndecided : ExitCode::kFails;
}

}  // namespace

void add_find_command(command_line::Command& actuator) {
  auto options = std::make_shared<FindOptions>();
  command_line::Command command =
      actuator.add_command("find", "Find the drives that have a torque at a speed");
  command
      .add_option(
          "--need", options->needs,
          "TORQUE@SPEED at the joint in Nm and rad/s, or with units, 100@95rpm, at the peak; "
          "several with commas")
      .separated_by_commas()
      .required();
  add_lever(command, options->lever_m);
  command.add_option("--continuous", options->continuous_Nm, "Torque that must last at rest, in Nm")
      .otherwise("none is asked for")
      .between(1e-3, 1e6);
  command
      .add_option("--mass-below", options->mass_below_kg, "Mass of motor, drive and gearbox, in kg")
      .otherwise("none is too heavy")
      .between(1e-4, 1e4);
  command
      .add_option("--ratio", options->ratios,
                  "LOW:HIGH, gear ratios to take the best of for each drive")
      .otherwise("the drive's own");
  command.add_option("--in", options->folder, "Folder of actuators to choose among")
      .otherwise("the catalogue of specs/catalogue, compiled in");
  command.add_option("-o,--output", options->output_file, "Write the list as JSON to this file")
      .names_a_file();
  command.add_flag("--json", options->json, "Print the same as JSON");
  command.example("torquewright actuator find --need 60@10 --continuous 20 --mass-below 2");
  command.works([options] { return run_find(*options); });
}

}  // namespace torquewright::cli
