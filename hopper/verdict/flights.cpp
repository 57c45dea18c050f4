// SPDX-License-Identifier: Apache-2.0
#include "hopper/verdict/flights.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::hopper {
namespace {

/// How far a flight of the run is from a planned one, in s.
double distance_s(const TimeInAir& planned, const TimeInAir& flown) {
  return std::abs(planned.from_s - flown.from_s) + std::abs(planned.until_s - flown.until_s);
}

/// The cheapest assignment in order, by dynamic programming over (planned, flown).
class Assignment {
 public:
  Assignment(const std::vector<TimeInAir>& planned, const std::vector<TimeInAir>& flown)
      : planned_(planned), flown_(flown), width_(flown.size() + 1) {
    costs_s_.assign((planned.size() + 1) * width_, 0.0);
    for (std::size_t i = planned.size(); i-- > 0;) {
      for (std::size_t j = width_; j-- > 0;) cost_s(i, j) = least_s(i, j);
    }
  }

  std::vector<std::optional<TimeInAir>> chosen() const {
    std::vector<std::optional<TimeInAir>> chosen(planned_.size());
    std::size_t j = 0;
    for (std::size_t i = 0; i < planned_.size(); ++i) {
      while (j < flown_.size() && skips_flown(i, j)) ++j;
      if (j == flown_.size() || skips_planned(i, j)) continue;
      chosen[i] = flown_[j++];
    }
    return chosen;
  }

 private:
  double& cost_s(std::size_t i, std::size_t j) { return costs_s_[i * width_ + j]; }
  double cost_s(std::size_t i, std::size_t j) const { return costs_s_[i * width_ + j]; }
  /// What it costs that a planned flight is matched by none.
  double unmatched_s(std::size_t i) const { return 2.0 * planned_[i].duration_s(); }
  bool skips_flown(std::size_t i, std::size_t j) const { return cost_s(i, j) == cost_s(i, j + 1); }
  bool skips_planned(std::size_t i, std::size_t j) const {
    return cost_s(i, j) == unmatched_s(i) + cost_s(i + 1, j);
  }

  double least_s(std::size_t i, std::size_t j) const {
    const double without_s = unmatched_s(i) + cost_s(i + 1, j);
    if (j == flown_.size()) return without_s;
    const double with_s = distance_s(planned_[i], flown_[j]) + cost_s(i + 1, j + 1);
    return std::min({without_s, with_s, cost_s(i, j + 1)});
  }

  const std::vector<TimeInAir>& planned_;
  const std::vector<TimeInAir>& flown_;
  std::size_t width_;
  std::vector<double> costs_s_;
};

}  // namespace

std::vector<TimeInAir> flights_of(const Reference& reference) {
  std::vector<TimeInAir> flights;
  const std::vector<ContactMode>& modes = reference.modes();
  for (std::size_t i = 0; i + 1 < modes.size(); ++i) {
    const TimeInAir flight{modes[i].from_s, modes[i].until_s};
    const bool is_flight = !modes[i].touches.any() && flight.duration_s() >= kShortestFlight_s;
    if (is_flight) flights.push_back(flight);
  }
  return flights;
}

std::vector<TimeInAir> flights_of(const Reference& reference, const std::vector<Flight>& checked) {
  std::vector<TimeInAir> flights = flights_of(reference);
  for (TimeInAir& flight : flights) {
    for (const Flight& other : checked) {
      const bool is_same = other.from_s <= flight.from_s && flight.from_s < other.until_s;
      if (is_same) flight.from_s = other.from_s;
    }
  }
  return flights;
}

std::vector<TimeInAir> losses_of_contact(const Record& record) {
  std::vector<TimeInAir> losses;
  if (record.rows.empty()) return losses;
  double last_contact_s = record.rows.front().time_s;
  bool was_in_contact = true;
  for (const RecordRow& row : record.rows) {
    const bool touches = row.touches.any();
    if (touches && !was_in_contact) losses.push_back({last_contact_s, row.time_s});
    if (touches) last_contact_s = row.time_s;
    was_in_contact = touches;
  }
  return losses;
}

std::vector<MatchedFlight> matched_flights(const std::vector<TimeInAir>& planned, double begins_s,
                                           const Record& record) {
  const std::vector<TimeInAir> flown = losses_of_contact(record);
  const std::vector<std::optional<TimeInAir>> chosen = Assignment(planned, flown).chosen();
  std::vector<MatchedFlight> matched;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    matched.push_back({planned[i], planned[i].from_s > begins_s, chosen[i]});
  }
  return matched;
}

}  // namespace torquewright::hopper
