// SPDX-License-Identifier: Apache-2.0
#include "src/options/sweep_options.hpp"

#include <filesystem>

#include "io/faults/refusal.hpp"
#include "io/files/direct_output.hpp"
#include "src/command_line/option_echo.hpp"
#include "src/sweep/ranks.hpp"

namespace torquewright::cli {

void add_point_options(command_line::Command& command, PointOptions& options,
                       const std::string& needed) {
  command_line::Option jobs =
      command.add_option("--jobs", options.jobs, "How many processes share the work")
          .otherwise("as many as the processor runs at once")
          .integer_between(1, 256);
  command_line::Option journal =
      command
          .add_option("--sweep-journal", options.journal_file,
                      "Keep each answer in this file as it comes, and take those that it holds")
          .otherwise("beside the output, as OUTPUT.journal")
          .names_a_file()
          .not_standard_output();
  if (needed.empty()) return;
  jobs.needs(needed);
  journal.needs(needed);
}

bool asks_for_processes(const PointOptions& options) {
  return options.jobs > 0 || !options.journal_file.empty() ||
         sweep::ranks_by_environment().count > 1;
}

void add_sweep_options(command_line::Command& command, SweepOptions& options) {
  command
      .add_option(
          "--sweep", options.axes,
          "NAME=FROM:TO[:STEP] or NAME=A,B,C, once or twice: answer for the robot with each "
          "of these; names are voltage, current, resistance, mass, ratio, of one drive "
          "knee_ratio, as factors knee_ratio_factor")
      .otherwise("none")
      .one_value_each();
  add_point_options(command, options.points, "");
  command
      .add_option("--plot-sweep", options.plot_file,
                  "Draw the sweep as a chart, or as a map over two quantities, to this SVG or PNG")
      .names_a_file()
      .needs("--sweep");
}

void refuse_of_one_robot(const command_line::DeclaredCommand& command) {
  for (const std::string& option : command_line::named_of_one_answer(command)) {
    io::refuse(option, "is of one robot, --sweep of several");
  }
}

std::string journal_of(const PointOptions& options, const std::string& output_file) {
  if (!options.journal_file.empty() || output_file.empty() || output_file == "-") {
    return options.journal_file;
  }
  std::error_code unknown;
  const bool is_file = !std::filesystem::is_other(output_file, unknown);
  return is_file && !io::named_descriptor(output_file) ? output_file + ".journal" : std::string();
}

}  // namespace torquewright::cli
