// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/log_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include "actuator/heat/working_temperature.hpp"
#include "identification/reading/channel.hpp"
#include "identification/reading/remedy.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::identification {
namespace {

/// What a recorder's float can hold, marks of what was not measured among it. Squares of squares
/// of more overflow.
constexpr double kGreatestReading = std::numeric_limits<float>::max();

constexpr double kLongStep_s = 0.5;
constexpr double kQuarterTurn_rad = 0.5 * std::numbers::pi;

bool is_angle(Quantity quantity) {
  return quantity == Quantity::kOutputPosition || quantity == Quantity::kMotorPosition;
}

bool is_position(Quantity quantity) {
  return is_angle(quantity) || quantity == Quantity::kLinearPosition;
}

/// What programs write where they have no number: nan, NaN, -nan(ind).
bool is_nan(std::string_view text) {
  double value = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc() && read.ptr == text.data() + text.size() && std::isnan(value);
}

}  // namespace

LogReader::LogReader(std::vector<std::filesystem::path> files, const Rig& rig)
    : files_(std::move(files)), rig_(rig), printed_(rig.joints.size()) {}

std::vector<PrintedSteps> LogReader::printed_steps() const {
  std::vector<PrintedSteps> steps;
  for (const auto& channels : printed_) {
    PrintedSteps& of_joint = steps.emplace_back();
    for (std::size_t i = 0; i < kQuantityCount; ++i) {
      of_joint[i] = std::abs(channels[i].scale) * channels[i].digits.last_digit();
    }
  }
  return steps;
}

std::vector<DataFinding> LogReader::findings() const {
  std::vector<DataFinding> all = findings_;
  const auto say = [&](const Rows& rows, Weight weight, const char* what) {
    if (rows.count == 0) return;
    all.push_back({weight, fmt::format("{} row{} {} in {}", rows.count, rows.count == 1 ? "" : "s",
                                       what, describe_runs(rows.runs))});
  };
  say(repeated_, Weight::kNote, "of equal time and values: counted once");
  say(spread_, Weight::kWarning,
      "of other values at the time of the row before, a rounded time: spread evenly to the next "
      "time");
  say(stale_, Weight::kWarning,
      "that repeat the row before while the joint moves on, words of another time: left out");
  const std::vector<DataFinding> empty = empty_cells_.findings(rig_);
  all.insert(all.end(), empty.begin(), empty.end());
  return all;
}

bool LogReader::next_stretch(Stretch& stretch) {
  while (ready_.empty()) {
    if (!csv_) {
      if (file_ == files_.size()) return false;
      open_file();
    }
    if (csv_->next()) {
      read_row();
    } else {
      close_file();
    }
  }
  stretch = std::move(ready_.front());
  ready_.pop_front();
  return true;
}

void LogReader::open_file() {
  csv_ = std::make_unique<io::CsvReader>(files_[file_], io::CsvReader::CutEnd::kDropped,
                                         io::CsvReader::UnitsRow::kTaken);
  columns_ = find_columns(*csv_, rig_);
  clock_ = {};
  names_in_file_.clear();
}

void LogReader::close_file() {
  if (!is_in_run_) {
    throw io::SpecError({{csv_->file(), "", "holds no samples, only the names of columns"}});
  }
  end_run();
  if (csv_->cut_line() > 0) {
    findings_.push_back(
        {Weight::kNote, fmt::format("{}: the last line, {}, ends within the row: it "
                                    "is left out",
                                    csv_->file(), csv_->cut_line())});
  }
  const std::string dialect = csv_->dialect();
  if (!dialect.empty()) {
    findings_.push_back({Weight::kNote, fmt::format("{}: {}", csv_->file(), dialect)});
  }
  if (!csv_->units().empty()) {
    findings_.push_back({Weight::kNote, fmt::format("{}: the row under the header names units, "
                                                    "which hold where the rig states none",
                                                    csv_->file())});
  }
  for (const std::string& doubt : columns_.doubts) {
    findings_.push_back({Weight::kWarning, fmt::format("{}: {}", csv_->file(), doubt)});
  }
  if (!clock_.sentence().empty()) {
    findings_.push_back({Weight::kNote, fmt::format("{}: {}", csv_->file(), clock_.sentence())});
  }
  const Log::File read{io::name_in_text(csv_->file()), csv_->sha256()};
  for (const Log::File& other : files_read_) {
    if (other.sha256 != read.sha256 || other.path == read.path) continue;
    throw io::SpecError(
        {{read.path, "",
          fmt::format("holds the same as {}, byte for byte; a run that is held out must not be one "
                      "that was fitted: leave one of them out",
                      other.path)}});
  }
  files_read_.push_back(read);
  csv_.reset();
  ++file_;
}

