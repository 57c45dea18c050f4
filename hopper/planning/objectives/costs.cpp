// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/objectives/costs.hpp"

namespace torquewright::hopper {

void add_costs(Costs costs, FlipProgram& program) {
  for (auto& cost : costs) program.program.add_cost(std::move(cost));
}

double sum_of(const Costs& costs, const std::vector<double>& values) {
  double sum = 0.0;
  Eigen::VectorXd row(1);
  for (const auto& cost : costs) {
    cost->values(optimization::gathered(*cost, values), row);
    sum += row[0];
  }
  return sum;
}

}  // namespace torquewright::hopper
