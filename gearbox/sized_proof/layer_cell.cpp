// SPDX-License-Identifier: Apache-2.0
#include "gearbox/sized_proof/layer_cell.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::gearbox::sized {
namespace {

/// Of what is compared with a limit that is no margin, relative to it.
constexpr double kForgivenShare = 1e-9;

bool is_known(const Affine& x) { return !x.is_nowhere() && x.rest < kInfinity; }

/// What is left of a box, in units of its half widths.
class Left {
 public:
  double highest(const Affine& x) const {
    double sum = x.center + x.rest + kRounding * x.size();
    for (std::size_t i = 0; i < kVariables; ++i) {
      sum += std::max(x.slope[i] * range_[i].low, x.slope[i] * range_[i].high);
    }
    return std::min(sum, x.high);
  }
  double lowest(const Affine& x) const { return -highest(-x); }

  /// Keeps what may be at least -slack; false: nothing.
  bool keep(const Affine& x, double slack) {
    if (!is_known(x)) return !(x.high < -slack);
    if (highest(x) < -slack) return false;
    for (std::size_t i = 0; i < kVariables; ++i) {
      if (x.slope[i] != 0.0 && !cut(x, i, slack)) return false;
    }
    return true;
  }

  const std::array<Range, kVariables>& range() const { return range_; }

 private:
  bool cut(const Affine& x, std::size_t which, double slack) {
    const std::size_t other = 1 - which;
    const double rest =
        x.center + x.rest + slack + 2.0 * kRounding * x.size() +
        std::max(x.slope[other] * range_[other].low, x.slope[other] * range_[other].high);
    const double at = -rest / x.slope[which];
    const double outward = 1e-13 * (1.0 + std::abs(at));
    Range& range = range_[which];
    if (x.slope[which] > 0.0) {
      range.low = std::max(range.low, at - outward);
    } else {
      range.high = std::min(range.high, at + outward);
    }
    return range.low <= range.high;
  }

  std::array<Range, kVariables> range_{Range{-1.0, 1.0}, Range{-1.0, 1.0}};
};

/// One pass over a box.
class Pass {
 public:
  Pass(const LoadedTeeth& teeth, std::size_t layer, const Demands& demands,
       const LayerLimits& limits, const CellBox& box)
      : teeth_(teeth), layer_(layer), demands_(demands), limits_(limits), box_(box) {
    demands_.heaviest_kg = limits.heaviest_kg;
  }

  bool run(LayerCell& cell) {
    terms_ = layer_terms(teeth_, layer_, variable(box_[0].low, box_[0].high, 0),
                         variable(box_[1].low, box_[1].high, 1), demands_);
    if (terms_.is_closed) return false;
    for (const Affine& margin : terms_.margins) {
      if (!left_.keep(margin, kForgiven)) return false;
    }
    for (const Affine& width : terms_.width_mm) {
      if (!keep_width(width, cell)) return false;
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const Affine& each = terms_.efficiency[i];
      if (!each.is_nowhere()) cell.efficiency[i] = std::min(1.0, left_.highest(each));
    }
    set_shares(cell);
    set_box(cell.box);
    return true;
  }

  /// Of the last pass.
  void set_forms(LayerCell& cell) const {
    cell.masses.clear();
    cell.conditions.clear();
    for (const Affine& margin : terms_.margins) {
      if (is_known(margin) && left_.lowest(margin) < 0.0) add_condition(margin, kForgiven, cell);
    }
    for (const Affine& width : terms_.width_mm) {
      const Affine mass = width * terms_.kg_per_mm;
      if (is_known(mass) && left_.highest(mass) > cell.least_kg) {
        cell.masses.push_back(form(mass, -mass.rest));
      }
      if (!(teeth_.widest_mm[layer_] < kInfinity) || !is_known(width)) continue;
      if (left_.highest(width) > teeth_.widest_mm[layer_]) {
        add_condition(teeth_.widest_mm[layer_] - width, forgiven_mm(), cell);
      }
    }
    cell.masses.push_back({cell.least_kg, {}, {}});
  }

