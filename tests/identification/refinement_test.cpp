// SPDX-License-Identifier: Apache-2.0
// Oracle: laws of closed form with shapes that lie between the grid's.
#include "identification/refinement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "identification/equation_fit.hpp"
#include "identification/folds.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::refinement_test {
namespace {

using made::Made;
using made::MadeBench;

constexpr double kErrors = 4.0;  ///< Standard errors, of one fixed log.
constexpr double kModel = 0.02;  ///< Relative: the filter's smear of what is steep at rest.

/// The best variant of an effect alone, refined.
struct Refined {
  std::optional<RefinedModel> model;
  double grid_loss = 0.0;

  Refined(const char* effect, const std::function<double(const Made&)>& added) {
    const MadeBench rig;
    const Log log = rig.log(added);
    const Bench bench = rig.bench(log);
    const NoiseLevels levels = noise_levels(log, 0);
    const std::vector<Signals> signals = prepare(log, bench, levels, {});
    std::vector<std::vector<Signals>> replicas;
    for (std::uint64_t seed : {1u, 2u}) {
      PreparationOptions noisy;
      noisy.noise = &levels;
      noisy.seed = seed;
      replicas.push_back(prepare(log, bench, levels, noisy));
    }
    const SignalSource source(signals, replicas);
    const EquationFit fit(log, torque_equation(bench, extent_of(signals), {}), source);
    Fit best;
    const auto& variants = fit.equation().dictionary.variants;
    for (std::size_t v = 0; v < variants.size(); ++v) {
      if (variants[v].effect != effect || !fit.is_excited(v)) continue;
      const Fit trial = fit.fitter().fit({v});
      if (trial.is_valid && (!best.is_valid || trial.loss < best.loss)) best = trial;
    }
    EXPECT_TRUE(best.is_valid);
    grid_loss = best.loss;
    model = refined(bench, fit.equation(), best, source, fit.folds().of_run, fit.folds().of_block,
                    fit.band());
  }

  void expect(const char* name, double truth) const {
    ASSERT_TRUE(model);
    const auto found = std::find_if(model->shapes.begin(), model->shapes.end(),
                                    [&](const ShapeEstimate& each) { return each.name == name; });
    ASSERT_NE(found, model->shapes.end()) << name;
    EXPECT_NEAR(found->value, truth, kErrors * found->standard_error + kModel * truth) << name;
  }
};

TEST(Refinement, FindsTheStribeckVelocity) {
  const Refined found("stribeck_friction", [](const Made& at) {
    const double over = at.speed_rad_s / 0.37;
    return -made::sign(at.speed_rad_s) * (0.5 + 0.8 * std::exp(-over * over));
  });
  found.expect("stribeck_velocity_rad_s", 0.37);
  EXPECT_LE(found.model->fit.loss, 1.001 * found.grid_loss);
}

TEST(Refinement, FindsTheSaturation) {
  const Refined found("torque_constant_saturation", [](const Made& at) {
    return at.torque_Nm *
           (std::pow(1.0 + std::pow(std::abs(at.current_A) / 11.0, 2.6), -1.0 / 2.6) - 1.0);
  });
  found.expect("saturation_current_A", 11.0);
  found.expect("exponent", 2.6);
}

TEST(Refinement, HasNothingToDoForAStraightLaw) {
  const Refined found("viscous_friction", [](const Made& at) { return -0.3 * at.speed_rad_s; });
  EXPECT_FALSE(found.model);
}

}  // namespace
}  // namespace torquewright::identification::refinement_test
