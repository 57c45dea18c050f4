// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "hopper/files/mjcf_reader.hpp"
#include "hopper/files/urdf_reader.hpp"
#include "hopper/robot/robot_json.hpp"
#include "hopper/robot/robot_spec.hpp"
#include "io/atomic_file.hpp"
#include "io/document.hpp"
#include "io/json_text.hpp"
#include "src/commands/result_json.hpp"
#include "src/commands/robot_commands.hpp"
#include "src/options/output_files.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct ImportOptions {
  std::string file;
  std::string format;
  std::string output_file;
  hopper::ImportFileOptions reading;
};

hopper::Imported read(const ImportOptions& options) {
  const bool is_urdf = options.format.empty()
                           ? std::filesystem::path(options.file).extension() == ".urdf"
                           : options.format == "urdf";
  hopper::Imported imported = is_urdf ? hopper::read_urdf(options.file, options.reading)
                                      : hopper::read_mjcf(options.file, options.reading);
  io::check_outputs(named({options.output_file}), {});
  return imported;
}

/// The robot's document. What a file says may still be no robot (inertias that no body has): such a
/// document is refused. It names no other files, so that checking it opens none.
std::string compute(const ImportOptions& options, const hopper::Imported& imported) {
  std::string text = io::json_text(hopper::robot_json(imported.robot));
  (void)hopper::robot_of(io::check_document(as_read(text), "robot", options.file, ""));
  return text;
}

void write(const ImportOptions& options, const hopper::Imported& imported,
           const std::string& document) {
  deliver_result(document, options.output_file);
  if (options.output_file.empty()) return;
  const std::size_t bodies = imported.robot.tree.bodies.size();
  std::string said =
      fmt::format("{}: {} bodies, {} joints\n", options.output_file, bodies, bodies - 1);
  for (const std::string& note : imported.notes) said += "note: " + note + "\n";
  print_result(said);
}

ExitCode run_import(const ImportOptions& options) {
  const hopper::Imported imported = read(options);
  const std::string document = compute(options, imported);
  write(options, imported, document);
  return ExitCode::kPasses;
}

}  // namespace

void add_import_command(command_line::Command& robot) {
  auto options = std::make_shared<ImportOptions>();
  command_line::Command command = robot.add_command("import", "URDF or MJCF in");
  command.add_option("file", options->file, "A URDF file (.urdf) or an MJCF file").required();
  command.add_option("--format", options->format, "Where the file's ending does not say it")
      .one_of({"urdf", "mjcf"});
  command.add_option("--body", options->reading.body,
                     "Of an MJCF file's world: the body that is the robot, where several move");
  command.add_flag("--drop-base-armature", options->reading.drops_base_armature,
                   "Read a free joint with armature as one without");
  command.add_flag("--free-couplings", options->reading.frees_couplings,
                   "Leave out equalities that couple joints or tendons");
  command.add_flag("--mend-inertias", options->reading.mends_inertias,
                   "Inertias that no body has, but for the rounding of their numbers: the nearest "
                   "that one has");
  command.add_option("-o,--output", options->output_file, "Write the document to this file")
      .names_a_file();
  command.example("torquewright robot import specs/robot/rabbit.urdf -o rabbit.json");
  command.works([options] { return run_import(*options); });
}

}  // namespace torquewright::cli
