// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/search/prices.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "hopper/planning/programme/plan_setup.hpp"
#include "hopper/planning/tasks/reserve.hpp"
#include "io/faults/spec_error.hpp"
#include "optimization/nonlinear/first_order.hpp"

namespace torquewright::hopper {
namespace {

// Of a share, a radian or a second. Rows are affine in what is priced, or nearly: rounding is what
// is left.
constexpr double kStep = 1e-5;

struct LongestPart {
  const char* name;
  double LongestPhases::*longest_s;
};
constexpr std::array<LongestPart, 5> kLongest{{
    {"longest first phase", &LongestPhases::first_s},
    {"longest push-off", &LongestPhases::push_off_s},
    {"longest flight", &LongestPhases::flight_s},
    {"longest landing", &LongestPhases::landing_s},
    {"longest last phase", &LongestPhases::last_s},
}};

/// The mesh as it is, with durations as the options bound them.
std::vector<MeshPhase> mesh_of(const SolvedProgram& solved, const PlanOptions& options) {
  std::vector<MeshPhase> mesh = solved.program.mesh;
  std::vector<Stance> stances;
  for (const MeshPhase& phase : mesh) stances.push_back(phase.stance);
  const std::vector<MeshPhase> first = first_mesh(stances, options);
  for (std::size_t p = 0; p < mesh.size(); ++p) mesh[p].duration_s = first[p].duration_s;
  return mesh;
}

/// Of the objective per unit of what `add` adds a step to. Empty where the program with a little
/// more of it has other rows, or where there is none.
std::optional<double> price(const Robot& robot, const PlanOptions& options,
                            const SolvedProgram& solved,
                            const std::function<void(PlanOptions&, double)>& add, double step) {
  PlanOptions more = options;
  add(more, step);
  try {
    const PlanModel model = plan_model(robot, more);
    const FlipProgram program =
        flip_program(model, mesh_of(solved, more), plan_goal(model, more), more, solved.guess);
    const auto change =
        optimization::first_order_change(solved.program.program, solved.solution, program.program);
    if (!change) return std::nullopt;
    return *change / step;
  } catch (const io::SpecError&) {
    return std::nullopt;  // it is as great as it can be
  }
}

std::optional<double> kept_of(double PlanMargins::*margin, const KeptMargins& kept) {
  double value = std::numeric_limits<double>::infinity();
  if (margin == &PlanMargins::friction) value = kept.friction;
  if (margin == &PlanMargins::center_of_pressure) value = kept.center_of_pressure;
  if (margin == &PlanMargins::position_rad) value = kept.position_rad;
  if (margin == &PlanMargins::flight_position_rad) value = kept.flight_position_rad;
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

BoundPrice price_of(const MarginPart& part, const Robot& robot, const PlanOptions& options,
                    const SolvedProgram& solved, const KeptMargins& kept) {
  const double margin = options.margins.*part.margin;
  const bool follows = part.per_reserve > 0.0 && options.reserve > 0.0 &&
                       margin == part.per_reserve * options.reserve;
  // Of joints' ranges the margin in flight is another part where it is no less: downwards the one
  // on the ground changes alone, and nothing is paid twice.
  const bool is_on_ground = part.margin == &PlanMargins::position_rad &&
                            options.margins.flight_position_rad >= options.margins.position_rad;
  const auto add = [&](PlanOptions& more, double step) { more.margins.*part.margin += step; };
  return {std::string(part.name),
          margin,
          std::string(part.unit),
          follows ? part.per_reserve : 0.0,
          price(robot, options, solved, add, is_on_ground ? -kStep : kStep),
          kept_of(part.margin, kept)};
}

}  // namespace

std::vector<BoundPrice> bound_prices(const Robot& robot, const PlanOptions& options,
                                     const SolvedProgram& solved, const KeptMargins& kept) {
  std::vector<BoundPrice> prices;
  for (const MarginPart& part : margin_parts()) {
    if (is_kept(part, options)) prices.push_back(price_of(part, robot, options, solved, kept));
  }
  for (const LongestPart& part : kLongest) {
    const auto add = [&](PlanOptions& more, double step) { more.longest.*part.longest_s += step; };
    prices.push_back({part.name, options.longest.*part.longest_s, "s", 0.0,
                      price(robot, options, solved, add, kStep)});
  }
  return prices;
}

}  // namespace torquewright::hopper
