// SPDX-License-Identifier: Apache-2.0
#include "optimization/nonlinear/assembly.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::optimization {
namespace {

using LocalVector = Eigen::Map<Eigen::VectorXd>;
using LocalMatrix = Eigen::Map<Eigen::MatrixXd>;

bool are_finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

std::size_t size_of(const Rows& rows) { return rows.bounds().size(); }
std::size_t width_of(const Rows& rows) { return rows.variables().size(); }

}  // namespace

Assembly::Assembly(const Program& program) : program_(program) {
  for (const auto& rows : program.rows()) {
    rows_.push_back({rows.get(), here_.rows.size(), jacobian_places_.size(), {}});
    place_jacobian(rows_.back());
    here_.rows.resize(here_.rows.size() + size_of(*rows));
  }
  for (const auto& cost : program.costs()) {
    costs_.push_back({cost.get(), 0, 0, {}});
    const double scale = cost->scales().front();
    objective_scale_ = costs_.size() == 1 ? scale : std::max(objective_scale_, scale);
  }
  place_hessian();
  here_.values.resize(program.starts().size());
  jacobian_.resize(jacobian_places_.size());
  for (const Block& block : rows_) make_room(*block.rows);
  for (const Block& block : costs_) make_room(*block.rows);
}

void Assembly::make_room(const Rows& rows) {
  const auto grow = [](std::vector<double>& room, std::size_t size) {
    room.resize(std::max(room.size(), size));
  };
  grow(local_values_, width_of(rows));
  grow(local_rows_, size_of(rows));
  grow(local_multipliers_, size_of(rows));
  grow(local_matrix_, width_of(rows) * width_of(rows));
}

void Assembly::place_jacobian(const Block& block) {
  for (const int variable : block.rows->variables()) {
    for (std::size_t i = 0; i < size_of(*block.rows); ++i) {
      jacobian_places_.push_back({static_cast<int>(block.first_row + i), variable});
    }
  }
}

void Assembly::place_hessian() {
  const auto for_each_place = [](const Block& block, const auto& visit) {
    if (block.rows->is_affine()) return;
    const std::vector<int>& variables = block.rows->variables();
    for (std::size_t column = 0; column < variables.size(); ++column) {
      for (std::size_t row = column; row < variables.size(); ++row) {
        const auto [low, high] = std::minmax(variables[row], variables[column]);
        visit(Place{high, low});
      }
    }
  };
  const auto goes_before = [](const Place& a, const Place& b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  };
  const auto collect = [this](const Place& place) { hessian_places_.push_back(place); };
  for (const Block& block : rows_) for_each_place(block, collect);
  for (const Block& block : costs_) for_each_place(block, collect);
  std::sort(hessian_places_.begin(), hessian_places_.end(), goes_before);
  hessian_places_.erase(std::unique(hessian_places_.begin(), hessian_places_.end()),
                        hessian_places_.end());
  const auto find_entries = [&](Block& block) {
    for_each_place(block, [&](const Place& place) {
      const auto found =
          std::lower_bound(hessian_places_.begin(), hessian_places_.end(), place, goes_before);
      block.hessian.push_back(static_cast<std::size_t>(found - hessian_places_.begin()));
    });
  };
  for (Block& block : rows_) find_entries(block);
  for (Block& block : costs_) find_entries(block);
}

const Evaluation& Assembly::at(std::span<const double> scaled) {
  move_to(scaled);
  if (!is_evaluated_) evaluate();
  return here_;
}

bool Assembly::gradient(std::span<const double> scaled, std::span<double> slopes) {
  move_to(scaled);
  std::fill(slopes.begin(), slopes.end(), 0.0);
  for (const Block& block : costs_) {
    gather(*block.rows);
    LocalMatrix local(local_matrix_.data(), 1, block.rows->width());
    block.rows->slopes(LocalVector(local_values_.data(), block.rows->width()), local);
    const double* slope = local.data();
    for (const int variable : block.rows->variables()) {
      const auto place = static_cast<std::size_t>(variable);
      slopes[place] += *slope++ * (program_.scales()[place] / objective_scale_);
    }
  }
  return are_finite(slopes);
}

bool Assembly::jacobian(std::span<const double> scaled, std::span<double> entries) {
  move_to(scaled);
  for (Block& block : rows_) {
    if (!block.is_constant) scatter_slopes(block);
  }
  std::copy(jacobian_.begin(), jacobian_.end(), entries.begin());
  return are_finite(entries);
}