void LogReader::read_row() {
  if (!is_in_run_) {
    begin_run(columns_.run ? csv_->text(*columns_.run) : "");
  } else if (columns_.run && csv_->text(*columns_.run) != run_.name) {
    end_run();
    begin_run(csv_->text(*columns_.run));
  }
  if (!columns_.time) return append(0.0);
  const Source& time = *columns_.time;
  const double stated_s = csv_->time(time.column) * time.scale + time.offset;
  csv_->require_within(time.column, stated_s, kGreatestReading);
  const double time_s = clock_.since_origin_s(stated_s);
  const bool has_previous = at_once_ > 0;
  if (has_previous && time_s == stamp_s_) {
    if (repeats_row()) return repeated_.add(run_.name, 1);
    if (++at_once_ > kMostAtOnce) {
      csv_->refuse(time.column, fmt::format("time stands still: more than {} rows have {} s",
                                            kMostAtOnce, stated_s));
    }
  } else {
    const bool is_repeat = has_previous && repeats_row();
    if (!is_repeat) drop_if_stale(time_s);
    check_time(time_s);
    at_once_ = 1;
    repeats_ = is_repeat && !run_.masked.empty() ? repeats_ + 1 : 0;
  }
  append(time_s);
}

/// All channels of it are those of the row before; an empty cell says nothing else.
bool LogReader::repeats_row() const {
  return std::all_of(columns_.channels.begin(), columns_.channels.end(), [&](const Source& source) {
    const Channels& channels = run_.joints[source.joint.value_or(0)];
    const std::optional<double> value = cell(source);
    return !value || channels[source.quantity].back() == *value;
  });
}

std::optional<double> LogReader::cell(const Source& source) const {
  const std::string_view text = csv_->text(source.column);
  if (text.empty() || is_nan(text)) return std::nullopt;
  return csv_->number(source.column) * source.scale + source.offset;
}

/// Where a joint went on as it had come while the rows before this one said the same, they are left
/// out: what they say is of another time.
void LogReader::drop_if_stale(double next_s) {
  bool is_stale = false;
  for (std::size_t i = 0; i < columns_.channels.size(); ++i) {
    const Source& source = columns_.channels[i];
    const std::vector<double>& position = run_.joints[source.joint.value_or(0)][source.quantity];
    const std::optional<double> given = cell(source);
    if (!is_position(source.quantity) || position.empty() || !given) continue;
    const double next = *given;
    const Printed& printed =
        printed_[source.joint.value_or(0)][static_cast<std::size_t>(source.quantity)];
    const double digit = std::abs(printed.scale) * printed.digits.last_digit();
    const Travel travel{run_.time_s, position, std::max(resolution_[i].least(), digit)};
    is_stale = is_stale || are_stale(travel, repeats_, next_s, next);
    resolution_[i].add(next - position.back(), digit);
  }
  if (!is_stale) return;
  stale_.add(run_.name, repeats_);
  drop_last(run_, repeats_);
  empty_cells_.forget_rows();
  stamp_s_ = run_.time_s.back();
  previous_s_ = stamp_s_;
}

/// The rows of the last stamp, evenly over the time to the next one, but for a gap before it.
void LogReader::spread(double next_s) {
  const double step_s = next_s - stamp_s_;
  const double width_s = stamp_step_s_ > 0.0 ? std::min(step_s, stamp_step_s_) : step_s;
  const std::size_t first = run_.time_s.size() - at_once_;
  for (std::size_t i = 1; i < at_once_; ++i) {
    run_.time_s[first + i] =
        stamp_s_ + width_s * static_cast<double>(i) / static_cast<double>(at_once_);
  }
  if (at_once_ > 1) spread_.add(run_.name, at_once_ - 1);
  previous_s_ = run_.time_s.back();
}

