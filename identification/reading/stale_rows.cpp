// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/stale_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ranges>

#include "optimization/fit/quantile.hpp"

namespace torquewright::identification {
namespace {

constexpr double kOfThePace = 3.0;      ///< Most that the pace changes by within the rows.
constexpr double kLeastSteps = 3.0;     ///< Of the position's resolution: slower may be one of it.
constexpr double kRounding = 1e-9;      ///< Of a step: differences that are none;
constexpr double kRoundedDigits = 2.5;  ///< so are four roundings to the last digit.

constexpr std::size_t kLeastFresh = 30;
constexpr double kLeastPolled = 1.5;  ///< New words come this many times as slowly as rows.
/// Share of new words before which a row repeats the one before: at 1.5 rows a word it is half. A
/// joint at rest repeats its rows in one stretch, before few new words.
constexpr double kLeastRepeated = 0.4;
constexpr double kEvenPace = 0.5;  ///< Of the pace: what most of the new words keep to it.
constexpr double kMostEven = 0.8;
constexpr double kNextWord = 1.5;  ///< Of the pace: a repeat so long after is a word of its own.

bool repeats_the_one_before(const Run& run, std::size_t row) {
  return std::ranges::all_of(run.joints, [row](const Channels& channels) {
    return std::ranges::all_of(channels.of, [row](const std::vector<double>& values) {
      return values.empty() || values[row] == values[row - 1];
    });
  });
}

std::vector<std::uint8_t> fresh_rows(const Run& run) {
  std::vector<std::uint8_t> fresh(run.time_s.size(), 1);
  for (std::size_t row = 1; row < fresh.size(); ++row) {
    fresh[row] = repeats_the_one_before(run, row) ? 0 : 1;
  }
  return fresh;
}

/// Whether rows are repeated before the new words throughout, and not in a stretch of rest alone.
bool repeats_throughout(const std::vector<std::uint8_t>& fresh) {
  double words = 0.0, repeated = 0.0;
  for (std::size_t row = 1; row < fresh.size(); ++row) {
    if (fresh[row] == 0) continue;
    words += 1.0;
    repeated += fresh[row - 1] == 0 ? 1.0 : 0.0;
  }
  return repeated >= kLeastRepeated * words;
}

/// At which new words come; nothing where they do not come evenly, or as fast as rows do.
std::optional<double> pace_s(const std::vector<double>& fresh_s, double least_step_s) {
  if (fresh_s.size() < kLeastFresh) return std::nullopt;
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < fresh_s.size(); ++i) steps_s.push_back(fresh_s[i] - fresh_s[i - 1]);
  const double pace = optimization::median(steps_s);
  const auto even = std::ranges::count_if(
      steps_s, [pace](double step) { return std::abs(step - pace) <= kEvenPace * pace; });
  const bool is_even = static_cast<double>(even) >= kMostEven * static_cast<double>(steps_s.size());
  return is_even && pace >= kLeastPolled * least_step_s ? std::optional(pace) : std::nullopt;
}

/// The tenth of the steps: of rows, where what is new does not come with each.
double least_step_s(const std::vector<double>& time_s) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < time_s.size(); ++i) steps_s.push_back(time_s[i] - time_s[i - 1]);
  return optimization::lower_quantile(std::move(steps_s), 0.1);
}

void keep_rows(Run& run, const std::vector<std::size_t>& rows) {
  const auto keep = [&rows](auto& values) {
    if (values.empty()) return;
    for (std::size_t i = 0; i < rows.size(); ++i) values[i] = values[rows[i]];
    values.resize(rows.size());
  };
  keep(run.time_s);
  keep(run.masked);
  for (Channels& channels : run.joints) {
    for (std::vector<double>& values : channels.of) keep(values);
  }
}

/// Puts times on the line through them and their count of paces, where none is further from it than
/// the recorder's step, and so that pieces of a stretch stay in their order.
void even_out(std::vector<double>& time_s, double pace, double step_s) {
  if (2.0 * step_s >= pace) return;
  std::vector<double> count(time_s.size(), 0.0);
  double n = 0.0, sum_k = 0.0, sum_t = 0.0, sum_kk = 0.0, sum_kt = 0.0;
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    if (i > 0)
      count[i] = count[i - 1] + std::max(1.0, std::round((time_s[i] - time_s[i - 1]) / pace));
    const double t_s = time_s[i] - time_s.front();
    n += 1.0;
    sum_k += count[i];
    sum_t += t_s;
    sum_kk += count[i] * count[i];
    sum_kt += count[i] * t_s;
  }
  const double slope_s = (n * sum_kt - sum_k * sum_t) / (n * sum_kk - sum_k * sum_k);
  const double start_s = time_s.front() + (sum_t - slope_s * sum_k) / n;
  std::vector<double> even_s;
  for (const double k : count) even_s.push_back(start_s + slope_s * k);
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    if (std::abs(even_s[i] - time_s[i]) > step_s) return;
  }
  time_s = std::move(even_s);
}

}  // namespace

void Resolution::add(double step, double digit) {
  const double size = std::max(std::abs(step), std::abs(last_step_));
  const double rounding = std::max(kRoundedDigits * digit, kRounding * size);
  note(std::abs(step), rounding);
  note(std::abs(step - last_step_), rounding);
  last_step_ = step;
}

void Resolution::note(double difference, double rounding) {
  if (difference > rounding && (least_ == 0.0 || difference < least_)) least_ = difference;
}

bool are_stale(const Travel& travel, std::size_t repeats, double next_s, double next_position) {
  const std::size_t rows = travel.position.size();
  if (repeats == 0 || rows < repeats + 2) return false;
  const std::size_t held = rows - 1 - repeats;
  const double before = travel.position[held] - travel.position[held - 1];
  const double across = next_position - travel.position[held];
  const double least = kLeastSteps * travel.resolution;
  if (std::abs(before) < least || std::abs(across) < least || before * across <= 0.0) return false;
  const double pace_before = before / (travel.time_s[held] - travel.time_s[held - 1]);
  const double pace_across = across / (next_s - travel.time_s[held]);
  const double ratio = pace_across / pace_before;
  return ratio >= 1.0 / kOfThePace && ratio <= kOfThePace;
}

std::size_t drop_polled(Run& run) {
  if (run.time_s.size() < kLeastFresh) return 0;
  const std::vector<std::uint8_t> fresh = fresh_rows(run);
  if (!repeats_throughout(fresh)) return 0;
  std::vector<double> fresh_s;
  for (std::size_t row = 0; row < fresh.size(); ++row) {
    if (fresh[row] != 0) fresh_s.push_back(run.time_s[row]);
  }
  const double step_s = least_step_s(run.time_s);
  const std::optional<double> pace = pace_s(fresh_s, step_s);
  if (!pace) return 0;
  std::vector<std::size_t> kept;
  for (std::size_t row = 0; row < fresh.size(); ++row) {
    const bool is_next =
        fresh[row] != 0 || run.time_s[row] - run.time_s[kept.back()] >= kNextWord * *pace;
    if (is_next) kept.push_back(row);
  }
  const std::size_t dropped = fresh.size() - kept.size();
  if (dropped == 0) return 0;
  keep_rows(run, kept);
  even_out(run.time_s, *pace, step_s);
  return dropped;
}

}  // namespace torquewright::identification
