// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::hopper {

/// How a tracking controller treats the error of velocities about an impact, when contact may come
/// earlier or later than planned.
enum class ImpactHandling {
  kDefault,       ///< Nothing: the error is fed back as it is.
  kNoDerivative,  ///< The whole error is blended out.
  /// The part that an impulse of the coming contact could change is blended out (seed 003).
  kInvariant,
};

/// Metric in which that part is split off.
enum class ImpactMetric {
  kEuclidean,  ///< As published: m/s and rad/s count alike.
  kInertia,    ///< Metric of kinetic energy: the same in any coordinates.
};

struct ImpactOptions {
  ImpactHandling handling = ImpactHandling::kInvariant;
  ImpactMetric metric = ImpactMetric::kEuclidean;
  double window_s = 0.05;  ///< Half its width about the planned impact.
  double blend_s = 0.005;  ///< Time over which the blending comes and goes.
  /// Impulses of every point of the feet that land, not of those alone that the plan lets touch
  /// first.
  bool whole_foot = false;
};

}  // namespace torquewright::hopper
