// SPDX-License-Identifier: Apache-2.0
#include "optimization/expressions/formula.hpp"

#include <unordered_map>

#include "optimization/expressions/apply.hpp"

namespace torquewright::optimization {

Formula::Formula(const Expression& expression) {
  std::unordered_map<const ExpressionNode*, std::size_t> step_of;
  const auto lay_out = [&](const auto& self, const Expression& part) -> std::size_t {
    const ExpressionNode& node = part.node();
    if (const auto known = step_of.find(&node); known != step_of.end()) return known->second;
    Step step{node.operation, node.variable, 0, 0};
    if (node.operation == Operation::kConstant) {
      step.constant = constants_.size();
      constants_.push_back(node.value.outward());
      precise_constants_.push_back(node.value);
    } else if (node.operation != Operation::kVariable) {
      step.first = self(self, node.arguments.front());
      step.second = node.arguments.size() > 1 ? self(self, node.arguments.back()) : step.first;
    }
    steps_.push_back(step);
    return step_of[&node] = steps_.size() - 1;
  };
  lay_out(lay_out, expression);
}

template <class Number, class Variable, class Constant>
Number Formula::evaluate(std::vector<Number>& storage, Variable variable, Constant constant) const {
  storage.resize(std::max(storage.size(), steps_.size()));
  // What belongs to a thread would be looked up anew at every step.
  const std::span<Number> values = storage;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    if (step.operation == Operation::kConstant) {
      values[i] = constant(step.constant);
    } else if (step.operation == Operation::kVariable) {
      values[i] = variable(step.first);
    } else {
      values[i] = apply<Number>(step.operation, values[step.first], values[step.second]);
    }
  }
  return values[steps_.size() - 1];
}

Interval Formula::over(std::span<const Interval> box) const {
  thread_local std::vector<Interval> values;
  return evaluate(
      values, [&](std::size_t i) { return box[i]; }, [&](std::size_t i) { return constants_[i]; });
}

Interval Formula::at(std::span<const std::int64_t> point) const {
  thread_local std::vector<Interval> values;
  return evaluate(
      values, [&](std::size_t i) { return Interval(static_cast<double>(point[i])); },
      [&](std::size_t i) { return constants_[i]; });
}

PreciseInterval Formula::precisely_at(std::span<const std::int64_t> point) const {
  std::vector<PreciseInterval> values;
  return evaluate(
      values, [&](std::size_t i) { return PreciseInterval(static_cast<double>(point[i])); },
      [&](std::size_t i) { return precise_constants_[i]; });
}

}  // namespace torquewright::optimization