void LogReader::Rows::add(const std::string& run, std::size_t rows) {
  count += rows;
  if (runs.empty() || runs.back() != run) runs.push_back(run);
}

void LogReader::begin_run(std::string_view name) {
  if (columns_.run) {
    if (name.empty()) csv_->refuse(*columns_.run, "empty, must name the run");
    if (const auto found = io::unprintable_in(name)) {
      csv_->refuse(*columns_.run,
                   fmt::format("the run's name holds {}; must be one line of text", *found));
    }
    if (!names_in_file_.emplace(name).second) {
      csv_->refuse(*columns_.run, fmt::format("run \"{}\" stands in two places; the rows of a run "
                                              "must follow one another",
                                              name));
    }
    run_.name = name;
  } else {
    run_.name = io::stem_in_text(files_[file_]);
  }
  run_.joints.assign(rig_.joints.size(), {});
  resolution_.assign(columns_.channels.size(), {});
  empty_cells_.begin_run(columns_.channels.size());
  repeats_ = 0;
  is_in_run_ = true;
  median_s_.reset();
}

void LogReader::check_time(double time_s) {
  if (at_once_ > 0) {
    if (time_s < stamp_s_) {
      csv_->refuse(
          columns_.time->column,
          fmt::format("time runs backwards: {} s follows {} s of line {}{}",
                      time_s + clock_.origin_s(), stamp_s_ + clock_.origin_s(), previous_line_,
                      columns_.run ? ""
                                   : "; if another run begins here, add a column that "
                                     "names the runs (\"run\")"));
    }
    spread(time_s);
    if (!median_s_ && run_.time_s.size() > kStepsForMedian) learn_step();
    if (median_s_ && time_s - previous_s_ > kGapFactor * *median_s_) {
      const Gap gap{previous_s_, time_s - previous_s_, *median_s_};
      if (gap.length_s > kLongestBridge_s || turns_too_far(run_.time_s.size())) {
        hand_over(0, run_.time_s.size());
        gap_ = gap;
      }
    } else {
      stamp_step_s_ = time_s - stamp_s_;
    }
    if (holds_piece()) hand_over_piece();
  }
  stamp_s_ = time_s;
  previous_line_ = csv_->line();
}

void LogReader::append(double time_s) {
  if (columns_.time) run_.time_s.push_back(time_s);
  run_.masked.push_back(0);
  for (std::size_t i = 0; i < columns_.channels.size(); ++i) {
    const Source& source = columns_.channels[i];
    const std::optional<double> value = cell(source);
    if (value) {
      csv_->require_within(source.column, *value, kGreatestReading);
      require_possible(source, *value);
    }
    const std::size_t first = source.joint.value_or(0);
    const std::size_t end = source.joint ? first + 1 : run_.joints.size();
    for (std::size_t joint = first; joint < end; ++joint) append(source, joint, value);
    empty_cells_.add(i, {source.quantity, first, end}, value.has_value(), run_);
  }
  if (!columns_.time && holds_piece()) hand_over_piece();
}

/// A temperature that no motor works at is in degrees, or none: copper's law would make of it a
/// winding without resistance.
void LogReader::require_possible(const Source& source, double value) const {
  if (source.quantity != Quantity::kWindingTemperature &&
      source.quantity != Quantity::kCaseTemperature) {
    return;
  }
  const auto is_possible = [](double temperature_K) {
    return temperature_K >= actuator::kColdestWinding_K &&
           temperature_K <= actuator::kHottestWinding_K;
  };
  if (is_possible(value)) return;
  const io::Unit degrees = *io::find_unit("degC");
  const bool is_scaled = source.scale != 1.0 || source.offset != 0.0;
  const std::string hint =
      is_scaled || !is_possible(value * degrees.in_SI + degrees.zero_in_SI)
          ? ""
          : "; degrees Celsius? In the rig, " +
                remedy_by_unit({source.joint.value_or(0), source.quantity}, rig_, degrees);
  csv_->refuse(
      source.column,
      fmt::format("{} of {:.6g} K is outside of {:g} to {:g} K{}", name_of(source.quantity), value,
                  actuator::kColdestWinding_K, actuator::kHottestWinding_K, hint));
}

