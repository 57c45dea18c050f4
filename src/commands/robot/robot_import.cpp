// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "io/documents/document.hpp"
#include "io/faults/json_text.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/given_once.hpp"
#include "io/files/new_folder.hpp"
#include "io/text/one_line.hpp"
#include "robot/draft/limit_drives.hpp"
#include "robot/draft/own_lines.hpp"
#include "robot/loops/crank_rotors.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/model/robot_json.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/urdf/urdf_reader.hpp"
#include "src/commands/robot/robot_commands.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/loudness.hpp"
#include "src/options/named_feet.hpp"
#include "src/options/output_files.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

struct ImportOptions {
  std::string file;
  std::string format;
  std::string output_file;
  hopper::ImportFileOptions reading;
  std::optional<double> link_error;    ///< Empty: the reader's own.
  std::vector<std::string> actuators;  ///< NAME=FILE.
  std::string drive_folder;            ///< Of the documents that limits are made into.
  std::vector<std::string> feet;       ///< NAME or NAME=SOLE.
};

/// URDF holds neither several robots, nor couplings, nor loops.
void refuse_options_of_mjcf(const ImportOptions& options) {
  const hopper::ImportFileOptions& reading = options.reading;
  for (const auto& [option, is_given] : {std::pair{"--body", !reading.body.empty()},
                                         {"--drop-base-armature", reading.drops_base_armature},
                                         {"--free-couplings", reading.frees_couplings},
                                         {"--link-error", options.link_error.has_value()},
                                         {"--open-loop", !reading.opened_loops.empty()},
                                         {"--massless-links", reading.drops_link_mass}}) {
    if (is_given)
      io::refuse(option, "is for MJCF files: a URDF file holds nothing that it concerns");
  }
}

/// MJCF says of each range whether it holds.
void refuse_options_of_urdf(const ImportOptions& options) {
  if (!options.reading.welds_locked) return;
  io::refuse("--weld-locked", "is for URDF files: an MJCF file says which of its ranges hold");
}

/// Of a file, in small letters.
std::string small_ending_of(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

/// Formats of robots that are not read, and what makes one that is.
void refuse_other_formats(const ImportOptions& options) {
  if (!options.format.empty()) return;
  const std::string ending = small_ending_of(options.file);
  const auto refuse = [&](const char* why) { io::refuse(options.file, why); };
  if (ending == ".xacro")
    refuse("holds macros, which are not expanded here: `xacro FILE > FILE.urdf`");
  if (ending == ".sdf" || ending == ".world") {
    refuse("SDF is written here and not read: import the URDF or MJCF that it was made of");
  }
  if (ending == ".usd" || ending == ".usda" || ending == ".usdc" || ending == ".usdz") {
    refuse("USD is not read: import the URDF or MJCF that it was made of");
  }
}

hopper::Imported read(const ImportOptions& options) {
  refuse_other_formats(options);
  const bool is_urdf =
      options.format.empty() ? small_ending_of(options.file) == ".urdf" : options.format == "urdf";
  is_urdf ? refuse_options_of_mjcf(options) : refuse_options_of_urdf(options);
  hopper::ImportFileOptions reading = options.reading;
  reading.feet = named_feet(options.feet);
  reading.greatest_link_error = options.link_error.value_or(reading.greatest_link_error);
  hopper::Imported imported =
      is_urdf ? hopper::read_urdf(options.file, reading) : hopper::read_mjcf(options.file, reading);
  check_written(named({options.output_file}), {});
  return imported;
}

/// Where the document will be; on standard output, where it is asked for.
std::filesystem::path place_of(const ImportOptions& options) {
  const bool is_file = !options.output_file.empty() && !is_standard_output(options.output_file);
  return std::filesystem::absolute(is_file ? options.output_file : "robot.json");
}

/// Documents of the drives of linkages, as the result names them.
void name_actuators(const ImportOptions& options, hopper::Robot& robot) {
  io::require_each_once("--actuator", options.actuators);
  std::map<std::string, std::string> stated;
  for (const std::string& text : options.actuators) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
      io::refuse("--actuator", fmt::format("\"{}\" must be NAME=ACTUATOR, the drive of a linkage "
                                           "and its actuator's file",
                                           text));
    }
    stated[text.substr(0, equals)] = text.substr(equals + 1);
  }
  const auto folder = place_of(options).parent_path();
  for (hopper::Drivetrain& drivetrain : robot.drivetrains) {
    for (const std::string& name : drivetrain.actuator_names) {
      const auto found = stated.find(name);
      if (found == stated.end() && !options.drive_folder.empty()) {
        drivetrain.actuator_files.emplace_back();  // of its limits
        continue;
      }
      if (found == stated.end()) {
        io::refuse("--actuator", fmt::format("the drive {} of a {} is not named; a linkage needs "
                                             "its actuator: --actuator {}=FILE, or --actuators "
                                             "FOLDER for one of the file's limits",
                                             name, drivetrain.mechanism->type(), name));
      }
      const auto file = std::filesystem::absolute(found->second);
      drivetrain.actuator_files.push_back(std::filesystem::proximate(file, folder).string());
      stated.erase(found);
    }
  }
  if (stated.empty()) return;
  io::refuse("--actuator",
             fmt::format("no linkage of the file has a drive \"{}\"", stated.begin()->first));
}

