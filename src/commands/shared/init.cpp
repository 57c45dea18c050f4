// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "actuator/catalogue/drive_set.hpp"
#include "gearbox/synthesis_defaults_spec.hpp"
#include "identification/draft/rig_draft_json.hpp"
#include "io/documents/json_layout.hpp"
#include "io/documents/published_schema.hpp"
#include "io/documents/schema.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "io/text/wording.hpp"
#include "src/commands/shared/schema_commands.hpp"
#include "src/commands/shared/sheet_json.hpp"
#include "src/commands/shared/sheet_questions.hpp"
#include "src/options/output_files.hpp"
#include "src/report/identification/draft_text.hpp"
#include "src/report/parts/key_table.hpp"
#include "src/report/parts/shell_word.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

struct InitOptions {
  std::string kind;
  std::string output_file;
  std::string from;  ///< An actuator of the catalogue; of a rig a log.
  bool is_envelope = false;
  bool is_synthesis = false;
  bool from_sheet = false;
  bool all_keys = false;
  bool explains = false;
};

/// A kind of which people write documents, and what one does with such a document.
struct StartedKind {
  std::string_view kind;
  std::string_view next;  ///< {} is the document.
};

constexpr auto kStartedKinds = std::to_array<StartedKind>({
    {"actuator", "actuator mor {}"},
    {"controller", "hopper replay ROBOT MOTION --controller osc --tasks {}"},
    {"gear_strength", "gearbox strength {} --torque 20 --side joint"},
    {"gearbox", "actuator mor ACTUATOR, whose \"gearbox\" names this file as its \"file\""},
    {"gearbox_problem", "gearbox optimize {}"},
    {"jacobian", "actuator check TRAJECTORY --jacobian {} --joint NAME=ACTUATOR ..."},
    {"policy", "policy export {} --format onnx -o policy.onnx"},
    {"randomisation", "hopper replay ROBOT MOTION --trials 20 --randomise {}"},
    {"rig", "identify LOG --rig {} --actuator ACTUATOR"},
    {"robot", "init actuator -o actuator.json; then robot export {} --format mjcf"},
    {"training_task", "hopper train ROBOT --task {}"},
    {"trajectory_columns", "actuator check TRAJECTORY --columns {} --joint NAME=ACTUATOR"},
});

std::vector<std::string> started_kinds() {
  std::vector<std::string> kinds;
  for (const StartedKind& started : kStartedKinds) kinds.emplace_back(started.kind);
  return kinds;
}

const StartedKind& started(const std::string& kind) {
  const auto* found = std::find_if(kStartedKinds.begin(), kStartedKinds.end(),
                                   [&](const StartedKind& each) { return each.kind == kind; });
  if (found == kStartedKinds.end()) {
    io::refuse("init", fmt::format("a {} is written by the program; documents to start from are {}",
                                   kind, io::listed(started_kinds())));
  }
  return *found;
}

/// Where somebody has begun already, nothing is written over.
void refuse_existing(const std::string& file) {
  std::error_code unknown;  // what cannot be looked at cannot be written either, which is said then
  if (file.empty() || !std::filesystem::is_regular_file(file, unknown)) return;
  io::refuse(file, "is there already; init writes over no document");
}

std::string next_line(const StartedKind& kind, const std::string& file) {
  return fmt::format("\nnext: torquewright {}\n",
                     fmt::format(fmt::runtime(kind.next), report::shell_word(file)));
}

/// Where the document will be; on standard output, here.
std::filesystem::path folder_of(const std::string& output_file) {
  const bool is_file = !output_file.empty() && !is_standard_output(output_file);
  return is_file ? std::filesystem::absolute(output_file).parent_path()
                 : std::filesystem::current_path();
}

/// A document to start from, and what is printed beside it.
struct Start {
  std::string document;
  std::string explanation;
  std::string next;
};

Start rig_of_log(const std::string& log, const std::string& output_file) {
  const identification::RigDraft draft = identification::draft_rig(log);
  const std::string name = "drafted from " + std::filesystem::path(log).filename().string();
  return {io::json_layout(identification::rig_draft_json(draft, name)),
          report::rig_draft_text(draft),
          fmt::format("\nnext: torquewright identify {} --rig {} --actuator ACTUATOR\n",
                      report::shell_word(log), report::shell_word(output_file))};
}

