// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis/inner_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gearbox/synthesis/linear_bound.hpp"
#include "gearbox/synthesis/stiff_widths.hpp"

namespace torquewright::gearbox {
namespace {

using optimization::kInfinity;

double greatest_change(const Interval& slope, const Interval& offset) {
  if (slope.lower == 0.0 && slope.upper == 0.0) return 0.0;
  return (slope * offset).upper;
}

/// What margins leave of a box.
class ShrinkingBox {
 public:
  ShrinkingBox(const InnerBox& box, const InnerPlace& place)
      : box_(box), middle_(place.middle()), offsets_(place.offsets()) {}

  const InnerBox& box() const { return box_; }
  const InnerBox& offsets() const { return offsets_; }

  /// Over what is left of the box.
  double upper(const Slope& range) const {
    double sum = range.center.upper;
    for (std::size_t i = 0; i < kInnerVariables; ++i) {
      sum += greatest_change(range.slopes[i], offsets_[i]);
    }
    return sum < range.value.upper ? sum : range.value.upper;
  }

  double lower(const Slope& range) const { return -upper(-range); }

  /// Keeps what f >= -slack leaves; false: nothing.
  bool require(const Slope& range, double slack) {
    if (upper(range) < -slack) return false;
    for (std::size_t i = 0; i < kInnerVariables; ++i) {
      if (!cut(range, i, slack)) return false;
    }
    for (std::size_t i = 0; i < kInnerVariables; ++i) {
      offsets_[i] = box_[i] - Interval(middle_[i]);
    }
    return true;
  }

 private:
  bool cut(const Slope& form, std::size_t which, double slack) {
    const Interval& slope = form.slopes[which];
    if (!(slope.lower > 0.0) && !(slope.upper < 0.0)) return true;
    double rest = form.center.upper + slack;
    for (std::size_t i = 0; i < kInnerVariables; ++i) {
      if (i != which) rest += greatest_change(form.slopes[i], offsets_[i]);
    }
    if (!std::isfinite(rest)) return true;
    Interval& range = box_[which];
    if (slope.lower > 0.0) {  // slope d >= -rest
      const double least = -rest / (rest >= 0.0 ? slope.lower : slope.upper);
      range.lower = std::max(range.lower, outward(which, least, -1.0));
    } else {
      const double most = rest / (rest >= 0.0 ? -slope.upper : -slope.lower);
      range.upper = std::min(range.upper, outward(which, most, 1.0));
    }
    return range.lower <= range.upper;
  }

  double outward(std::size_t which, double offset, double sign) const {
    const double value = middle_[which] + offset;
    return value + sign * (1e-12 * (std::abs(offset) + std::abs(middle_[which])));
  }

  InnerBox box_;
  std::array<double, kInnerVariables> middle_;
  InnerBox offsets_;
};

bool is_finite(const Slope& range) { return std::isfinite(range.value.lower); }

double greatest(const std::vector<double>& widths) {
  return *std::max_element(widths.begin(), widths.end());
}

/// Bounds one cell; false: nothing in it is of interest, and `why` is the margin, if it is one.
class CellBound {
 public:
  CellBound(const InnerCase& inner, std::size_t layer, double cutoff_kg, LayerCell& cell)
      : cell_(cell),
        cutoff_kg_(cutoff_kg),
        widest_mm_(inner.max_face_width_mm[layer]),
        most_inertia_kg_m2_(inner.max_gear_inertia_kg_m2),
        place_(cell.box),
        range_(layer_values(inner, layer, place_, cutoff_kg)),
        left_(cell.box, place_) {}

  bool run(std::optional<std::size_t>& why) {
    for (std::size_t i = 0; i < range_.margins.size(); ++i) {
      if (left_.require(range_.margins[i], kMarginSlack)) continue;
      why = i;
      return false;
    }
    if (!bound_mass()) return false;
    for (std::size_t i = 0; i < 2; ++i) {
      const double most = left_.upper(range_.efficiency[i]);
      cell_.efficiency[i] = most < 1.0 ? most : 1.0;
    }
    bound_shares();
    cell_.box = left_.box();
    return true;
  }