/// A folder of its own among the system's temporary ones, for files that a document names before
/// they are written where they belong.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string made = (std::filesystem::temp_directory_path() / "torquewright_XXXXXX").string();
    if (mkdtemp(made.data()) == nullptr) io::refuse(made, "cannot be made");
    folder_ = made;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// What a file says may still be no robot (inertias that no body has): such a document is refused.
/// Files that it names are beside where it will be.
void check(const ImportOptions& options, const std::string& text, hopper::Imported& imported) {
  const bool has_files = !imported.robot.drivetrains.empty() || !options.drive_folder.empty();
  try {
    const hopper::ReadRobot read = hopper::robot_of(io::check_document(
        as_read(text), "robot", has_files ? place_of(options).string() : options.file, ""));
    for (std::string& sentence : hopper::rotors_that_differ(read.robot)) {
      imported.notes.push_back(std::move(sentence));
    }
  } catch (const io::SpecError& error) {
    throw hopper::at_own_lines(error, imported);
  }
}

hopper::LimitDrives made_drives(const ImportOptions& options, const hopper::Imported& imported) {
  if (options.drive_folder.empty()) return {};
  hopper::LimitDrives made = hopper::limit_drives(imported.robot, imported.loop_drives);
  if (!made.unlimited.empty()) {
    const std::string& name = made.unlimited.front();
    io::refuse("--actuators", fmt::format("the drive {} of a loop states no limit of torque, of "
                                          "which one could be made: --actuator {}=FILE names its "
                                          "actuator",
                                          name, name));
  }
  if (made.drives.empty()) {
    io::refuse("--actuators",
               "no joint of the robot states a limit of torque, of which a drive could be made");
  }
  return made;
}

/// The robot's document; drives that limits are made into are in it.
std::string compute(const ImportOptions& options, const hopper::LimitDrives& made,
                    hopper::Imported& imported) {
  const std::string robot = io::json_text(hopper::robot_json(imported.robot));
  if (made.drives.empty()) {
    check(options, robot, imported);
    return robot;
  }
  const TemporaryFolder beside;
  for (const auto& drive : made.drives) {
    io::write_whole_file(beside.path() / drive.file, drive.document);
  }
  check(options, hopper::with_limit_drives(made, beside.path().string(), robot), imported);
  const std::filesystem::path seen = std::filesystem::proximate(
      std::filesystem::absolute(options.drive_folder), place_of(options).parent_path());
  imported.notes.insert(imported.notes.end(), made.notes.begin(), made.notes.end());
  imported.notes.push_back(fmt::format(
      "{} joints are driven by {} drives that are made of their limits in {}: these hold what the "
      "file says of torque and speed, and neither winding nor heat",
      made.assignments.size() + made.in_loops.size(), made.drives.size(),
      io::name_in_text(options.drive_folder)));
  return hopper::with_limit_drives(made, seen == "." ? "" : seen.generic_string(), robot);
}

std::vector<io::FileContent> files_of(const ImportOptions& options,
                                      const hopper::LimitDrives& made) {
  std::vector<io::FileContent> files;
  for (const auto& drive : made.drives) {
    files.push_back({std::filesystem::absolute(options.drive_folder) / drive.file, drive.document});
  }
  return files;
}

