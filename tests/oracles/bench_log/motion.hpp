// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "tests/oracles/bench_log/random.hpp"

namespace torquewright::oracles {

/// Commands stand on knots of this period.
inline constexpr double kTick_s = 0.001;

using Knots = std::vector<double>;  ///< A signal at 0, kTick_s, 2 kTick_s, ...

std::size_t knot_count(double duration_s);

/// Shapes of peak about 1, as many knots as asked for.
Knots multisine(Chance& chance, std::size_t count, double least_Hz, double most_Hz, int sines);
Knots chirp(std::size_t count, double first_Hz, double last_Hz);
Knots triangle(Chance& chance, std::size_t count, double period_s);
Knots sine(Chance& chance, std::size_t count, double frequency_Hz);
/// Levels drawn from [-1, 1], held for hold_s on the average, with edges of 60 ms.
Knots steps(Chance& chance, std::size_t count, double hold_s);
Knots constant(std::size_t count, double level);

Knots scaled(Knots knots, double factor, double offset = 0.0);
Knots sum(Knots a, const Knots& b);

/// A motion whose speed passes through the knots as a cubic with continuous slope, and whose
/// position is that speed's exact integral: position, speed and acceleration agree everywhere.
class ImposedMotion {
 public:
  struct Point {
    double position_rad, speed_rad_s, acceleration_rad_s2;
  };

  ImposedMotion(Knots speed_rad_s, double start_rad);
  /// At knot + share (0 <= share < 1).
  Point at(std::size_t knot, double share) const;

 private:
  Knots speed_, slope_, position_;  ///< Slope per tick.
};

}  // namespace torquewright::oracles
