// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::hopper {

/// What a tracking controller does with the error of velocities about an impact, when contact may
/// come earlier or later than planned.
enum class ImpactHandling {
  kDefault,       ///< Nothing: the error is fed back as it is.
  kNoDerivative,  ///< It is blended out.
  kInvariant,     ///< What an impulse of the coming contact could change is blended out (seed 003).
};

/// In which metric the part that an impulse could change is split off.
enum class ImpactMetric {
  kEuclidean,  ///< As published: m/s and rad/s count alike.
  kInertia,    ///< Of kinetic energy: the same in any coordinates.
};

struct ImpactOptions {
  ImpactHandling handling = ImpactHandling::kInvariant;
  ImpactMetric metric = ImpactMetric::kEuclidean;
  double window_s = 0.05;  ///< Half its width about the planned impact.
  double blend_s = 0.005;  ///< Over which it comes and goes.
  /// Impulses of every point of the feet that land, not of those alone that the plan lets touch
  /// first.
  bool whole_foot = false;
};

}  // namespace torquewright::hopper
