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
#include "src/commands/robot_commands.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct ImportOptions {
  std::string file;
  std::string format;
  std::string output_file;
};

hopper::Imported imported(const ImportOptions& options) {
  const bool is_urdf = options.format.empty()
                           ? std::filesystem::path(options.file).extension() == ".urdf"
                           : options.format == "urdf";
  return is_urdf ? hopper::read_urdf(options.file) : hopper::read_mjcf(options.file);
}

ExitCode run_import(const ImportOptions& options) {
  if (!options.output_file.empty()) io::check_outputs({options.output_file}, {options.file});
  const hopper::Imported read = imported(options);
  const std::string text = io::json_text(hopper::robot_json(read.robot));
  // What a file says may still be no robot (inertias that no body has): its document is refused.
  (void)hopper::robot_of(
      io::check_document(nlohmann::json::parse(text), "robot", options.file, ""));
  if (options.output_file.empty()) {
    print_result(text);
    return ExitCode::kPasses;
  }
  io::write_whole_file(options.output_file, text);
  std::string said = fmt::format("{}: {} bodies, {} joints\n", options.output_file,
                                 read.robot.tree.bodies.size(), read.robot.tree.bodies.size() - 1);
  for (const std::string& note : read.notes) said += "note: " + note + "\n";
  print_result(said);
  return ExitCode::kPasses;
}

}  // namespace

void add_import_command(CLI::App& robot, ExitCode& result) {
  auto options = std::make_shared<ImportOptions>();
  CLI::App* command = robot.add_subcommand("import", "URDF or MJCF in");
  command->add_option("file", options->file, "A URDF file (.urdf) or an MJCF file")->required();
  command->add_option("--format", options->format, "Where the file's ending does not say it")
      ->check(CLI::IsMember({"urdf", "mjcf"}));
  command->add_option("-o,--output", options->output_file, "Write the document to this file");
  command->footer("Example:\n  torquewright robot import specs/robot/rabbit.urdf -o rabbit.json");
  command->callback([options, &result] { result = run_import(*options); });
}

}  // namespace torquewright::cli