  /// Lines that bound the layer over what is left of the cell.
  LayerForms forms() const {
    LayerForms forms;
    forms.middle = place_.middle();
    for (const Slope& width : range_.width_mm) {
      if (!is_finite(width)) continue;
      const Slope mass = width * range_.mass_per_width_kg_mm;
      if (has_finite_slopes(mass) && left_.upper(mass) > cell_.mass_kg) {
        forms.masses.push_back(linear_below(mass, left_.offsets()));
      }
      if (has_finite_slopes(width) && left_.upper(width) > widest_mm_) {
        forms.margins.push_back(linear_above(widest_mm_ - width, left_.offsets()));
      }
    }
    for (const Slope& margin : range_.margins) {
      if (!has_finite_slopes(margin) || left_.lower(margin) >= 0.0) continue;
      LinearForm form = linear_above(margin, left_.offsets());
      form.constant += kMarginSlack;
      forms.margins.push_back(form);
    }
    forms.masses.push_back({cell_.mass_kg, {}});
    return forms;
  }

 private:
  static bool has_finite_slopes(const Slope& range) {
    return std::all_of(range.slopes.begin(), range.slopes.end(),
                       [](const Interval& slope) {
                         return std::isfinite(slope.lower) && std::isfinite(slope.upper);
                       }) &&
           std::isfinite(range.center.lower) && std::isfinite(range.center.upper);
  }

  void bound_shares() {
    const auto least = [&](const Slope& range) {
      const double low = left_.lower(range);
      return low > 0.0 ? low : 0.0;
    };
    cell_.softness_rad_mm_Nm = least(range_.softness_rad_mm_Nm);
    cell_.kg_per_mm = least(range_.mass_per_width_kg_mm);
    cell_.kg_m2_per_mm = least(range_.inertia_per_width_kg_m2_mm);
  }

  bool bound_mass() {
    for (const Slope& width : range_.width_mm) {
      if (!is_finite(width)) continue;
      if (!left_.require(widest_mm_ - width, 1e-6)) return false;
      const Slope mass = width * range_.mass_per_width_kg_mm;
      if (std::isfinite(cutoff_kg_) && !left_.require(cutoff_kg_ - mass, 0.0)) return false;
      cell_.width_mm = std::max(cell_.width_mm, left_.lower(width));
      const double least_kg = left_.lower(mass);
      cell_.mass_kg = std::max(cell_.mass_kg, least_kg);
      if (!most_inertia_kg_m2_) continue;
      const Slope inertia = width * range_.inertia_per_width_kg_m2_mm;
      if (!left_.require(*most_inertia_kg_m2_ - inertia, kMarginSlack * *most_inertia_kg_m2_)) {
        return false;
      }
      cell_.inertia_kg_m2 = std::max(cell_.inertia_kg_m2, left_.lower(inertia));
    }
    return true;
  }

  LayerCell& cell_;
  double cutoff_kg_;
  double widest_mm_;
  std::optional<double> most_inertia_kg_m2_;
  InnerPlace place_;
  LayerValues<Slope> range_;
  ShrinkingBox left_;
};

/// The cells of both layers, pair by pair.
class NodeBound {
 public:
  NodeBound(const InnerCase& inner, double cutoff_kg, InnerNode& node)
      : inner_(inner), cutoff_kg_(cutoff_kg), node_(node) {}

  InnerBound run_roughly() {
    if (rebound_all() && find_lightest_pair()) narrow();
    return std::move(result_);
  }

  InnerBound run() {
    if (!rebound_all()) return std::move(result_);
    constexpr int kMostSplits = 400;
    for (int split = 0; split < kMostSplits; ++split) {
      if (!find_lightest_pair()) return std::move(result_);
      const std::size_t layer = layer_to_split();
      if (result_.mass_kg >= cutoff_kg_ || layer > 1) break;
      if (!split_cell(layer, pair_[layer])) return std::move(result_);
    }
    if (!find_lightest_pair() || !bound_pairs()) return std::move(result_);
    narrow();
    return std::move(result_);
  }

 private:
  /// The second layer is the cheaper one, and its mass leaves the first less.
  bool rebound_all() { return rebound(1) && rebound(0); }

  double least_of(std::size_t layer) const {
    double least = kInfinity;
    for (const LayerCell& cell : node_.cells[layer]) least = std::min(least, cell.mass_kg);
    return least == kInfinity ? 0.0 : least;
  }

