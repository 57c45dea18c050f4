// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "hopper/calibration/calibrate.hpp"

namespace torquewright::hopper::calibration {
namespace {

constexpr int kIntervals = 24;
constexpr int kHalvings = 12;
constexpr double kNarrow = 0.05;  // of the bounds: determined (docs/calibration.md, "The valley")

/// One free value's profile; each fit starts where its neighbour ended.
class Valley {
 public:
  Valley(const Question& question, std::size_t index) : question_(question), index_(index) {}

  ProfilePoint at(double value, const std::optional<Candidate>& neighbour) const {
    return {value, nearest_candidate(question_, Held{index_, value},
                                     neighbour ? neighbour->values : std::vector<double>())};
  }

  bool is_inside(const ProfilePoint& point) const { return meets(question_.figures, point.best); }

  /// The end of a range between a point inside and one outside.
  double edge(ProfilePoint inside, double outside) const {
    for (int step = 0; step < kHalvings; ++step) {
      const ProfilePoint middle = at((inside.value + outside) / 2.0, inside.best);
      if (is_inside(middle)) {
        inside = middle;
      } else {
        outside = middle.value;
      }
    }
    return inside.value;
  }

 private:
  const Question& question_;
  std::size_t index_;
};

/// The grid, and the best fit's own value in its place: a valley narrower than the grid is met too.
std::vector<double> grid_of(const FreeValue& free, const std::optional<Candidate>& best,
                            std::size_t index) {
  std::vector<double> grid;
  for (int i = 0; i <= kIntervals; ++i) {
    grid.push_back(free.lowest + (free.highest - free.lowest) * i / kIntervals);
  }
  if (best) grid.push_back(best->values[index]);
  std::sort(grid.begin(), grid.end());
  grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
  return grid;
}

}  // namespace

Profile profile_of(const Question& question, std::size_t index,
                   const std::optional<Candidate>& best) {
  const Valley valley(question, index);
  const FreeValue& free = question.free[index];
  Profile profile;
  for (const double value : grid_of(free, best, index)) {
    const bool has_neighbour = !profile.points.empty() && profile.points.back().best;
    profile.points.push_back(valley.at(value, has_neighbour ? profile.points.back().best : best));
  }
  const std::vector<ProfilePoint>& points = profile.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!valley.is_inside(points[i])) continue;
    const bool starts = i == 0 || !valley.is_inside(points[i - 1]);
    if (starts) {
      const double low = i == 0 ? points[i].value : valley.edge(points[i], points[i - 1].value);
      profile.ranges.push_back({low, low});
    }
    const bool ends = i + 1 == points.size() || !valley.is_inside(points[i + 1]);
    if (!ends) continue;
    profile.ranges.back().high =
        i + 1 == points.size() ? points[i].value : valley.edge(points[i], points[i + 1].value);
  }
  profile.is_determined =
      profile.ranges.size() == 1 &&
      profile.ranges[0].high - profile.ranges[0].low < kNarrow * (free.highest - free.lowest);
  return profile;
}

}  // namespace torquewright::hopper::calibration
