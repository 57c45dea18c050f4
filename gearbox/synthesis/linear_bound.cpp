// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis/linear_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace torquewright::gearbox {
namespace {

/// Mass of each layer, centre distance, both shifts; the last three from the middle of the box.
constexpr std::size_t kRows = 5;
using Vector = std::array<double, kRows>;

/// An inequality column . y >= cost of the programme: least y_0 + y_1.
struct Column {
  Vector column{};
  double cost = 0.0;
};

/// By place in the columns.
using Weights = std::vector<std::pair<std::size_t, double>>;

double dot(const Vector& a, const Vector& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kRows; ++i) sum += a[i] * b[i];
  return sum;
}

/// The dual: most cost . weights with weights >= 0 and the sum of weighted columns (1, 1, 0, 0, 0),
/// by the simplex method. Every basis that it passes is a bound.
class Dual {
 public:
  Dual(std::vector<Column> columns, std::array<std::size_t, kRows> basis)
      : columns_(std::move(columns)), basis_(basis) {}

  /// Weights of the last basis.
  Weights solve() {
    if (!invert()) return {};
    constexpr int kMostSteps = 40;
    for (int step = 0; step < kMostSteps && improve(); ++step) {
    }
    Weights weights;
    for (std::size_t i = 0; i < kRows; ++i) weights.emplace_back(basis_[i], weight(i));
    return weights;
  }

  /// Where no point satisfies all, weights that say so; else none.
  const Weights& ray() const { return ray_; }

  /// The point at which the basis holds with equality.
  Vector point() const {
    Vector y{};
    for (std::size_t i = 0; i < kRows; ++i) {
      for (std::size_t k = 0; k < kRows; ++k) y[k] += columns_[basis_[i]].cost * inverse_[i][k];
    }
    return y;
  }

 private:
  /// Of the basis' columns side by side: row i of the inverse belongs to basis_[i].
  bool invert() {
    std::array<std::array<double, 2 * kRows>, kRows> work{};
    for (std::size_t r = 0; r < kRows; ++r) {
      for (std::size_t i = 0; i < kRows; ++i) work[r][i] = columns_[basis_[i]].column[r];
      work[r][kRows + r] = 1.0;
    }
    for (std::size_t c = 0; c < kRows; ++c) {
      std::size_t best = c;
      for (std::size_t r = c; r < kRows; ++r) {
        if (std::abs(work[r][c]) > std::abs(work[best][c])) best = r;
      }
      if (!(std::abs(work[best][c]) > 1e-300)) return false;
      std::swap(work[c], work[best]);
      const double pivot = work[c][c];
      for (double& entry : work[c]) entry /= pivot;
      for (std::size_t r = 0; r < kRows; ++r) {
        if (r == c || work[r][c] == 0.0) continue;
        const double factor = work[r][c];
        for (std::size_t k = 0; k < 2 * kRows; ++k) work[r][k] -= factor * work[c][k];
      }
    }
    for (std::size_t i = 0; i < kRows; ++i) {
      for (std::size_t k = 0; k < kRows; ++k) inverse_[i][k] = work[i][kRows + k];
    }
    return true;
  }

  double weight(std::size_t i) const { return inverse_[i][0] + inverse_[i][1]; }

  /// False: nothing is left to gain.
  bool improve() {
    const Vector y = point();
    std::size_t entering = columns_.size();
    double most = 0.0;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      const Column& column = columns_[j];
      const double scale = std::abs(column.cost) + std::abs(y[0]) + std::abs(y[1]);
      const double violation = column.cost - dot(column.column, y);
      if (violation > 1e-10 * scale && violation > most) {
        most = violation;
        entering = j;
      }
    }
    if (entering == columns_.size()) return false;
    Vector change{};
    for (std::size_t i = 0; i < kRows; ++i) {
      change[i] = dot(inverse_[i], columns_[entering].column);
    }
    std::size_t leaving = kRows;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < kRows; ++i) {
      if (!(change[i] > 1e-12)) continue;
      const double ratio = std::max(0.0, weight(i)) / change[i];
      if (ratio < least) {
        least = ratio;
        leaving = i;
      }
    }
    if (leaving == kRows) {  // No point of the box satisfies all.
      ray_.emplace_back(entering, 1.0);
      for (std::size_t i = 0; i < kRows; ++i) ray_.emplace_back(basis_[i], -change[i]);
      return false;
    }
    const double pivot = change[leaving];
    for (double& entry : inverse_[leaving]) entry /= pivot;
    for (std::size_t i = 0; i < kRows; ++i) {
      if (i == leaving || change[i] == 0.0) continue;
      for (std::size_t k = 0; k < kRows; ++k) inverse_[i][k] -= change[i] * inverse_[leaving][k];
    }
    basis_[leaving] = entering;
    return true;
  }

  std::vector<Column> columns_;
  std::array<std::size_t, kRows> basis_;
  std::array<Vector, kRows> inverse_{};
  Weights ray_;
};

