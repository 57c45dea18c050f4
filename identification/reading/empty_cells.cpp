// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/empty_cells.hpp"

#include <fmt/format.h>

#include "identification/log/stretch.hpp"

namespace torquewright::identification {
namespace {

/// Whether the last number holds until the next.
bool holds(Quantity quantity) {
  return is_command(quantity) || quantity == Quantity::kBusVoltage ||
         quantity == Quantity::kWindingTemperature || quantity == Quantity::kCaseTemperature;
}

/// Whether numbers in these rows are near enough for a straight line between them.
bool is_bridged(const Run& run, std::size_t from, std::size_t to) {
  return !run.time_s.empty() && run.time_s[to] - run.time_s[from] <= kLongestBridge_s;
}

void draw_line(const Run& run, std::size_t from, std::size_t to, std::vector<double>& values) {
  const double span_s = run.time_s[to] - run.time_s[from];
  for (std::size_t row = from + 1; row < to; ++row) {
    const double share = (run.time_s[row] - run.time_s[from]) / span_s;
    values[row] = values[from] + share * (values[to] - values[from]);
  }
}

}  // namespace

void EmptyCells::begin_run(std::size_t columns) { columns_.assign(columns, {}); }

void EmptyCells::forget_rows() { columns_.assign(columns_.size(), {}); }

void EmptyCells::add(std::size_t column, const Channel& channel, bool has_number, Run& run) {
  State& state = columns_[column];
  Count& count = counts_[{channel.first, channel.quantity}];
  const std::size_t row = run.masked.size() - 1;
  const bool masks = !holds(channel.quantity) || !state.last;
  if (!has_number) {
    ++state.waiting;
    ++count.cells;
    if (masks) ++count.masked;
    if (masks && run.masked[row] < 255) ++run.masked[row];
    return;
  }
  const std::size_t begin = row - std::min(row, state.waiting);
  for (std::size_t joint = channel.first; joint < channel.end && state.waiting > 0; ++joint) {
    std::vector<double>& values = run.joints[joint][channel.quantity];
    if (!state.last)
      std::fill(values.begin() + static_cast<std::ptrdiff_t>(begin), values.end() - 1,
                values.back());
    if (state.last && masks && is_bridged(run, *state.last, row)) {
      draw_line(run, *state.last, row, values);
    }
  }
  if (state.last && state.waiting > 0 && masks && is_bridged(run, *state.last, row)) {
    for (std::size_t each = begin; each < row; ++each) {
      if (run.masked[each] > 0) --run.masked[each];
    }
    count.masked -= std::min(count.masked, state.waiting);
  }
  state = {row, 0};
}

std::vector<DataFinding> EmptyCells::findings(const Rig& rig) const {
  std::vector<DataFinding> findings;
  for (const auto& [key, count] : counts_) {
    if (count.cells == 0) continue;
    const std::string between =
        holds(key.second) ? "the last number holds" : "a straight line between numbers";
    findings.push_back(
        {count.masked > 0 ? Weight::kWarning : Weight::kNote,
         fmt::format("{}: {} empty cell{}: {}{}", describe(key, rig), count.cells,
                     count.cells == 1 ? "" : "s", between,
                     count.masked == 0 ? ""
                                       : fmt::format("; {} with no number within {:g} s are masked",
                                                     count.masked, kLongestBridge_s))});
  }
  return findings;
}

}  // namespace torquewright::identification
