// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "actuator/mor/mor_table.hpp"
#include "src/report/parts/plotted_region.hpp"

namespace torquewright::report {

/// The bounds of one region as data blocks and plot elements of a gnuplot script.
class RegionLines {
 public:
  /// `name` tells its data blocks from those of other regions in the script.
  RegionLines(const actuator::MorTable& table, std::string name, bool has_battery = true);

  std::string data() const;
  std::string shade(const char* colour) const;

  /// A line for every stretch of a bound with one limiter, in its colour.
  /// `dash` 1 is solid, every other number another pattern.
  std::vector<std::string> plots(double width, std::size_t dash) const;

 private:
  struct Stretch {
    actuator::Limiter limiter;
    std::string points;
  };
  void add_bound(const actuator::MorTable& table, bool is_upper);

  std::string name_;
  bool has_battery_ = true;
  std::string outline_;
  std::vector<Stretch> stretches_;
};

/// An empty line that puts a region's label, with its dashes, into the key.
std::string label_key(const std::string& label, double width, std::size_t dash);

/// Empty lines that put the limiters that occur, with their colours, into the key.
std::vector<std::string> limiter_key(const std::vector<PlottedRegion>& regions);

}  // namespace torquewright::report
