// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "identification/imports/files_json.hpp"
#include "io/documents/document.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/file_bytes.hpp"
#include "io/files/new_folder.hpp"
#include "io/text/one_line.hpp"
#include "src/commands/identification/identify_commands.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

namespace fs = std::filesystem;

struct ImportOptions {
  std::string format, folder, joint, units;
  std::vector<std::string> files;
};

/// Whether it is there as it would be written. Refuses one that says something else: who names a
/// folder has not named it, a log may be somebody's only one, and a rig edited.
bool is_there(const io::FileContent& made) {
  std::error_code unknown;
  if (!fs::is_regular_file(made.file, unknown)) return false;
  if (io::holds(made.file, made.content)) return true;
  io::refuse(made.file.string(),
             "is there already and says something else; take it away, or name another "
             "folder by -o");
}

/// What of the two is not there yet.
void write(const ImportOptions& options, std::vector<io::FileContent> log_and_rig) {
  const io::NewFolder folder(options.folder);
  io::check_outputs({log_and_rig[0].file, log_and_rig[1].file},
                    {options.files.begin(), options.files.end()});
  std::erase_if(log_and_rig, is_there);
  io::write_whole_files(log_and_rig);
}

ExitCode run_import(const ImportOptions& options) {
  const identification::Importer& importer = identification::importer_of(options.format);
  if (!options.units.empty() && !importer.asks_units) {
    io::refuse("--units",
               fmt::format("{}'s files say themselves what they are in", options.format));
  }
  if (!options.joint.empty() && !importer.asks_joint) {
    io::refuse("--joint", fmt::format("{}'s files are read as those of one joint; leave \"{}\" out",
                                      options.format, options.joint));
  }
  const identification::ImportedLog log =
      importer.read({{options.files.begin(), options.files.end()}, options.joint, options.units});
  const fs::path folder = options.folder;
  const fs::path csv = folder / "log.csv", rig = folder / "rig.json";
  const std::string name = io::stem_in_text(options.files.front());
  const std::string rig_text = identification::imported_rig(log, name);
  // What a file states may be beyond what any rig has.
  io::check_document(as_read(rig_text), "rig", io::name_in_text(rig) + " is not written", "");
  write(options, {{csv, identification::imported_csv(log)}, {rig, rig_text}});
  std::string said =
      fmt::format("{}: {} run{}\n{}: {} columns\n", io::name_in_text(csv), log.runs.size(),
                  log.runs.size() == 1 ? "" : "s", io::name_in_text(rig), log.columns.size());
  for (const std::string& note : log.notes) said += "note: " + note + "\n";
  if (!log.load && log.loads.empty()) {
    said += fmt::format("next: state in {} what the actuator moved (\"load\"), docs/logs.md\n",
                        io::name_in_text(rig));
  }
  print_result(for_window(said));
  return ExitCode::kPasses;
}

std::string formats() {
  std::string text;
  for (const identification::Importer* importer : identification::importer_library()) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", importer->name, importer->what);
  }
  return text;
}

}  // namespace

void add_identify_import(command_line::Command& identify) {
  auto options = std::make_shared<ImportOptions>();
  command_line::Command command = identify.add_command("import", "Read logs of other programs");
  command.add_option("format", options->format, formats()).required();
  command.add_option("files", options->files, "Files of that format; each is a run, or holds runs")
      .required();
  command.add_option("--joint", options->joint, "Which joint is read, where a file holds several")
      .otherwise("the only one");
  command
      .add_option("--units", options->units,
                  "sysid_csv: what positions are in (Rotations, Meters, ...)")
      .otherwise("not needed");
  command
      .add_option("-o,--output", options->folder,
                  "Write log.csv and rig.json into this folder, which is made where it is missing")
      .required()
      .names_a_file()
      .not_standard_output();
  command.example("torquewright identify import moteus specs/log/wheel_moteus.csv -o imported");
  command.works([options] { return run_import(*options); });
}

}  // namespace torquewright::cli