void write(const ImportOptions& options, const hopper::Imported& imported,
           const std::string& document, std::vector<io::FileContent> drives) {
  std::optional<io::NewFolder> folder;
  if (!drives.empty()) folder.emplace(std::filesystem::absolute(options.drive_folder));
  deliver_result(document, options.output_file, std::move(drives));
  std::string notes;
  for (const std::string& note : imported.notes) notes += "note: " + note + "\n";
  if (options.output_file.empty() || is_standard_output(options.output_file)) {
    if (!loudness().is_quiet) std::fputs(notes.c_str(), stderr);
    return;
  }
  const std::size_t bodies = imported.robot.tree.bodies.size();
  print_result(for_window(fmt::format("{}: {} bodies, {} joints\n",
                                      io::name_in_text(options.output_file), bodies, bodies - 1) +
                          notes));
}

ExitCode run_import(const ImportOptions& options) {
  hopper::Imported imported = read(options);
  name_actuators(options, imported.robot);
  const hopper::LimitDrives made = made_drives(options, imported);
  const std::string document = compute(options, made, imported);
  write(options, imported, document, files_of(options, made));
  return ExitCode::kPasses;
}

}  // namespace

void add_import_command(command_line::Command& robot) {
  auto options = std::make_shared<ImportOptions>();
  command_line::Command command =
      robot.add_command("import", "Read a robot from URDF or MJCF (MuJoCo's XML)");
  command.add_option("file", options->file, "A URDF file (.urdf) or an MJCF file (MuJoCo's XML)")
      .required();
  command
      .add_option("--format", options->format, "What the file is, where its ending does not say it")
      .otherwise("by the file's ending, else mjcf")
      .one_of({"urdf", "mjcf"});
  command
      .add_option("--body", options->reading.body,
                  "Which body of an MJCF file's world is the robot, where several move")
      .otherwise("the only one that moves");
  command.add_flag("--drop-base-armature", options->reading.drops_base_armature,
                   "Read a free joint with armature as one without");
  command.add_flag("--free-couplings", options->reading.frees_couplings,
                   "Leave out equalities that couple joints or tendons");
  command.add_flag(
      "--mend-inertias", options->reading.mends_inertias,
      "Where rounding made an inertia that no body can have, take the nearest that one can");
  command.add_flag("--weld-locked", options->reading.welds_locked,
                   "Weld URDF's joints whose limits are left out or both zero, which move freely "
                   "in simulators");
  command
      .add_option("--ignore", options->reading.ignored_words,
                  "WORD: leave elements and attributes of this name behind where they are refused")
      .otherwise("none")
      .one_value_each();
  command
      .add_option("--feet", options->feet,
                  "NAME: a link, geom or site that the robot stands on, in the place of those that "
                  "names and shapes tell; * stands for any letters. NAME=X0:X1,Y0:Y1,Z: its sole, "
                  "in its axes, in m")
      .otherwise("what is called a foot, else what ends a leg")
      .one_value_each();
  command
      .add_option(
          "--actuator", options->actuators,
          "NAME=FILE: a drive of a linkage that <connect> closes, and its actuator's document")
      .otherwise("none")
      .one_value_each();
  command
      .add_option("--link-error", options->link_error,
                  "Share by which a motion's kinetic energy may be off because the mass of cranks "
                  "and rods goes to their neighbours")
      .otherwise(fmt::format("{:g}", hopper::ImportFileOptions().greatest_link_error))
      .between(0, 1);
  command
      .add_option("--open-loop", options->reading.opened_loops,
                  "NAME: leave out a <connect> of that name, or one that joins a body or site of "
                  "it: nothing closes that loop then")
      .otherwise("none")
      .one_value_each();
  command.add_flag("--massless-links", options->reading.drops_link_mass,
                   "Leave out what cranks and rods of linkages weigh");
  command
      .add_option("--actuators", options->drive_folder,
                  "Write an actuator for each joint's limits of torque and speed to this folder, "
                  "and let it drive the joint")
      .otherwise("no drives are made of limits");
  command.add_option("-o,--output", options->output_file, "Write the document to this file")
      .otherwise("-, standard output")
      .names_a_file();
  command.example("torquewright robot import specs/robot/rabbit.urdf -o rabbit.json");
  command.works([options] { return run_import(*options); });
}

}  // namespace torquewright::cli