/// The document with what its keys mean, or what all of them do.
Start explained(const InitOptions& options, std::string document, const std::string& next) {
  std::string explanation = options.all_keys ? report::key_table_text(options.kind)
                                             : report::key_table_text(options.kind, document);
  return {std::move(document), std::move(explanation), next};
}

std::string synthesis_of(const InitOptions& options) {
  return io::json_layout(options.all_keys ? gearbox::synthesis_to_start_from()
                                          : gearbox::synthesis_in_few_lines());
}

/// Of the kind: the usual one, or the one that an option names.
Start start_of(const InitOptions& options, const StartedKind& kind) {
  const bool is_rig = options.kind == "rig", is_actuator = options.kind == "actuator";
  if (options.from_sheet && !is_actuator) {
    io::refuse("--from-sheet", fmt::format("is of an actuator, not of a {}", options.kind));
  }
  if (options.is_envelope && !is_actuator) {
    io::refuse("--envelope", fmt::format("is of an actuator, not of a {}", options.kind));
  }
  if (options.is_synthesis && options.kind != "gearbox_problem") {
    io::refuse("--synthesis", fmt::format("is of a gearbox_problem, not of a {}", options.kind));
  }
  if (!options.from.empty() && !is_actuator && !is_rig) {
    io::refuse(
        "--from",
        fmt::format("is of an actuator (a name of the catalogue) or of a rig (a log), not of "
                    "a {}",
                    options.kind));
  }
  if (is_rig && !options.from.empty()) return rig_of_log(options.from, options.output_file);
  const std::string next = next_line(kind, options.output_file);
  if (options.from_sheet) {
    SheetDocument sheet =
        sheet_document(ask_sheet(sheet_objection), folder_of(options.output_file));
    return {std::move(sheet.text), std::move(sheet.explanation), next};
  }
  if (options.is_synthesis) {
    return explained(options, synthesis_of(options), next);
  }
  if (!options.from.empty())
    return explained(options, actuator::catalogue_text(options.from), next);
  const auto keys = options.all_keys ? io::StartKeys::kAll : io::StartKeys::kUsual;
  return explained(
      options, io::document_to_start_from(options.kind, options.is_envelope ? 1 : 0, keys), next);
}

ExitCode run_init(const InitOptions& options) {
  const StartedKind& kind = started(options.kind);
  refuse_existing(options.output_file);
  check_written(named({options.output_file}), {});
  const Start start = start_of(options, kind);
  const bool is_file = !options.output_file.empty() && !is_standard_output(options.output_file);
  if (is_file) {
    deliver_result(start.document, options.output_file);
    print_result(for_window(start.explanation + start.next));
  } else if (options.explains && options.output_file.empty()) {
    print_result(for_window(start.explanation));
  } else {
    print_result(start.document);
  }
  return ExitCode::kPasses;
}

}  // namespace

void add_init_command(command_line::Command& program) {
  auto options = std::make_shared<InitOptions>();
  command_line::Command command = program.add_command("init", "Print a document to start from");
  command.add_option("kind", options->kind, "Kind of document")
      .required()
      .one_of(io::document_kinds())
      .offers(started_kinds());
  command
      .add_option("-o,--output", options->output_file,
                  "Write the document to this file, which must not exist, and print what its keys "
                  "mean")
      .otherwise("-, standard output")
      .names_a_file();
  command.add_flag("--envelope", options->is_envelope,
                   "An actuator that is known by its curve: two numbers, a corner or points");
  command.add_flag("--synthesis", options->is_synthesis,
                   "A gearbox_problem whose shifts, modules and face widths are chosen too; "
                   "--all-keys prints what its eight lines leave out");
  command
      .add_option("--from", options->from,
                  "An actuator of the catalogue, by its name in `actuator find`; for a rig the log "
                  "(CSV) whose columns it is to name")
      .otherwise("none")
      .excludes("--envelope");
  command
      .add_flag("--all-keys", options->all_keys,
                "Every key that can stand beside the others, not only those that one must state or "
                "usually states")
      .excludes("--from");
  command
      .add_flag("--from-sheet", options->from_sheet,
                "An actuator of the ten numbers that sheets print: asks for each on a terminal, "
                "else reads a line for each from standard input; an empty line: not known")
      .excludes("--envelope")
      .excludes("--from")
      .excludes("--all-keys");
  command.add_flag("--explain", options->explains, "Print what its keys mean, and no document")
      .excludes("--from-sheet");
  command.example("torquewright init actuator");
  command.works([options] { return run_init(*options); });
}

}  // namespace torquewright::cli