  /// All cells of a layer anew, for the node's centre distances.
  bool rebound(std::size_t layer) {
    const double cutoff_kg = cutoff_kg_ - least_of(1 - layer);
    const std::vector<LayerCell> old = std::exchange(node_.cells[layer], {});
    for (LayerCell cell : old) {
      cell.box[0] = optimization::intersect(cell.box[0], node_.centre_mm);
      add_cell(layer, cutoff_kg, cell);
    }
    return !is_without(layer);
  }

  bool is_without(std::size_t layer) {
    if (!node_.cells[layer].empty()) return false;
    result_.is_empty = true;
    if (why_) result_.empty_margin = {layer, *why_};
    return true;
  }

  /// Where something is left of it.
  void add_cell(std::size_t layer, double cutoff_kg, LayerCell cell) {
    why_.reset();
    if (!(cell.box[0].lower <= cell.box[0].upper)) return;
    CellBound bound(inner_, layer, cutoff_kg, cell);
    if (!bound.run(why_)) return;
    node_.cells[layer].push_back(cell);
    forms_[layer].push_back(bound.forms());
  }

  bool may_pair(const LayerCell& first, const LayerCell& second) const {
    if (first.box[0].lower > second.box[0].upper || second.box[0].lower > first.box[0].upper) {
      return false;
    }
    if (inner_.sun_under_second_layer &&
        sun_clearance_mm(inner_, first.box[1].upper, second.box[1].lower) < -kMarginSlack) {
      return false;
    }
    const auto& longest = inner_.max_axial_length_mm;
    const auto length = [](const LayerCell&) { return 1.0; };
    if (longest && std::max(first.width_mm + second.width_mm, stiff_sum(first, second, length)) >
                       *longest + 1e-6) {
      return false;
    }
    const auto& heaviest = inner_.max_gear_inertia_kg_m2;
    const auto inertia = [](const LayerCell& cell) { return cell.kg_m2_per_mm; };
    if (heaviest &&
        std::max(first.inertia_kg_m2 + second.inertia_kg_m2, stiff_sum(first, second, inertia)) >
            *heaviest * (1.0 + kMarginSlack)) {
      return false;
    }
    return is_efficient(first, second);
  }

  /// Of widths that are stiff enough together, the least sum by a share of a millimetre; 0 where
  /// nothing is asked of them.
  template <class Share>
  double stiff_sum(const LayerCell& first, const LayerCell& second, Share share) const {
    if (!inner_.most_softness_rad_Nm) return 0.0;
    const auto layer = [&](const LayerCell& cell, std::size_t which) {
      return LayerWidth{cell.width_mm, inner_.max_face_width_mm[which] + 1e-6,
                        cell.softness_rad_mm_Nm, share(cell)};
    };
    const double sum = least_weight({layer(first, 0), layer(second, 1)},
                                    *inner_.most_softness_rad_Nm * (1.0 + kMarginSlack));
    return sum * (1.0 - kMarginSlack);
  }

  double pair_kg(const LayerCell& first, const LayerCell& second) const {
    const auto mass = [](const LayerCell& cell) { return cell.kg_per_mm; };
    return std::max(first.mass_kg + second.mass_kg, stiff_sum(first, second, mass));
  }

  bool is_efficient(const LayerCell& first, const LayerCell& second) const {
    if (!inner_.min_forward_efficiency && !inner_.min_backward_efficiency) return true;
    // Forwards it grows with each mesh, and backwards in a single layer; backwards a / (c (a b +
    // I1)) does not fall with a, and falls with c only as (b c - I2)/c = b - I2/c grows: it grows
    // with each as well.
    const auto best =
        train_efficiencies(inner_, first.efficiency[0], first.efficiency[1], second.efficiency[0]);
    return best[0] >= inner_.min_forward_efficiency.value_or(-kInfinity) - kMarginSlack &&
           best[1] >= inner_.min_backward_efficiency.value_or(-kInfinity) - kMarginSlack;
  }

  bool find_lightest_pair() {
    double least = kInfinity;
    for (std::size_t i = 0; i < node_.cells[0].size(); ++i) {
      const LayerCell& first = node_.cells[0][i];
      for (std::size_t j = 0; j < node_.cells[1].size(); ++j) {
        const LayerCell& second = node_.cells[1][j];
        const double sum = pair_kg(first, second);
        if (sum >= least || !may_pair(first, second)) continue;
        least = sum;
        pair_ = {i, j};
      }
    }
    result_.mass_kg = least == kInfinity ? result_.mass_kg : std::max(result_.mass_kg, least);
    result_.is_empty = least == kInfinity;
    return !result_.is_empty;
  }

