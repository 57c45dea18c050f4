// SPDX-License-Identifier: Apache-2.0
#include "gearbox/tolerances/drawn_builds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

#include "gearbox/teeth/scalar_functions.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kSigmasAtLimit = 3.0;

/// Numbers of the distribution from -1 to 1, of the standard's own engine alone: libraries'
/// distributions differ.
class Draw {
 public:
  explicit Draw(const DrawOptions& options)
      : engine_(options.seed), distribution_(options.distribution) {}

  double between_limits() {
    if (distribution_ == Distribution::kEven) return 2.0 * share() - 1.0;
    for (;;) {
      const double radius = std::sqrt(-2.0 * std::log(share()));
      const double sigmas = radius * std::cos(2.0 * std::numbers::pi * share());  // Box and Muller.
      if (std::abs(sigmas) <= kSigmasAtLimit) return sigmas / kSigmasAtLimit;
    }
  }

 private:
  /// Above 0 and below 1.
  double share() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }

  std::mt19937_64 engine_;
  Distribution distribution_;
};

double drawn(const PartLimit& limit, Draw& draw) {
  return limit.middle() + 0.5 * limit.width() * draw.between_limits();
}

/// One gearbox: of each mesh the worst of all planets.
struct Build {
  std::vector<BuiltMesh> meshes;
  double output_rad = 0.0;
};

std::vector<BuiltMesh> planets_meshes(const ToleratedTrain& train, Deviations deviations) {
  std::vector<BuiltMesh> meshes;
  for (std::size_t mesh = 0; mesh < train.cut.meshes.size(); ++mesh) {
    meshes.push_back(built_mesh(train, mesh, deviations));
  }
  return meshes;
}

double output_of(const ToleratedTrain& train, const std::vector<BuiltMesh>& meshes) {
  std::vector<double> backlash_mm;
  for (const BuiltMesh& mesh : meshes) backlash_mm.push_back(mesh.backlash_mm);
  return train.backlash_rad(backlash_mm);
}

void keep_worse(const BuiltMesh& other, BuiltMesh& mesh) {
  mesh.backlash_mm = std::min(mesh.backlash_mm, other.backlash_mm);
  mesh.contact_ratio = std::min(mesh.contact_ratio, other.contact_ratio);
  mesh.tip_1_clearance_mm = std::min(mesh.tip_1_clearance_mm, other.tip_1_clearance_mm);
  mesh.tip_2_clearance_mm = std::min(mesh.tip_2_clearance_mm, other.tip_2_clearance_mm);
}

Build drawn_build(const ToleratedTrain& train, Draw& draw) {
  std::vector<double> deviations(train.limits.size(), 0.0);
  const auto draw_all = [&](bool of_planets) {
    for (std::size_t i = 0; i < deviations.size(); ++i) {
      if (train.limits[i].is_of_each_planet != of_planets) continue;
      deviations[i] = drawn(train.limits[i], draw);
    }
  };
  draw_all(false);
  Build build;
  for (std::int64_t planet = 0; planet < train.cut.train.planet_count; ++planet) {
    draw_all(true);
    const std::vector<BuiltMesh> meshes = planets_meshes(train, deviations);
    const double output_rad = output_of(train, meshes);
    if (planet == 0) {
      build = {meshes, output_rad};
      continue;
    }
    build.output_rad = std::min(build.output_rad, output_rad);
    for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
      keep_worse(meshes[mesh], build.meshes[mesh]);
    }
  }
  return build;
}

/// True where any mesh is.
template <class Test>
bool any(const Build& build, const Test& test) {
  return std::any_of(build.meshes.begin(), build.meshes.end(), test);
}

void judge(const Build& build, const BuildDemands& demands, DrawnBuilds& result) {
  const bool binds = any(build, [](const BuiltMesh& mesh) { return mesh.backlash_mm < 0.0; });
  const bool loses_contact = any(
      build, [&](const BuiltMesh& mesh) { return mesh.contact_ratio < demands.min_contact_ratio; });
  const bool touches =
      any(build, [](const BuiltMesh& mesh) { return mesh.tip_clearance_mm() <= 0.0; });
  const bool plays = demands.max_backlash_rad && build.output_rad > *demands.max_backlash_rad;
  result.missed.backlash += binds ? 1U : 0U;
  result.missed.contact_ratio += loses_contact ? 1U : 0U;
  result.missed.tip_clearance += touches ? 1U : 0U;
  result.missed.output_backlash += plays ? 1U : 0U;
  if (!binds && !loses_contact && !touches && !plays) ++result.good;
}

Spread spread_of(std::vector<double> values) {
  const auto count = static_cast<double>(values.size());
  Spread spread;
  spread.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (const double value : values) squares += square(value - spread.mean);
  spread.standard_deviation = values.size() > 1 ? std::sqrt(squares / (count - 1.0)) : 0.0;
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * (count - 1.0))];
  };
  spread.least = values.front();
  spread.low = at(0.05);
  spread.median = at(0.5);
  spread.high = at(0.95);
  spread.greatest = values.back();
  return spread;
}

template <class Quantity>
Spread spread_over(const std::vector<Build>& builds, std::size_t mesh, const Quantity& quantity) {
  std::vector<double> values;
  for (const Build& build : builds) values.push_back(quantity(build.meshes[mesh]));
  return spread_of(std::move(values));
}

MeshSpread mesh_spread(const std::vector<Build>& builds, std::size_t mesh) {
  return {
      spread_over(builds, mesh, [](const BuiltMesh& built) { return built.backlash_mm; }),
      spread_over(builds, mesh, [](const BuiltMesh& built) { return built.contact_ratio; }),
      spread_over(builds, mesh, [](const BuiltMesh& built) { return built.tip_clearance_mm(); })};
}

}  // namespace

double variance_per_width_squared(Distribution distribution) {
  if (distribution == Distribution::kEven) return 1.0 / 12.0;
  // Of a normal number that is cut at c deviations: 1 - 2 c phi(c)/(2 Phi(c) - 1); the width is 2
  // c.
  constexpr double c = kSigmasAtLimit;
  const double density = std::exp(-0.5 * c * c) / std::sqrt(2.0 * std::numbers::pi);
  const double within = std::erf(c / std::numbers::sqrt2);
  return (1.0 - 2.0 * c * density / within) / square(2.0 * c);
}

DrawnBuilds drawn_builds(const ToleratedTrain& train, const DrawOptions& options,
                         const BuildDemands& demands) {
  Draw draw(options);
  DrawnBuilds result;
  result.builds = std::max<std::size_t>(1, options.builds);
  std::vector<Build> builds;
  std::vector<double> outputs_rad;
  for (std::size_t i = 0; i < result.builds; ++i) {
    builds.push_back(drawn_build(train, draw));
    judge(builds.back(), demands, result);
    outputs_rad.push_back(builds.back().output_rad);
  }
  for (std::size_t mesh = 0; mesh < train.cut.meshes.size(); ++mesh) {
    result.meshes.push_back(mesh_spread(builds, mesh));
  }
  result.output_rad = spread_of(std::move(outputs_rad));
  return result;
}

}  // namespace torquewright::gearbox
