// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/residual_structure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

using actuator::Instant;

struct Coordinate {
  const char* name;
  double (*value)(const Signals&, std::size_t);
};

double turn(double angle_rad) {
  return angle_rad - 2.0 * std::numbers::pi * std::floor(angle_rad / (2.0 * std::numbers::pi));
}

const Coordinate kCoordinates[] = {
    {"output_position_rad",
     [](const Signals& s, std::size_t i) { return s.at[i].output_angle_rad; }},
    {"motor_position_rad",
     [](const Signals& s, std::size_t i) { return turn(s.at[i].motor_angle_rad); }},
    {"electrical_angle",
     [](const Signals& s, std::size_t i) { return turn(s.pole_pairs * s.at[i].motor_angle_rad); }},
    {"output_velocity_rad_s", [](const Signals& s, std::size_t i) { return s.at[i].speed_rad_s; }},
    {"motor_current_A", [](const Signals& s, std::size_t i) { return s.at[i].current_A; }},
    {"load_torque_Nm", [](const Signals& s, std::size_t i) { return s.at[i].load_torque_Nm; }},
    {"winding_temperature_K",
     [](const Signals& s, std::size_t i) { return s.at[i].winding_temperature_K; }},
    {"time_s", [](const Signals& s, std::size_t i) { return s.time_s[i]; }},
    {"output_acceleration_rad_s2",
     [](const Signals& s, std::size_t i) { return s.at[i].acceleration_rad_s2; }},
    {"power_W",
     [](const Signals& s, std::size_t i) { return s.at[i].load_torque_Nm * s.at[i].speed_rad_s; }},
};

/// Values of a coordinate at a trace's rows, smoothed. The motor's angle jumps at a turn: left as
/// it is.
std::vector<double> values_of(const Coordinate& coordinate, const ResidualTrace& trace,
                              double smoothing_Hz) {
  const Signals& signals = *trace.signals;
  std::vector<double> all(signals.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = coordinate.value(signals, i);
  const std::string_view name = coordinate.name;
  const bool is_periodic = name == "motor_position_rad" || name == "electrical_angle";
  if (signals.step_s > 0.0 && !is_periodic) LowPass(smoothing_Hz, 1.0 / signals.step_s).apply(all);
  std::vector<double> values;
  for (const std::size_t i : trace.index) values.push_back(all[i]);
  return values;
}

/// Seconds since the direction last turned over.
std::vector<double> since_reversal(const ResidualTrace& trace) {
  const Signals& signals = *trace.signals;
  std::vector<double> since(signals.size(), 0.0);
  for (std::size_t i = 1; i < signals.size(); ++i) {
    const bool turned = signals.at[i].direction * signals.at[i - 1].direction <= 0.0;
    since[i] = turned ? 0.0 : since[i - 1] + signals.step_s;
  }
  std::vector<double> values;
  for (const std::size_t i : trace.index) values.push_back(since[i]);
  return values;
}

/// All rows of all traces, in a line.
struct TableRows {
  std::vector<double> residual, weight;
  std::vector<std::size_t> bin, fold;
  std::vector<std::pair<std::size_t, std::size_t>> runs;  ///< Begin and end of each trace.
};

/// Bins that hold equally many rows; the edges' centres.
std::vector<double> assign_bins(const std::vector<double>& coordinate, std::size_t bins,
                                std::vector<std::size_t>& bin) {
  std::vector<double> sorted = coordinate;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> edges, centres;
  for (std::size_t b = 1; b < bins; ++b) edges.push_back(sorted[b * sorted.size() / bins]);
  for (std::size_t b = 0; b < bins; ++b) {
    centres.push_back(
        sorted[std::min(sorted.size() - 1, (2 * b + 1) * sorted.size() / (2 * bins))]);
  }
  bin.resize(coordinate.size());
  for (std::size_t i = 0; i < coordinate.size(); ++i) {
    bin[i] = static_cast<std::size_t>(std::upper_bound(edges.begin(), edges.end(), coordinate[i]) -
                                      edges.begin());
  }
  return centres;
}

/// Held-out R^2 of the table, with residuals moved on by `shift` of each run's length.
double held_out_share(const TableRows& rows, std::size_t bins, std::size_t folds, double shift) {
  std::vector<double> top(folds * bins, 0.0), bottom(folds * bins, 0.0);
  std::vector<double> all_top(bins, 0.0), all_bottom(bins, 0.0);
  const auto each = [&](const auto& visit) {
    for (const auto& [begin, end] : rows.runs) {
      const std::size_t length = end - begin;
      const auto moved = static_cast<std::size_t>(shift * static_cast<double>(length));
      std::size_t from = begin + moved;
      for (std::size_t i = begin; i < end; ++i, ++from) {
        if (from >= end) from -= length;
        visit(i, rows.residual[from]);
      }
    }
  };
  each([&](std::size_t i, double residual) {
    const double w = rows.weight[i];
    top[rows.fold[i] * bins + rows.bin[i]] += w * residual;
    bottom[rows.fold[i] * bins + rows.bin[i]] += w * w;
    all_top[rows.bin[i]] += w * residual;
    all_bottom[rows.bin[i]] += w * w;
  });
  double before = 0.0, after = 0.0;
  each([&](std::size_t i, double residual) {
    const std::size_t cell = rows.fold[i] * bins + rows.bin[i];
    const double weight = all_bottom[rows.bin[i]] - bottom[cell];
    const double level = weight > 1e-9 ? (all_top[rows.bin[i]] - top[cell]) / weight : 0.0;
    const double left = residual - level * rows.weight[i];
    before += residual * residual;
    after += left * left;
  });
  return before > 0.0 ? 1.0 - after / before : 0.0;
}

}  // namespace