  /// 2: none, the centre distance is to be split. Shifts and the centre distance in modules change
  /// a mass alike, so that cells are kept about as high as they are wide.
  std::size_t layer_to_split() const {
    constexpr double kHighest = 0.7;
    std::array<double, 2> height{};
    for (const std::size_t layer : {0U, 1U}) {
      const LayerCell& cell = node_.cells[layer][pair_[layer]];
      const double width = (cell.box[0].upper - cell.box[0].lower) / inner_.module_mm[layer];
      const double shifts = cell.box[1].upper - cell.box[1].lower;
      if (shifts > 1e-9) height[layer] = shifts / std::max(width, 1e-12);
    }
    const std::size_t layer = height[0] >= height[1] ? 0 : 1;
    return height[layer] > kHighest ? layer : 2;
  }

  bool split_cell(std::size_t layer, std::size_t place) {
    std::vector<LayerCell>& cells = node_.cells[layer];
    const LayerCell whole = cells[place];
    cells[place] = cells.back();
    cells.pop_back();
    forms_[layer][place] = std::move(forms_[layer].back());
    forms_[layer].pop_back();
    const double cutoff_kg = cutoff_kg_ - least_of(1 - layer);
    for (const bool is_upper : {false, true}) {
      LayerCell half = whole;
      (is_upper ? half.box[1].lower : half.box[1].upper) = whole.box[1].middle();
      add_cell(layer, cutoff_kg, half);
    }
    return !is_without(layer);
  }

  /// Bounds every pair by both layers together, and keeps the cells that stand in one that may hold
  /// a design of interest.
  bool bound_pairs() {
    std::array<std::vector<bool>, 2> is_kept;
    for (const std::size_t layer : {0U, 1U}) is_kept[layer].resize(node_.cells[layer].size());
    double least_kg = kInfinity;
    for (std::size_t i = 0; i < node_.cells[0].size(); ++i) {
      for (std::size_t j = 0; j < node_.cells[1].size(); ++j) {
        const LayerCell& first = node_.cells[0][i];
        const LayerCell& second = node_.cells[1][j];
        const double apart_kg = pair_kg(first, second);
        if (apart_kg >= cutoff_kg_ || !may_pair(first, second)) continue;
        const LinearBound bound = bound_pair(i, j);
        const double mass_kg = std::max(bound.mass_kg, apart_kg);
        if (mass_kg >= cutoff_kg_) continue;
        is_kept[0][i] = is_kept[1][j] = true;
        if (mass_kg >= least_kg) continue;
        least_kg = mass_kg;
        result_.middle = bound.place;
      }
    }
    for (const std::size_t layer : {0U, 1U}) keep_only(is_kept[layer], node_.cells[layer]);
    result_.is_empty = least_kg == kInfinity;
    if (!result_.is_empty) result_.mass_kg = std::max(result_.mass_kg, least_kg);
    return !result_.is_empty;
  }

  static void keep_only(const std::vector<bool>& is_kept, std::vector<LayerCell>& cells) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (is_kept[i]) cells[kept++] = cells[i];
    }
    cells.resize(kept);
  }

  LinearBound bound_pair(std::size_t i, std::size_t j) const {
    const LayerCell& first = node_.cells[0][i];
    const LayerCell& second = node_.cells[1][j];
    std::vector<JointForm> joint;
    if (inner_.sun_under_second_layer) {
      joint.push_back({sun_clearance_mm(inner_, 0.0, 0.0) + kMarginSlack,
                       {0.0, inner_.module_mm[0], -inner_.module_mm[1]}});
    }
    return linear_bound(
        {&forms_[0][i], &forms_[1][j]}, joint,
        {optimization::intersect(first.box[0], second.box[0]), first.box[1], second.box[1]});
  }

  /// The centre distances that both layers leave.
  void narrow() {
    for (const auto& cells : node_.cells) {
      Interval hull{kInfinity, -kInfinity};
      for (const LayerCell& cell : cells) {
        hull.lower = std::min(hull.lower, cell.box[0].lower);
        hull.upper = std::max(hull.upper, cell.box[0].upper);
      }
      node_.centre_mm.lower = std::max(node_.centre_mm.lower, hull.lower);
      node_.centre_mm.upper = std::min(node_.centre_mm.upper, hull.upper);
    }
    if (!(node_.centre_mm.lower <= node_.centre_mm.upper)) result_.is_empty = true;
  }