bool Assembly::hessian(std::span<const double> scaled, double objective_factor,
                       std::span<const double> multipliers, std::span<double> entries) {
  move_to(scaled);
  std::fill(entries.begin(), entries.end(), 0.0);
  for (const Block& block : rows_) {
    bool has_multipliers = false;
    for (std::size_t i = 0; i < size_of(*block.rows); ++i) {
      local_multipliers_[i] = multipliers[block.first_row + i] / block.rows->scales()[i];
      has_multipliers = has_multipliers || local_multipliers_[i] != 0.0;
    }
    if (has_multipliers) scatter_curvatures(block, entries);
  }
  if (objective_factor == 0.0) return are_finite(entries);
  for (const Block& block : costs_) {
    local_multipliers_[0] = objective_factor / objective_scale_;
    scatter_curvatures(block, entries);
  }
  return are_finite(entries);
}

void Assembly::move_to(std::span<const double> scaled) {
  if (std::equal(scaled.begin(), scaled.end(), scaled_.begin(), scaled_.end())) return;
  scaled_.assign(scaled.begin(), scaled.end());
  is_evaluated_ = false;
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    const auto [lower, upper] = program_.bounds()[i];
    here_.values[i] = std::clamp(scaled[i] * program_.scales()[i], lower, upper);
  }
}

void Assembly::evaluate() {
  for (const Block& block : rows_) {
    gather(*block.rows);
    LocalVector out(here_.rows.data() + block.first_row, block.rows->size());
    block.rows->values(LocalVector(local_values_.data(), block.rows->width()), out);
    for (std::size_t i = 0; i < size_of(*block.rows); ++i) {
      here_.rows[block.first_row + i] /= block.rows->scales()[i];
    }
  }
  here_.objective = 0.0;
  for (const Block& block : costs_) {
    gather(*block.rows);
    LocalVector out(local_rows_.data(), 1);
    block.rows->values(LocalVector(local_values_.data(), block.rows->width()), out);
    here_.objective += out(0);
  }
  here_.is_finite = std::isfinite(here_.objective) && are_finite(here_.rows);
  here_.largest_violation = largest_violation(program_, here_.rows);
  is_evaluated_ = true;
}

void Assembly::gather(const Rows& rows) {
  double* next = local_values_.data();
  for (const int variable : rows.variables()) {
    *next++ = here_.values[static_cast<std::size_t>(variable)];
  }
}

void Assembly::scatter_slopes(Block& block) {
  const Rows& rows = *block.rows;
  gather(rows);
  LocalMatrix local(jacobian_.data() + block.first_entry, rows.size(), rows.width());
  rows.slopes(LocalVector(local_values_.data(), rows.width()), local);
  double* entry = local.data();
  for (const int variable : rows.variables()) {
    const double scale = program_.scales()[static_cast<std::size_t>(variable)];
    for (const double row_scale : rows.scales()) *entry++ *= scale / row_scale;
  }
  block.is_constant = rows.is_affine();
}

void Assembly::scatter_curvatures(const Block& block, std::span<double> entries) {
  const Rows& rows = *block.rows;
  if (rows.is_affine()) return;
  gather(rows);
  LocalMatrix local(local_matrix_.data(), rows.width(), rows.width());
  rows.curvatures(LocalVector(local_values_.data(), rows.width()),
                  LocalVector(local_multipliers_.data(), rows.size()), local);
  const std::vector<int>& variables = rows.variables();
  auto entry = block.hessian.begin();
  for (std::size_t j = 0; j < variables.size(); ++j) {
    const double column_scale = program_.scales()[static_cast<std::size_t>(variables[j])];
    for (std::size_t i = j; i < variables.size(); ++i) {
      const double row_scale = program_.scales()[static_cast<std::size_t>(variables[i])];
      entries[*entry++] += local(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) *
                           row_scale * column_scale;
    }
  }
}

double largest_violation(const Program& program, std::span<const double> rows) {
  double largest = 0.0;
  std::size_t next = 0;
  for (const auto& block : program.rows()) {
    for (std::size_t i = 0; i < size_of(*block); ++i, ++next) {
      const auto [lower, upper] = block->bounds()[i];
      const double scale = block->scales()[i];
      largest = std::max({largest, lower / scale - rows[next], rows[next] - upper / scale});
    }
  }
  return largest;
}

}  // namespace torquewright::optimization
