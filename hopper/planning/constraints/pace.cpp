// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/affine_rows.hpp"

namespace torquewright::hopper {
namespace {

void add(const Site& site, optimization::Program& program) {
  if (!site.goal.hops_s) return;
  const std::size_t flights = flights_before(site.mesh, site.mesh.size());
  std::vector<int> durations;
  for (std::size_t p = 0; p < site.mesh.size(); ++p) {
    const std::size_t before = flights_before(site.mesh, p);
    const bool is_between = before > 0 && before < flights;
    const bool is_flight = site.mesh[p].stance.is_flight();
    if (site.options.has_alike_hops && is_flight && before + 1 == flights) break;
    if (is_between || is_flight) durations.push_back(site.phases[p].duration);
  }
  const auto count = static_cast<Eigen::Index>(durations.size());
  program.add_rows(std::make_unique<const AffineRows>(
      std::string(constraints::pace.name), std::move(durations),
      std::vector<optimization::Bounds>{equal_to(*site.goal.hops_s)},
      std::vector<double>{typical::kDuration_s}, Eigen::MatrixXd::Ones(1, count)));
}

}  // namespace

const Constraint constraints::pace{
    "pace", "s", "hops take as long as their strides at the speed that is asked for",
    Where::kMotion, add};

}  // namespace torquewright::hopper
