// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>

#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/gear_laws.hpp"
#include "hopper/planning/plane/affine_rows.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using optimization::Bounds;

constexpr double kMost = 100.0;   // of limits; no plan is near it
constexpr double kTypical = 0.5;  // of a limit

/// Weights of instants in the mean over a window: from its one end on, ends and middles of
/// intervals of these lengths; each interval's parabola, integrated.
std::vector<double> mean_weights(const std::vector<double>& lengths_s, double window_s) {
  std::vector<double> weights(1, 0.0);
  double from_s = 0.0;
  for (const double length_s : lengths_s) {
    if (from_s >= window_s) break;
    const double s = std::min(1.0, (window_s - from_s) / length_s);
    const double of_window = length_s / window_s;
    weights.back() += of_window * (s - 1.5 * s * s + 2.0 / 3.0 * s * s * s);
    weights.push_back(of_window * (2.0 * s * s - 4.0 / 3.0 * s * s * s));
    weights.push_back(of_window * (-0.5 * s * s + 2.0 / 3.0 * s * s * s));
    from_s += length_s;
  }
  return weights;
}

/// Of a phase's intervals, at the guess's duration.
std::vector<double> lengths_s(const Site& site, std::size_t phase,
                              const optimization::Program& program) {
  const std::vector<double>& knots = site.mesh[phase].knots;
  const double duration_s = program.starts()[static_cast<std::size_t>(site.phases[phase].duration)];
  std::vector<double> out;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    out.push_back((knots[i + 1] - knots[i]) * duration_s);
  }
  return out;
}

/// Variables: by drive, its gears' load at an instant less the variable that stands for it.
struct LoadIsLaw {
  GearLaw law;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    const auto d = static_cast<Index>(law.limits_Nm.size());
    law(dynamics::VectorX<T>(x.head(x.size() - d)), rows);
    rows -= x.tail(d);
  }
};

/// +-(mean of loads) + impulse's size. Columns: loads by instant, the impulse's.
Eigen::MatrixXd mean_rows(const std::vector<double>& weights) {
  const auto count = static_cast<Index>(weights.size());
  Eigen::MatrixXd rows = Eigen::MatrixXd::Ones(2, count + 1);
  rows.row(0).head(count) = Eigen::Map<const Eigen::RowVectorXd>(weights.data(), count);
  rows.row(1).head(count) = -rows.row(0).head(count);
  return rows;
}

int add_shares(const char* name, std::size_t drives, double least, optimization::Program& program) {
  return program.add({name, std::vector<double>(drives, 0.1),
                      std::vector<Bounds>(drives, {least, kMost}),
                      std::vector<double>(drives, kTypical)});
}

/// Rows of one impact, at the begin of the site's phase. The windows reach over the instants that
/// they cover at the guess's durations of the phases; those that lie on both sides of the impact
/// are between. Drives without a limit get no rows.
class LandingLoad {
 public:
  LandingLoad(const Site& site, optimization::Program& program)
      : site_(site),
        model_(site.model),
        window_s_(site.options.check.load_window_s),
        program_(program),
        limits_Nm_(site.model.gear_Nm) {
    // Loads are shares of the limits; a drive without one is measured by its greatest torque.
    for (std::size_t i = 0; i < limits_Nm_.size(); ++i) {
      if (!std::isfinite(limits_Nm_[i])) {
        limits_Nm_[i] = (*model_.regions)[i].greatest_torque_Nm();
      }
    }
  }

  void add() {
    impulse_ = add_shares("impulse loads", limits_Nm_.size(), 0.0, program_);
    const std::size_t rows = 2 * limits_Nm_.size();
    program_.add_rows(jet_rows(
        site_.named("rotors at the impact"),
        in_order({impulse_numbers(site_.variables(), site_.joints()),
                  numbers_from(impulse_, site_.drives())}),
        std::vector<Bounds>(rows, at_most(0.0)), std::vector<double>(rows, 1.0),
        MagnitudeLaw<ImpulseLaw>{{&model_, limits_Nm_, window_s_}, site_.drives(), false}));
    add_window(site_.variables().points, lengths_s(site_, site_.phase, program_));
    std::vector<PointVariables> before = site_.phases[site_.phase - 1].points;
    std::vector<double> lengths_before_s = lengths_s(site_, site_.phase - 1, program_);
    std::reverse(before.begin(), before.end());
    std::reverse(lengths_before_s.begin(), lengths_before_s.end());
    add_window(before, lengths_before_s);
  }

 private:
  /// From the impact on, to either side: points and the lengths between.
  void add_window(const std::vector<PointVariables>& points, const std::vector<double>& lengths) {
    const std::vector<double> weights = mean_weights(lengths, window_s_);
    std::vector<int> loads;
    for (std::size_t i = 0; i < weights.size(); ++i) loads.push_back(load_at(points[i]));
    for (std::size_t drive = 0; drive < limits_Nm_.size(); ++drive) {
      if (!std::isfinite(model_.gear_Nm[drive])) continue;
      std::vector<int> numbers;
      for (const int first : loads) numbers.push_back(first + static_cast<int>(drive));
      numbers.push_back(impulse_ + static_cast<int>(drive));
      program_.add_rows(std::make_unique<const AffineRows>(
          site_.named("mean gear load at the impact"), std::move(numbers),
          std::vector<Bounds>(2, at_most(1.0)), std::vector<double>(2, 1.0), mean_rows(weights)));
    }
  }

  /// Unknowns that stand for the gears' loads there, by drive.
  int load_at(const PointVariables& point) {
    const int load = add_shares("gear loads", limits_Nm_.size(), -kMost, program_);
    program_.add_rows(jet_rows(site_.named("gears beside the impact"),
                               in_order({gear_numbers(point, site_.joints(), site_.drives()),
                                         numbers_from(load, site_.drives())}),
                               std::vector<Bounds>(limits_Nm_.size(), equal_to(0.0)),
                               std::vector<double>(limits_Nm_.size(), 1.0),
                               LoadIsLaw{{&model_, limits_Nm_}}));
    return load;
  }

  const Site& site_;
  const PlanModel& model_;
  double window_s_;
  optimization::Program& program_;
  std::vector<double> limits_Nm_;
  int impulse_ = 0;
};

void add(const Site& site, optimization::Program& program) {
  Site at = site;
  for (at.phase = 0; at.phase < at.mesh.size(); ++at.phase) {
    if (at.variables().has_impact) LandingLoad(at, program).add();
  }
}

}  // namespace

// Beside an impact `hopper check` adds the size of the mean torque over the window and that of the
// rotor's impulse spread over it: docs/derivations/whole_body_check.md eq. (12).
const Constraint constraints::landing_load{
    "landing load", "",
    "what passes each drive's gears in the windows after and before an impact is within their "
    "limit, as shares of it",
    Where::kMotion, add};

}  // namespace torquewright::hopper
