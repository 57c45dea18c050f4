// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearbox/tolerances/built_train.hpp"

namespace torquewright::gearbox {

/// How dimensions lie between their limits.
enum class Distribution {
  kEven,    ///< Every value alike: nothing is known but the limits.
  kNormal,  ///< Limits at three standard deviations, what lies beyond sorted out.
};

/// Its variance over the square of the limits' width.
double variance_per_width_squared(Distribution distribution);

struct DrawOptions {
  std::size_t builds = 10'000;
  std::uint64_t seed = 1;
  Distribution distribution = Distribution::kEven;
};

/// What a gearbox must do to count as good.
struct BuildDemands {
  double min_contact_ratio = 1.0;
  std::optional<double> max_backlash_rad;  ///< At the output.
};

/// Of all builds; of each build the worst of its planets.
struct Spread {
  double mean = 0.0;
  double standard_deviation = 0.0;
  double least = 0.0;
  double low = 0.0;  ///< 5 % lie below.
  double median = 0.0;
  double high = 0.0;  ///< 5 % lie above.
  double greatest = 0.0;
};

struct MeshSpread {
  Spread backlash_mm;
  Spread contact_ratio;
  Spread tip_clearance_mm;
};

/// How many builds miss a demand; one may miss several.
struct MissedDemands {
  std::size_t backlash = 0;  ///< A mesh without: it cannot be put together.
  std::size_t contact_ratio = 0;
  std::size_t tip_clearance = 0;  ///< A tip that reaches its mate's root.
  std::size_t output_backlash = 0;
};

struct DrawnBuilds {
  std::size_t builds = 0;
  std::size_t good = 0;
  MissedDemands missed;
  std::vector<MeshSpread> meshes;
  /// The tightest planet holds the output.
  Spread output_rad;
};

/// Draws gearboxes, every planet with dimensions of its own, the central gears with one for all.
/// The same seed draws the same, with every library.
DrawnBuilds drawn_builds(const ToleratedTrain& train, const DrawOptions& options,
                         const BuildDemands& demands);

}  // namespace torquewright::gearbox
