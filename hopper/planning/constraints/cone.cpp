// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/constraints/cone.hpp"

#include <algorithm>
#include <limits>

#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

/// Variables: the force along the ground, those upwards.
struct ConeLaw {
  std::size_t points;
  double friction;
  double edge;
  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    T load = x[1];
    if (points == 2) load += x[2];
    rows[0] = x[0] - friction * load;
    rows[1] = -x[0] - friction * load;
    if (points < 2) return;
    rows[2] = edge * load - x[1];
    rows[3] = edge * load - x[2];
  }
};

// Part of a phase before the foot tips, over which its load may go to the edge.
constexpr double kTips = 0.3;

}  // namespace

double friction_of(const Site& site) {
  double friction = std::numeric_limits<double>::infinity();
  for (const std::size_t i : site.stance().points) {
    friction = std::min(friction, site.model.plane.sole[i].friction_coefficient);
  }
  return friction * (1.0 - site.options.margins.friction);
}

bool tips(const Site& site) {
  return !site.is_last_phase() &&
         site.mesh[site.phase + 1].stance.points.size() < site.stance().points.size();
}

double edge_at(const Site& site, double share) {
  const double from_tipping = tips(site) ? std::min(1.0, (1.0 - share) / kTips) : 1.0;
  return site.options.margins.center_of_pressure * from_tipping;
}

void add_cone(const Site& site, std::string_view name, int forces, double scale, double edge,
              optimization::Program& program) {
  const std::size_t rows = site.stance().is_flat() ? 4 : 2;
  program.add_rows(jet_rows(site.named(name), numbers_from(forces, site.forces()),
                            std::vector<optimization::Bounds>(rows, at_most(0.0)),
                            std::vector<double>(rows, scale),
                            ConeLaw{site.stance().points.size(), friction_of(site), edge}));
}

}  // namespace torquewright::hopper
