// SPDX-License-Identifier: Apache-2.0
#include "identification/residual_traces.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kPieces = 4;  ///< Of a run that is cut.

/// The columns that a fit uses, each with its weight.
struct WeightedColumns {
  std::vector<const Column*> columns;
  std::vector<double> weights;
};

WeightedColumns columns_of(const Equation& equation, const Fit& fit) {
  WeightedColumns used;
  for (std::size_t j = 0; j < fit.coefficients.size(); ++j) {
    for (const auto& term : fit.coefficients[j].terms) {
      used.columns.push_back(&equation.dictionary.columns[term.column]);
      used.weights.push_back(term.weight * fit.values[static_cast<Eigen::Index>(j)]);
    }
  }
  return used;
}

ResidualTrace trace_of(const Signals& stretch, const WeightedColumns& used, const Target& target,
                       const BandOptions& band) {
  const BandRows rows = band_rows(stretch, used.columns, target, band);
  ResidualTrace trace;
  trace.signals = &stretch;
  trace.index = rows.index;
  const auto target_column = static_cast<Eigen::Index>(used.columns.size());
  for (Eigen::Index k = 0; k < rows.values.rows(); ++k) {
    double left = rows.values(k, target_column);
    for (std::size_t c = 0; c < used.columns.size(); ++c) {
      left -= used.weights[c] * rows.values(k, static_cast<Eigen::Index>(c));
    }
    trace.value.push_back(left);
  }
  return trace;
}

/// Equal pieces, each a fold of its own from `next_fold` on.
void append_pieces(const ResidualTrace& trace, std::size_t& next_fold,
                   std::vector<ResidualTrace>& traces) {
  const std::size_t n = trace.value.size();
  for (std::size_t p = 0; p < kPieces; ++p) {
    const auto begin = static_cast<std::ptrdiff_t>(p * n / kPieces);
    const auto end = static_cast<std::ptrdiff_t>((p + 1) * n / kPieces);
    ResidualTrace piece;
    piece.signals = trace.signals;
    piece.fold = next_fold++;
    piece.index.assign(trace.index.begin() + begin, trace.index.begin() + end);
    piece.value.assign(trace.value.begin() + begin, trace.value.begin() + end);
    traces.push_back(std::move(piece));
  }
}

}  // namespace

std::vector<ResidualTrace> residual_traces(const Equation& equation, const Fit& fit,
                                           const std::vector<Signals>& signals, const Folds& folds,
                                           const BandOptions& band) {
  const WeightedColumns used = columns_of(equation, fit);
  std::vector<ResidualTrace> traces;
  std::size_t next_fold = 0;
  for (const Signals& stretch : signals) {
    if (folds.of_run[stretch.run] == Fitter::kNoFold) continue;
    ResidualTrace trace = trace_of(stretch, used, equation.target, band);
    trace.fold = folds.of_run[stretch.run];
    if (folds.cut_runs) {
      append_pieces(trace, next_fold, traces);
    } else {
      traces.push_back(std::move(trace));
    }
  }
  return traces;
}

}  // namespace torquewright::identification