  const InnerCase& inner_;
  double cutoff_kg_;
  InnerNode& node_;
  InnerBound result_;
  std::array<std::vector<LayerForms>, 2> forms_;
  std::optional<std::size_t> why_;
  std::array<std::size_t, 2> pair_{};
};

/// How far from margins points are sought: what lies on one, as corners of the shifts' range do, is
/// beyond it in `evaluate` where that rounds otherwise. Far less than kMarginSlack.
constexpr double kOffMargin = 1e-11;

/// Nothing: the widest are too soft.
std::optional<std::array<double, 2>> chosen_widths_mm(const InnerCase& inner,
                                                      const std::array<LayerWidth, 2>& layers) {
  if (!inner.most_softness_rad_Nm) return std::array{layers[0].least_mm, layers[1].least_mm};
  return stiff_widths_within_mm(layers, *inner.most_softness_rad_Nm,
                                inner.max_axial_length_mm.value_or(kInfinity));
}

}  // namespace

std::optional<double> mass_at(const InnerCase& inner, const std::array<double, 3>& point,
                              double* violation) {
  double below = 0.0, mass_kg = 0.0, length_mm = 0.0, inertia_kg_m2 = 0.0;
  std::array<LayerValues<double>, 2> layers;
  std::array<LayerWidth, 2> widths;
  const auto require = [&](double margin) {
    if (!(margin >= 0.0)) below += std::isfinite(margin) ? -margin : 10.0;
  };
  std::array<double, 4> efficiency{};
  for (const std::size_t layer : {0U, 1U}) {
    layers[layer] = layer_values(inner, layer, point[0], point[layer + 1]);
    const LayerValues<double>& values = layers[layer];
    for (const double margin : values.margins) require(margin - kOffMargin);
    widths[layer] = {greatest(values.width_mm), inner.max_face_width_mm[layer],
                     values.softness_rad_mm_Nm, values.mass_per_width_kg_mm};
  }
  const auto chosen_mm = chosen_widths_mm(inner, widths);
  if (!chosen_mm) require(1.0 - least_softness(widths) / *inner.most_softness_rad_Nm - 1e-6);
  for (const std::size_t layer : {0U, 1U}) {
    const LayerValues<double>& values = layers[layer];
    const double width_mm = chosen_mm ? (*chosen_mm)[layer] : widths[layer].least_mm;
    mass_kg += width_mm * values.mass_per_width_kg_mm;
    inertia_kg_m2 += width_mm * values.inertia_per_width_kg_m2_mm;
    length_mm += width_mm;
    require(inner.max_face_width_mm[layer] - width_mm);
    efficiency[2 * layer] = values.efficiency[0];
    efficiency[2 * layer + 1] = values.efficiency[1];
  }
  if (inner.max_axial_length_mm) require(*inner.max_axial_length_mm - length_mm);
  // Relative, as wide as the other margins are in modules.
  const auto require_most = [&](const std::optional<double>& most, double value) {
    if (most) require(1.0 - value / *most);
  };
  require_most(inner.max_mass_kg, mass_kg);
  require_most(inner.max_gear_inertia_kg_m2, inertia_kg_m2);
  if (inner.sun_under_second_layer) {
    require(sun_clearance_mm(inner, point[1], point[2]) - kOffMargin);
  }
  const auto train = train_efficiencies(inner, efficiency[0], efficiency[1], efficiency[2]);
  if (inner.min_forward_efficiency) require(train[0] - *inner.min_forward_efficiency);
  if (inner.min_backward_efficiency) require(train[1] - *inner.min_backward_efficiency);
  if (violation != nullptr) *violation = below;
  if (below > 0.0 || !std::isfinite(mass_kg)) return std::nullopt;
  return mass_kg;
}

InnerBound bound_roughly(const InnerCase& inner, double cutoff_kg, InnerNode& node) {
  return NodeBound(inner, cutoff_kg, node).run_roughly();
}

InnerBound bound_inner(const InnerCase& inner, double cutoff_kg, InnerNode& node) {
  return NodeBound(inner, cutoff_kg, node).run();
}

}  // namespace torquewright::gearbox
