// SPDX-License-Identifier: Apache-2.0
#include "optimization/nonlinear/program.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace torquewright::optimization {
namespace {

[[noreturn]] void refuse(const std::string& name, std::size_t element, const std::string& why) {
  throw std::invalid_argument(name + "[" + std::to_string(element) + "]: " + why);
}

void require_sound(const std::string& name, const std::vector<Bounds>& bounds,
                   const std::vector<double>& scales) {
  if (bounds.size() != scales.size()) {
    throw std::invalid_argument(name + ": " + std::to_string(bounds.size()) + " bounds, " +
                                std::to_string(scales.size()) + " scales");
  }
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const auto [lower, upper] = bounds[i];
    // Written so that what is not a number fails.
    if (!(lower <= upper)) refuse(name, i, "its bounds are crossed or no numbers");
    if (lower == HUGE_VAL || upper == -HUGE_VAL) refuse(name, i, "no number lies in its bounds");
    if (!(scales[i] > 0.0) || !std::isfinite(scales[i])) {
      refuse(name, i, "its scale is not positive and finite");
    }
  }
}

void require_distinct(const std::string& name, std::vector<int> variables) {
  std::sort(variables.begin(), variables.end());
  const auto twice = std::adjacent_find(variables.begin(), variables.end());
  if (twice == variables.end()) return;
  throw std::invalid_argument(name + ": variable " + std::to_string(*twice) + " stands twice");
}

void require_known(const Rows* rows, int variable_count) {
  if (rows == nullptr) throw std::invalid_argument("rows that are none");
  for (std::size_t i = 0; i < rows->variables().size(); ++i) {
    const int variable = rows->variables()[i];
    if (variable >= 0 && variable < variable_count) continue;
    refuse(rows->name(), i, "the program has no variable " + std::to_string(variable));
  }
}

bool is_equation(const Bounds& bounds) { return bounds.lower == bounds.upper; }

}  // namespace

Rows::Rows(std::string name, std::vector<int> variables, std::vector<Bounds> bounds,
           std::vector<double> scales)
    : name_(std::move(name)),
      variables_(std::move(variables)),
      bounds_(std::move(bounds)),
      scales_(std::move(scales)) {
  require_sound(name_, bounds_, scales_);
  require_distinct(name_, variables_);
}

int Program::add(VariableSet variables) {
  const std::size_t count = variables.values.size();
  if (variables.bounds.size() != count) {
    throw std::invalid_argument(variables.name + ": " + std::to_string(count) + " values, " +
                                std::to_string(variables.bounds.size()) + " bounds");
  }
  require_sound(variables.name, variables.bounds, variables.scales);
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(variables.values[i])) refuse(variables.name, i, "its value is not finite");
  }
  const int first = variable_count();
  starts_.insert(starts_.end(), variables.values.begin(), variables.values.end());
  bounds_.insert(bounds_.end(), variables.bounds.begin(), variables.bounds.end());
  scales_.insert(scales_.end(), variables.scales.begin(), variables.scales.end());
  sets_.push_back(std::move(variables));
  return first;
}

void Program::add_rows(std::unique_ptr<const Rows> rows) {
  require_known(rows.get(), variable_count());
  row_count_ += static_cast<int>(rows->size());
  rows_.push_back(std::move(rows));
}

void Program::add_cost(std::unique_ptr<const Rows> cost) {
  require_known(cost.get(), variable_count());
  if (cost->size() != 1) throw std::invalid_argument(cost->name() + ": a cost is one row");
  costs_.push_back(std::move(cost));
}

int Program::equation_count() const {
  std::ptrdiff_t count = 0;
  for (const auto& rows : rows_) count += std::ranges::count_if(rows->bounds(), is_equation);
  return static_cast<int>(count);
}

int Program::free_variable_count() const {
  return variable_count() - static_cast<int>(std::ranges::count_if(bounds_, is_equation));
}

Eigen::VectorXd gathered(const Rows& rows, const std::vector<double>& all) {
  Eigen::VectorXd local(rows.width());
  Eigen::Index next = 0;
  for (const int variable : rows.variables()) {
    local(next++) = all.at(static_cast<std::size_t>(variable));
  }
  return local;
}

}  // namespace torquewright::optimization