 private:
  double forgiven_mm() const { return 1e-6 + kForgivenShare * teeth_.widest_mm[layer_]; }

  void set_shares(LayerCell& cell) const {
    if (!teeth_.least_Nm_rad) return;
    const auto least = [&](const Affine& x) {
      return is_known(x) ? std::max(0.0, left_.lowest(x)) : 0.0;
    };
    cell.least_kg_per_mm = least(terms_.kg_per_mm);
    if (demands_.inertia) cell.least_kg_m2_per_mm = least(terms_.kg_m2_per_mm);
    cell.least_softness = least(terms_.softness);
  }

  bool keep_width(const Affine& width, LayerCell& cell) {
    if (teeth_.widest_mm[layer_] < kInfinity &&
        !left_.keep(teeth_.widest_mm[layer_] - width, forgiven_mm())) {
      return false;
    }
    const Affine mass = width * terms_.kg_per_mm;
    if (limits_.heaviest_kg < kInfinity && !left_.keep(limits_.heaviest_kg - mass, 0.0)) {
      return false;
    }
    cell.least_mm = std::max(cell.least_mm, left_.lowest(width));
    cell.least_kg = std::max(cell.least_kg, left_.lowest(mass));
    if (!demands_.inertia) return true;
    const Affine inertia = width * terms_.kg_m2_per_mm;
    if (limits_.most_kg_m2 < kInfinity &&
        !left_.keep(limits_.most_kg_m2 - inertia, kForgivenShare * limits_.most_kg_m2)) {
      return false;
    }
    cell.least_kg_m2 = std::max(cell.least_kg_m2, left_.lowest(inertia));
    return true;
  }

  void set_box(CellBox& box) const {
    for (std::size_t i = 0; i < kVariables; ++i) {
      const Range& range = left_.range()[i];
      const double middle = 0.5 * (box_[i].low + box_[i].high);
      const double half = 0.5 * (box_[i].high - box_[i].low);
      const double outward = 1e-14 * (std::abs(middle) + half);
      if (range.low > -1.0) {
        box[i].low = std::max(box_[i].low, middle + half * range.low - outward);
      }
      if (range.high < 1.0) {
        box[i].high = std::min(box_[i].high, middle + half * range.high + outward);
      }
    }
  }

  PlacedForm form(const Affine& x, double rest) const {
    PlacedForm placed;
    placed.constant = x.center + rest;
    for (std::size_t i = 0; i < kVariables; ++i) {
      placed.reference[i] = 0.5 * (box_[i].low + box_[i].high);
      const double half = 0.5 * (box_[i].high - box_[i].low);
      if (half > 0.0) {
        placed.slope[i] = x.slope[i] / half;
      } else {
        placed.constant -= std::abs(x.slope[i]);
      }
    }
    placed.constant -= 16.0 * kRounding * x.size();
    return placed;
  }

  void add_condition(const Affine& margin, double slack, LayerCell& cell) const {
    cell.conditions.push_back(form(-margin, -margin.rest - slack));
  }

  const LoadedTeeth& teeth_;
  std::size_t layer_;
  Demands demands_;
  LayerLimits limits_;
  CellBox box_;
  LayerTerms<Affine> terms_;
  Left left_;
};

double area(const CellBox& box) { return box[0].width() * box[1].width(); }

}  // namespace

bool bound_cell(const LoadedTeeth& teeth, std::size_t layer, const Demands& demands,
                const LayerLimits& limits, LayerCell& cell) {
  constexpr int kMostPasses = 4;
  constexpr double kMuchLess = 0.5;
  for (int pass = 1;; ++pass) {
    Pass over(teeth, layer, demands, limits, cell.box);
    const double before = area(cell.box);
    if (!over.run(cell)) return false;
    if (pass < kMostPasses && area(cell.box) < kMuchLess * before) continue;
    over.set_forms(cell);
    return true;
  }
}

}  // namespace torquewright::gearbox::sized
