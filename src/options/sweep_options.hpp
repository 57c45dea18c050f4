// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// How points are done, in the words of the command line.
struct PointOptions {
  std::size_t jobs = 0;      ///< Processes; 0: not stated.
  std::string journal_file;  ///< Empty: beside the output.
};

/// What a sweep is asked.
struct SweepOptions {
  std::vector<std::string> axes;  ///< NAME=FROM:TO[:STEP] or NAME=A,B,C; empty: no sweep.
  PointOptions points;
  std::string plot_file;  ///< Empty: not asked for.
};

/// Adds --jobs and --sweep-journal; both need the option that makes points, where one is named.
void add_point_options(command_line::Command& command, PointOptions& options,
                       const std::string& needed);

/// Whether jobs or a journal were stated, or mpirun started this program: for what threads would do
/// else.
bool asks_for_processes(const PointOptions& options);

/// Adds --sweep and what goes with it.
void add_sweep_options(command_line::Command& command, SweepOptions& options);

/// Throws io::SpecError for the first option that asks for what shows one robot, beside --sweep.
void refuse_of_one_robot(const command_line::DeclaredCommand& command);

/// The journal's file: as stated, or the output's name with ".journal" behind it; none where there
/// is no output or it is no file.
std::string journal_of(const PointOptions& options, const std::string& output_file);

}  // namespace torquewright::cli
