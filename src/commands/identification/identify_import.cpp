// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "identification/imports/files_json.hpp"
#include "io/documents/document.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/long_file.hpp"
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
  std::string format, folder, joint, units, topic, commands, clock;
  std::vector<std::string> files;
};

/// Whether it is there as it would be written. Refuses one that says something else: who names a
/// folder has not named it, a log may be somebody's only one, and a rig edited.
bool is_there(const fs::path& file, const io::TextSource& text) {
  std::error_code unknown;
  if (!fs::is_regular_file(file, unknown)) return false;
  if (io::holds(file, text)) return true;
  io::refuse(file.string(),
             "is there already and says something else; take it away, or name another "
             "folder by -o");
}

/// Whether its columns are of several joints, as a robot's are.
bool has_joints(const identification::ImportedLog& log) {
  return std::any_of(log.columns.begin(), log.columns.end(),
                     [](const identification::ColumnUse& use) { return !use.joint.empty(); });
}

struct Written {
  fs::path csv, rig;
  io::TextSource csv_text;
  std::string rig_text;
};

/// What of the two is not there yet.
void write(const ImportOptions& options, const Written& written) {
  const io::NewFolder folder(options.folder);
  io::check_outputs({written.csv, written.rig}, {options.files.begin(), options.files.end()});
  std::vector<io::FileContent> rig;
  const auto rig_text = [&](const io::TextSink& sink) { sink(written.rig_text); };
  const bool has_csv = is_there(written.csv, written.csv_text);
  if (!is_there(written.rig, rig_text)) rig.push_back({written.rig, written.rig_text});
  if (has_csv) {
    io::write_whole_files(rig);
  } else {
    io::write_whole_files(written.csv, written.csv_text, rig);
  }
}

/// An option that would say nothing is a mistake.
void require_asked_for(const ImportOptions& options, const identification::Importer& importer) {
  if (!options.units.empty() && !importer.asks_units) {
    io::refuse("--units",
               fmt::format("{}'s files say themselves what they are in", options.format));
  }
  if (!options.joint.empty() && !importer.asks_joint) {
    io::refuse("--joint", fmt::format("{}'s files are read as those of one joint; leave \"{}\" out",
                                      options.format, options.joint));
  }
  const std::string of_topics = options.topic + options.commands + options.clock;
  if (!of_topics.empty() && !importer.asks_topic) {
    io::refuse("format", fmt::format("{}'s files have no topics; leave --topic, --commands and "
                                     "--clock out",
                                     options.format));
  }
}

ExitCode run_import(const ImportOptions& options) {
  const identification::Importer& importer = identification::importer_of(options.format);
  require_asked_for(options, importer);
  const identification::ImportedLog log =
      importer.read({{options.files.begin(), options.files.end()},
                     options.joint,
                     options.units,
                     options.topic,
                     options.commands,
                     options.clock == "recorder"});
  const fs::path folder = options.folder;
  const fs::path csv = folder / "log.csv", rig = folder / "rig.json";
  const std::string name = io::stem_in_text(options.files.front());
  const std::string rig_text = identification::imported_rig(log, name);
  // What a file states may be beyond what any rig has.
  io::check_document(as_read(rig_text), "rig", io::name_in_text(rig) + " is not written", "");
  const auto csv_text = [&](const io::TextSink& sink) { identification::imported_csv(log, sink); };
  write(options, {csv, rig, csv_text, rig_text});
  std::string said =
      fmt::format("{}: {} run{}\n{}: {} columns\n", io::name_in_text(csv), log.runs.size(),
                  log.runs.size() == 1 ? "" : "s", io::name_in_text(rig), log.columns.size());
  for (const std::string& note : log.notes) said += "note: " + note + "\n";
  if (!log.load && log.loads.empty()) {
    said +=
        fmt::format("next: state in {} what the actuator moved (\"load\"{}); see docs/logs.md\n",
                    io::name_in_text(rig), has_joints(log) ? "; or identify --robot FILE" : "");
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
  command
      .add_option("--joint", options->joint,
                  "Which joint is read, where a file holds several; of mcap and ros2 several, as "
                  "'*_calf_joint,FL_*'")
      .otherwise("the only one; of mcap and ros2 all");
  command
      .add_option("--topic", options->topic,
                  "mcap, ros2: the topic of joint states that were measured")
      .otherwise("the only one");
  command
      .add_option("--commands", options->commands,
                  "mcap, ros2: the topic of joint states that were commanded")
      .otherwise("none");
  command
      .add_option("--clock", options->clock,
                  "mcap, ros2: times are the stamps of messages, or when they came (recorder)")
      .one_of({"stamp", "recorder"})
      .otherwise("stamp");
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
