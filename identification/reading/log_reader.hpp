// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "actuator/trajectory/clock.hpp"
#include "identification/log/log.hpp"
#include "identification/log/stretch.hpp"
#include "identification/reading/columns.hpp"
#include "identification/reading/empty_cells.hpp"
#include "identification/reading/printed_digits.hpp"
#include "identification/reading/stale_rows.hpp"
#include "io/files/csv.hpp"

namespace torquewright::identification {

/// Reads logs stretch by stretch, without repairing anything. Long stretches come in pieces of some
/// kPieceRows rows, so that memory stays small.
class LogReader {
 public:
  LogReader(std::vector<std::filesystem::path> files, const Rig& rig);

  /// The next stretch, or piece of one (all but the first have Run::continues); false at the end.
  /// Rows of one time, rounded, are spread to the next; equal ones, stale ones and a cut last line
  /// left out.
  /// Throws io::SpecError for what cannot be read: columns that do not fit the rig, cells that are
  /// no finite number, time that runs backwards or stands still within a run, rows of one run in
  /// two places, a file without samples.
  bool next_stretch(Stretch& stretch);

  /// The files that were read so far.
  const std::vector<Log::File>& files_read() const { return files_read_; }

  /// Returns findings on rows that were left out or moved.
  std::vector<DataFinding> findings() const;

  /// Returns the last digits that the channels' numbers are written to, by joint.
  std::vector<PrintedSteps> printed_steps() const;

  /// Steps by whose median gaps are told from steps, the first of a run.
  static constexpr std::size_t kStepsForMedian = 1000;
  /// A piece has at least so many rows and lasts so long, unless its stretch is shorter; the rest
  /// of the stretch at least half of it. Choices of ours.
  static constexpr std::size_t kPieceRows = 30000;
  static constexpr double kPiece_s = 10.0;
  /// More rows of one time than these are no rounded time. A choice of ours.
  static constexpr std::size_t kMostAtOnce = 100;

 private:
  void open_file();
  void close_file();
  void read_row();
  void begin_run(std::string_view name);
  void end_run();
  void check_time(double time_s);
  bool repeats_row() const;
  void drop_if_stale(double next_s);
  void spread(double next_s);
  void append(double time_s);
  void require_possible(const Source& source, double value) const;
  void warn_of_long_steps();
  /// The value in a source's cell of the present row; none where it is empty.
  std::optional<double> cell(const Source& source) const;
  void append(const Source& source, std::size_t joint, std::optional<double> value);
  void learn_step();
  bool turns_too_far(std::size_t row) const;
  bool holds_piece() const;
  void hand_over_piece();
  void hand_over(std::size_t begin, std::size_t end);

  std::vector<std::filesystem::path> files_;
  const Rig& rig_;
  std::size_t file_ = 0;
  std::unique_ptr<io::CsvReader> csv_;
  Columns columns_;
  actuator::Clock clock_;  ///< Clock of the present file.
  std::set<std::string, std::less<>> names_in_file_;
  Run run_;  ///< Rows of the present run that were not handed over yet.
  bool is_in_run_ = false;
  std::optional<double> median_s_;  ///< Median of the present run's steps, once there are enough.
  double stamp_s_ = 0.0;            ///< Time as the last row states it.
  double previous_s_ = 0.0;         ///< Time of the last row, after it was moved.
  std::size_t at_once_ = 0;         ///< Number of rows with this stamp.
  double stamp_step_s_ = 0.0;  ///< Step between the last two stamps of the run; 0: not yet known.
  std::size_t previous_line_ = 0;
  std::optional<Gap> gap_;  ///< The gap before what is read now.
  bool continues_ = false;  ///< What is read now continues what was handed over.
  std::deque<Stretch> ready_;
  std::vector<Log::File> files_read_;
  bool warns_of_steps_ = false;
  struct Rows {
    std::size_t count = 0;
    std::vector<std::string> runs;
    void add(const std::string& run, std::size_t rows);
  };
  Rows repeated_, spread_, stale_;
  EmptyCells empty_cells_;
  std::size_t repeats_ = 0;             ///< Number of last rows that repeat the row before them.
  std::vector<Resolution> resolution_;  ///< Resolutions of positions, by channel of columns_.
  std::vector<DataFinding> findings_;   ///< Findings on the files.
  struct Printed {
    PrintedDigits digits;
    double scale = 1.0;
  };
  std::vector<std::array<Printed, kQuantityCount>> printed_;  ///< Written digits by joint.
};

}  // namespace torquewright::identification
