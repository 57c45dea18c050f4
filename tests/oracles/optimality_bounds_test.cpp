// SPDX-License-Identifier: Apache-2.0
// Oracle: minlp.md section 7: for which bounds, which the paper keeps to itself, its design is the
// optimum; derived there independently of this enumeration.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/oracles/gearbox_enumeration.hpp"
#include "tests/oracles/named_problems.hpp"

namespace torquewright::oracles {
namespace {

using gearbox::Problem;

bool is_published(const Teeth& z) { return z.sun == 44 && z.planet_1 == 44 && z.planet_2 == 32; }

bool meets(const Minima& minima, const Minima& needed) {
  return minima.sun >= needed.sun && minima.planet_1 >= needed.planet_1 &&
         minima.planet_2 >= needed.planet_2;
}

// minlp.md section 7: minima of which one has to be reached, by alpha_min in degrees.
std::vector<Minima> needed_minima(double degrees) {
  std::vector<Minima> any{{0, 0, 29},  {25, 43, 0}, {31, 41, 0}, {35, 0, 28},
                          {35, 37, 0}, {43, 0, 26}, {43, 33, 0}};
  if (degrees >= 3.3) any.push_back({0, 43, 0});
  if (degrees >= 10) any.push_back({0, 41, 0});
  if (degrees >= 13) {
    any.push_back({0, 0, 28});
    any.push_back({0, 37, 0});
  }
  return any;
}

bool is_published_optimum(const std::vector<Found>& feasible, const Minima& minima) {
  const Found* best = nullptr;
  for (const Found& found : feasible) {
    const Teeth& z = found.teeth;
    if (!meets({z.sun, z.planet_1, z.planet_2}, minima)) continue;
    if (best == nullptr || found.objective < best->objective) best = &found;
  }
  return best != nullptr && is_published(best->teeth);
}

bool says_section_7(double degrees, const Minima& minima) {
  if (!meets({44, 44, 32}, minima)) return false;
  for (const Minima& needed : needed_minima(degrees)) {
    if (meets(minima, needed)) return true;
  }
  return false;
}

// 24/48/28, the last to leave, has 3.1897 degrees; the text rounds that to 3.19.
TEST(OptimalityBounds, MakeThePublishedDesignOptimal) {
  for (const double degrees : {0.0, 1.0, 3.18, 3.3, 5.0, 7.0, 10.0, 13.0, 14.9}) {
    const std::int64_t nanoradians = std::llround(degrees / 180 * std::numbers::pi * 1e9);
    const Problem problem = paper_problem({1, 1, 1}, Rational(nanoradians) / 1000000000);
    const std::vector<Found> feasible = enumerate(problem).feasible;
    for (Minima m{1, 1, 1}; m.sun <= 46; ++m.sun) {
      for (m.planet_1 = 1; m.planet_1 <= 46; ++m.planet_1) {
        for (m.planet_2 = 1; m.planet_2 <= 34; ++m.planet_2) {
          ASSERT_EQ(is_published_optimum(feasible, m), says_section_7(degrees, m))
              << degrees << " degrees, " << m.sun << '/' << m.planet_1 << '/' << m.planet_2;
        }
      }
    }
  }
}

}  // namespace
}  // namespace torquewright::oracles