/// What the columns, weighted, prove: their sum is y_0 + y_1 at most, up to what rounding has left
/// of the other rows, which the box bounds.
double proved(const std::vector<Column>& columns, const Vector& reach, const Weights& weights) {
  Vector rest{};
  double sum = 0.0, size = 0.0;
  for (const auto& [place, weight] : weights) {
    if (!(weight > 0.0)) continue;
    const Column& column = columns[place];
    sum += weight * column.cost;
    size += weight * std::abs(column.cost);
    for (std::size_t i = 0; i < kRows; ++i) rest[i] += weight * column.column[i];
  }
  for (std::size_t i = 2; i < kRows; ++i) {
    sum -= std::abs(rest[i]) * reach[i];
    size += std::abs(rest[i]) * reach[i];
  }
  sum -= 1e-12 * size;
  // rest_0 y_0 + rest_1 y_1 >= sum, and masses are not negative.
  const double scale = std::max(rest[0], rest[1]);
  if (!(sum > 0.0)) return 0.0;
  return scale > 0.0 ? sum / scale : std::numeric_limits<double>::infinity();
}

void add_layer(const LayerForms& forms, std::size_t layer, const std::array<double, 3>& middle,
               std::vector<Column>& columns) {
  const std::array<double, kInnerVariables> moved{middle[0] - forms.middle[0],
                                                  middle[layer + 1] - forms.middle[1]};
  const auto constant = [&](const LinearForm& form) {
    return form.constant + form.slopes[0] * moved[0] + form.slopes[1] * moved[1];
  };
  for (const LinearForm& mass : forms.masses) {
    Column column;
    column.column[layer] = 1.0;
    column.column[2] = -mass.slopes[0];
    column.column[3 + layer] = -mass.slopes[1];
    column.cost = constant(mass);
    columns.push_back(column);
  }
  for (const LinearForm& margin : forms.margins) {
    Column column;
    column.column[2] = margin.slopes[0];
    column.column[3 + layer] = margin.slopes[1];
    column.cost = -constant(margin);
    columns.push_back(column);
  }
}

LinearForm linear(const Slope& range, const InnerBox& offsets, double sign) {
  LinearForm form{sign < 0.0 ? range.center.lower : range.center.upper, {}};
  double slack = 1e-12 * std::abs(form.constant);
  for (std::size_t i = 0; i < kInnerVariables; ++i) {
    const Interval& slope = range.slopes[i];
    const double middle = slope.middle();
    const double half = std::max(slope.upper - middle, middle - slope.lower);
    const double reach = std::max(std::abs(offsets[i].lower), std::abs(offsets[i].upper));
    form.slopes[i] = middle;
    slack += (half + 1e-12 * std::abs(middle)) * reach;
  }
  form.constant += sign * slack;
  return form;
}

}  // namespace

LinearForm linear_below(const Slope& range, const InnerBox& offsets) {
  return linear(range, offsets, -1.0);
}

LinearForm linear_above(const Slope& range, const InnerBox& offsets) {
  return linear(range, offsets, 1.0);
}

LinearBound linear_bound(const std::array<const LayerForms*, 2>& layers,
                         const std::vector<JointForm>& joint, const std::array<Interval, 3>& box) {
  std::array<double, 3> middle{};
  for (std::size_t i = 0; i < 3; ++i) middle[i] = box[i].middle();
  std::vector<Column> columns;
  std::array<std::size_t, kRows> basis{};
  for (const std::size_t layer : {0U, 1U}) {
    if (layers[layer]->masses.empty()) return {0.0, middle};
    basis[layer] = columns.size();
    const std::size_t from = columns.size();
    add_layer(*layers[layer], layer, middle, columns);
    for (std::size_t j = from; j < from + layers[layer]->masses.size(); ++j) {
      if (columns[j].cost > columns[basis[layer]].cost) basis[layer] = j;
    }
  }
  for (const JointForm& form : joint) {
    Column column;
    column.cost = -form.constant;
    for (std::size_t i = 0; i < 3; ++i) {
      column.column[2 + i] = form.slopes[i];
      column.cost -= form.slopes[i] * middle[i];
    }
    columns.push_back(column);
  }
  Vector reach{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double half = std::max(box[i].upper - middle[i], middle[i] - box[i].lower);
    reach[2 + i] = half;
    // A bound's weight has to take up what the masses' slopes leave: of that sign.
    const double left = columns[basis[0]].column[2 + i] + columns[basis[1]].column[2 + i];
    for (const double sign : {1.0, -1.0}) {
      Column column;
      column.column[2 + i] = sign;
      column.cost = -half;
      if ((left > 0.0) == (sign < 0.0)) basis[2 + i] = columns.size();
      columns.push_back(column);
    }
  }
  Dual dual(columns, basis);
  const Weights weights = dual.solve();
  LinearBound bound{std::max(proved(columns, reach, weights), proved(columns, reach, dual.ray())),
                    middle};
  const Vector place = dual.point();
  for (std::size_t i = 0; i < 3; ++i) {
    bound.place[i] = std::clamp(middle[i] + place[2 + i], box[i].lower, box[i].upper);
  }
  return bound;
}

}  // namespace torquewright::gearbox
