// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace torquewright::actuator {

/// A point near the least of f, without derivatives: Nelder and Mead, Computer Journal 7 (1965),
/// with their factors 1, 2, 1/2, 1/2. Steps off by `step` times each coordinate (none may be 0) and
/// ends where the simplex is flatter than `flatness` times f, or after `evaluations` of f. f must
/// be defined everywhere; it may be infinite away from the start.
template <typename Function>
std::vector<double> downhill(const Function& f, const std::vector<double>& start, double step,
                             double flatness, int evaluations) {
  struct Vertex {
    std::vector<double> at;
    double value;
  };
  const std::size_t size = start.size();
  const auto vertex = [&f, &evaluations](std::vector<double> at) {
    --evaluations;
    const double value = f(at);
    return Vertex{std::move(at), value};
  };
  std::vector<Vertex> simplex{vertex(start)};
  for (std::size_t i = 0; i < size; ++i) {
    std::vector<double> at = start;
    at[i] *= 1.0 + step;
    simplex.push_back(vertex(std::move(at)));
  }
  const auto by_value = [](const Vertex& a, const Vertex& b) { return a.value < b.value; };
  while (evaluations > 0) {
    std::sort(simplex.begin(), simplex.end(), by_value);
    const double best = simplex.front().value;
    if (!(simplex.back().value - best > flatness * std::abs(best))) break;
    std::vector<double> centre(size, 0.0);
    for (std::size_t v = 0; v < size; ++v) {
      for (std::size_t i = 0; i < size; ++i) {
        centre[i] += simplex[v].at[i] / static_cast<double>(size);
      }
    }
    Vertex& worst = simplex.back();
    const auto along = [&](double factor) {
      std::vector<double> at(size);
      for (std::size_t i = 0; i < size; ++i) at[i] = centre[i] + factor * (worst.at[i] - centre[i]);
      return vertex(std::move(at));
    };
    Vertex reflected = along(-1.0);
    if (reflected.value < best) {
      Vertex expanded = along(-2.0);
      worst = expanded.value < reflected.value ? expanded : reflected;
    } else if (reflected.value < simplex[size - 1].value) {
      worst = reflected;
    } else {
      Vertex contracted = along(reflected.value < worst.value ? -0.5 : 0.5);
      if (contracted.value < std::min(reflected.value, worst.value)) {
        worst = contracted;
      } else {
        for (std::size_t v = 1; v <= size; ++v) {
          std::vector<double> at(size);
          for (std::size_t i = 0; i < size; ++i) {
            at[i] = 0.5 * (simplex[v].at[i] + simplex[0].at[i]);
          }
          simplex[v] = vertex(std::move(at));
        }
      }
    }
  }
  return std::min_element(simplex.begin(), simplex.end(), by_value)->at;
}

}  // namespace torquewright::actuator