/// In an empty cell's place stands a number that EmptyCells replaces.
void LogReader::append(const Source& source, std::size_t joint, std::optional<double> value) {
  std::vector<double>& values = run_.joints[joint][source.quantity];
  values.push_back(value.value_or(values.empty() ? 0.0 : values.back()));
  if (!value) return;
  Printed& printed = printed_[joint][static_cast<std::size_t>(source.quantity)];
  printed.scale = source.scale;
  printed.digits.add(csv_->text(source.column));
}

/// And half of one more.
bool LogReader::holds_piece() const {
  if (2 * run_.masked.size() < 3 * kPieceRows) return false;
  return run_.time_s.empty() || run_.time_s.back() - run_.time_s.front() >= 1.5 * kPiece_s;
}

void LogReader::hand_over_piece() {
  const std::size_t rows = run_.masked.size();
  const std::size_t end = rows - rows / 3;
  Run rest = part_of(run_, end, rows);
  run_ = part_of(run_, 0, end);
  hand_over(0, end);
  run_ = std::move(rest);
  empty_cells_.forget_rows();
  gap_.reset();
  continues_ = true;
}

/// From the steps so far; hands over what lies before a gap among them.
void LogReader::learn_step() {
  median_s_ = median_step_s(run_.time_s);
  std::size_t begin = 0;
  warn_of_long_steps();
  for (std::size_t i = 1; i < run_.time_s.size(); ++i) {
    const double step_s = run_.time_s[i] - run_.time_s[i - 1];
    if (step_s <= kGapFactor * *median_s_) continue;
    if (step_s <= kLongestBridge_s && !turns_too_far(i)) continue;
    hand_over(begin, i);
    gap_ = {run_.time_s[i - 1], step_s, *median_s_};
    begin = i;
  }
  if (begin > 0) {
    run_ = part_of(run_, begin, run_.masked.size());
    empty_cells_.forget_rows();
  }
}

/// Across a gap between two rows, of which the later may not stand in the run yet. Of an angle that
/// starts anew with each turn it could not be told which way it went.
bool LogReader::turns_too_far(std::size_t row) const {
  return std::any_of(columns_.channels.begin(), columns_.channels.end(), [&](const Source& source) {
    if (!is_angle(source.quantity)) return false;
    const std::vector<double>& values = run_.joints[source.joint.value_or(0)][source.quantity];
    const double next = row < values.size() ? values[row] : cell(source).value_or(values[row - 1]);
    return std::abs(next - values[row - 1]) > kQuarterTurn_rad;
  });
}

/// Nothing of a motion is seen in such steps; of milliseconds under a name in s they are usual.
void LogReader::warn_of_long_steps() {
  if (*median_s_ < kLongStep_s || warns_of_steps_) return;
  warns_of_steps_ = true;
  findings_.push_back(
      {Weight::kWarning,
       fmt::format("the median step of run \"{}\" is {:.4g} s: the times look like ms; {}",
                   run_.name, *median_s_,
                   remedy_by_unit({0, Quantity::kTime}, rig_, *io::find_unit("ms")))});
}

void LogReader::end_run() {
  if (at_once_ > 1) {
    if (stamp_step_s_ == 0.0) {
      throw io::SpecError(
          {{csv_->file(), "",
            fmt::format("time stands still at {} s in run \"{}\"", stamp_s_, run_.name)}});
    }
    spread(stamp_s_ + stamp_step_s_);
  }
  if (!median_s_ && run_.time_s.size() > 1) learn_step();
  hand_over(0, run_.masked.size());
  run_ = {};
  gap_.reset();
  at_once_ = 0;
  stamp_step_s_ = 0.0;
  is_in_run_ = false;
}

void LogReader::hand_over(std::size_t begin, std::size_t end) {
  const bool is_whole = begin == 0 && end == run_.masked.size();
  const std::string name = run_.name;
  Run run = is_whole ? std::move(run_) : part_of(run_, begin, end);
  for (std::uint8_t& each : run.masked) each = each != 0;
  run.continues = continues_;
  continues_ = false;
  ready_.push_back({std::move(run), file_, gap_});
  if (!is_whole) return;
  empty_cells_.forget_rows();
  run_ = {};
  run_.name = name;
  run_.joints.assign(rig_.joints.size(), {});
}

}  // namespace torquewright::identification