bool is_significant(const ResidualStructure& structure, const ResidualStructureOptions& options) {
  return structure.share > options.least_share && structure.chance <= options.most_chance;
}

std::vector<ResidualStructure> residual_structures(const std::vector<ResidualTrace>& traces,
                                                   const ResidualStructureOptions& options) {
  TableRows rows;
  std::size_t folds = 0;
  for (const ResidualTrace& trace : traces) {
    rows.runs.emplace_back(rows.residual.size(), rows.residual.size() + trace.value.size());
    rows.residual.insert(rows.residual.end(), trace.value.begin(), trace.value.end());
    rows.fold.insert(rows.fold.end(), trace.value.size(), trace.fold);
    folds = std::max(folds, trace.fold + 1);
  }
  std::vector<ResidualStructure> found;
  if (rows.residual.size() < 4 * options.bins || folds < 2) return found;
  std::vector<double> direction;
  for (const ResidualTrace& trace : traces) {
    for (const std::size_t i : trace.index) direction.push_back(trace.signals->at[i].direction);
  }
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> anywhere(0.1, 0.9);
  std::vector<double> shifts;
  for (std::size_t k = 0; k < options.shifts; ++k) shifts.push_back(anywhere(random));
  const auto test = [&](const char* name, const std::vector<double>& coordinate) {
    const auto [least, greatest] = std::minmax_element(coordinate.begin(), coordinate.end());
    if (!(*greatest > *least)) return;
    const std::vector<double> centres = assign_bins(coordinate, options.bins, rows.bin);
    for (const bool times_direction : {false, true}) {
      rows.weight = times_direction ? direction : std::vector<double>(direction.size(), 1.0);
      ResidualStructure structure{name, times_direction, 0.0, 1.0, centres, {}};
      structure.share = held_out_share(rows, options.bins, folds, 0.0);
      if (structure.share > options.least_share) {
        std::size_t as_good = 0;
        for (const double shift : shifts) {
          as_good += held_out_share(rows, options.bins, folds, shift) >= structure.share;
        }
        structure.chance =
            static_cast<double>(1 + as_good) / static_cast<double>(1 + shifts.size());
      }
      std::vector<double> top(options.bins, 0.0), bottom(options.bins, 0.0);
      for (std::size_t i = 0; i < rows.residual.size(); ++i) {
        top[rows.bin[i]] += rows.weight[i] * rows.residual[i];
        bottom[rows.bin[i]] += rows.weight[i] * rows.weight[i];
      }
      for (std::size_t b = 0; b < options.bins; ++b) {
        structure.level.push_back(bottom[b] > 1e-9 ? top[b] / bottom[b] : 0.0);
      }
      found.push_back(std::move(structure));
    }
  };
  for (const Coordinate& coordinate : kCoordinates) {
    std::vector<double> values;
    for (const ResidualTrace& trace : traces) {
      const std::vector<double> own = values_of(coordinate, trace, options.smoothing_Hz);
      values.insert(values.end(), own.begin(), own.end());
    }
    test(coordinate.name, values);
  }
  std::vector<double> since;
  for (const ResidualTrace& trace : traces) {
    const std::vector<double> own = since_reversal(trace);
    since.insert(since.end(), own.begin(), own.end());
  }
  test("time_since_reversal", since);
  std::stable_sort(
      found.begin(), found.end(),
      [](const ResidualStructure& a, const ResidualStructure& b) { return a.share > b.share; });
  return found;
}

}  // namespace torquewright::identification
