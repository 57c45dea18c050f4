// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "hopper/planning/objectives/costs.hpp"
#include "hopper/planning/objectives/drives_at.hpp"
#include "hopper/planning/objectives/every_objective.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kTypical = 0.15;  // the most that the hopper's flip keeps

/// How far an instant is from the limits of each drive's region, over its greatest torque.
/// Variables: DrivesAt. Rows: by drive the region's rows, then the greatest torque either way.
struct DistanceLaw {
  DrivesAt drives;

  std::size_t size() const {
    std::size_t rows = 0;
    for (const DriveRegion& region : drives.regions()) rows += region.rows() + 2;
    return rows;
  }

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    const DriveStateOf<T> state = drives.state<T>(x);
    Eigen::Index row = 0;
    for (Eigen::Index i = 0; i < drives.drives(); ++i) {
      const DriveRegion& region = drives.regions()[static_cast<std::size_t>(i)];
      const double per_Nm = 1.0 / region.greatest_torque_Nm();
      const std::span<T> own(rows.data() + row, region.rows());
      region.rows<T>(state.torque_Nm[i], state.speed_rad_s[i], state.bus_V[i], own);
      for (T& one : own) one = one * -per_Nm;
      row += static_cast<Eigen::Index>(own.size());
      rows[row++] = 1.0 - per_Nm * state.torque_Nm[i];
      rows[row++] = 1.0 + per_Nm * state.torque_Nm[i];
    }
  }
};

/// Distances less the least. Variables: DrivesAt, the least.
struct LeastLaw {
  DistanceLaw distance;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    distance(dynamics::VectorX<T>(x.head(x.size() - 1)), rows);
    for (Eigen::Index i = 0; i < rows.size(); ++i) rows[i] = rows[i] - x[x.size() - 1];
  }
};

struct NegativeLaw {
  double factor;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    rows[0] = -factor * x[0];
  }
};

void add(const PlanModel& model, const PlanOptions&, double weight, FlipProgram& program) {
  const DrivesAt drives(model);
  const DistanceLaw distance{drives};
  const int least = program.program.add({"least margin", {0.0}, {{-1.0, 1.0}}, {kTypical}});
  for (const PhaseVariables& phase : program.phases) {
    for (const PointVariables& point : phase.points) {
      program.program.add_rows(
          jet_rows("least margin to the region", in_order({drives.numbers(point), {least}}),
                   std::vector<optimization::Bounds>(distance.size(), {0.0, kInfinite}),
                   std::vector<double>(distance.size(), 1.0), LeastLaw{distance}));
    }
  }
  program.program.add_cost(
      jet_cost("region margin", {least}, NegativeLaw{weight * kTypicalCost / kTypical}));
}

double value(const PlanModel& model, const PlanOptions&, const FlipProgram& program,
             const std::vector<double>& values) {
  const DistanceLaw distance{DrivesAt(model)};
  double least = kInfinite;
  for (const PhaseVariables& phase : program.phases) {
    for (const PointVariables& point : phase.points) {
      const std::vector<int> numbers = distance.drives.numbers(point);
      Eigen::VectorXd x(distance.drives.count());
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        x[static_cast<Eigen::Index>(i)] = values[static_cast<std::size_t>(numbers[i])];
      }
      Eigen::VectorXd rows(static_cast<Eigen::Index>(distance.size()));
      distance(x, rows);
      least = std::min(least, rows.minCoeff());
    }
  }
  return least;
}

}  // namespace

const Objective objectives::region_margin{
    "region_margin",
    "greatest least distance of any drive at any instant from the limits of its region, as a share "
    "of its greatest torque, beyond the margins that a plan keeps anyway",
    "", add, value};

}  // namespace torquewright::hopper
