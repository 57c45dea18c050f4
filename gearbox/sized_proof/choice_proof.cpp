// SPDX-License-Identifier: Apache-2.0
#include "gearbox/sized_proof/choice_proof.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "gearbox/sized_proof/enclosures/weighted_sum.hpp"
#include "gearbox/sized_proof/layer_cell.hpp"
#include "gearbox/sized_proof/soft_layers.hpp"
#include "gearbox/train/central_gears.hpp"

namespace torquewright::gearbox::sized {
namespace {

constexpr double kShare = 1e-9;  ///< What is forgiven of a limit.

/// Cells of both layers for a range of centre distances; designs lie in pairs of them.
struct Node {
  Range centre_mm;
  std::array<std::vector<LayerCell>, 2> cells;
};

class ChoiceProof {
 public:
  ChoiceProof(const TrainParts& parts, const WholeNumbers& whole, const LoadedTeeth& teeth,
              const SizedClaim& claim, ProofEffort& effort)
      : parts_(parts), teeth_(teeth), claim_(claim), effort_(effort) {
    for (const std::int64_t count : teeth_in_order(parts, whole)) {
      real_teeth_.push_back(static_cast<double>(count));
    }
    demands_.efficiency = claim.forward_efficiency || claim.backward_efficiency;
    demands_.inertia = claim.reflected_inertia_kg_m2.has_value();
    demands_.hollow_shaft_mm = claim.hollow_shaft_mm;
    if (demands_.inertia) {
      most_kg_m2_ = *claim.reflected_inertia_kg_m2 - teeth.ratio * teeth.ratio * teeth.rotor_kg_m2;
    }
  }

  bool run() {
    const CentreRange centre = centre_range(teeth_);
    if (!(centre.low_mm <= centre.high_mm) || most_kg_m2_ < 0.0) return true;
    Node whole{{centre.low_mm, centre.high_mm}, {}};
    const CellBox box{whole.centre_mm, Range{teeth_.least_shift, teeth_.greatest_shift}};
    for (auto& cells : whole.cells) cells = {LayerCell{.box = box}};
    if (!teeth_.has_second_layer()) whole.cells[1] = {no_layer(whole.centre_mm)};
    if (!bound_all(whole)) return true;
    return holds_of_slices(whole);
  }

 private:
  LayerCell no_layer(const Range& centre_mm) const {
    LayerCell cell{.box = {centre_mm, Range{}}};
    cell.masses.push_back({});
    return cell;
  }

  /// Wide boxes say little: slices and parts to begin with.
  bool holds_of_slices(const Node& whole) {
    constexpr double kSlice = 0.3;  // In modules, as shifts are.
    const auto parts_of = [&](double width) {
      return std::max(1, static_cast<int>(std::ceil(width / kSlice)));
    };
    const int slices = parts_of(whole.centre_mm.width() / teeth_.module_mm[0]);
    for (int i = 0; i < slices; ++i) {
      Node slice{part(whole.centre_mm, i, slices), {}};
      for (const std::size_t layer : {0U, 1U}) {
        for (const LayerCell& cell : whole.cells[layer]) {
          const int count =
              layer == 1 && !teeth_.has_second_layer() ? 1 : parts_of(cell.box[1].width());
          for (int j = 0; j < count; ++j) {
            LayerCell piece = cell;
            piece.box[1] = part(cell.box[1], j, count);
            slice.cells[layer].push_back(std::move(piece));
          }
        }
      }
      if (!holds_of(std::move(slice))) return false;
    }
    return true;
  }

  static Range part(const Range& range, int which, int count) {
    const double step = range.width() / count;
    return {range.low + which * step,
            which + 1 == count ? range.high : range.low + (which + 1) * step};
  }

  bool holds_of(Node node) {
    if (!bound_all(node)) return true;
    constexpr int kMostRounds = 12;
    for (int round = 0; round < kMostRounds; ++round) {
      if (!keep_open_pairs(node)) return true;
      if (is_contradicted(node)) return false;
      if (!split_tall_cells(node)) break;
    }
    return holds_of_halves(node);
  }

  /// By a lighter design amid the first pair of cells that is open, or by more cells than a true
  /// claim leaves: where designs of interest fill a box, no splitting closes it.
  bool is_contradicted(const Node& node) const {
    constexpr std::size_t kMostCells = 3000;
    if (node.cells[0].size() + node.cells[1].size() > kMostCells) return true;
    const CellBox& first = first_open_[0];
    const CellBox& second = first_open_[1];
    const double centre_mm =
        0.5 * (std::max(first[0].low, second[0].low) + std::min(first[0].high, second[0].high));
    return is_lighter_design({centre_mm, first[1].middle(), second[1].middle()});
  }

  /// Of numbers, not of enclosures: it ends a proof, it makes none.
  bool is_lighter_design(const std::array<double, kPlaces>& point) const {
    double kg = 0.0, mm = 0.0, kg_m2 = 0.0, soft = 0.0;
    std::array<double, 3> efficiency{1.0, 1.0, 1.0};
    for (std::size_t layer = 0; layer < (teeth_.has_second_layer() ? 2U : 1U); ++layer) {
      const auto terms = layer_terms(teeth_, layer, point[0], point[1 + layer], demands_);
      for (const double margin : terms.margins) {
        if (!(margin >= 0.0)) return false;
      }
      double width_mm = 0.0;
      for (const double each : terms.width_mm) {
        if (!(each < kInfinity)) return false;
        width_mm = std::max(width_mm, each);
      }
      if (width_mm > teeth_.widest_mm[layer]) return false;
      kg += width_mm * terms.kg_per_mm;
      if (demands_.inertia) kg_m2 += width_mm * terms.kg_m2_per_mm;
      mm += width_mm;
      soft += terms.softness / width_mm;
      if (layer == 0) efficiency[0] = terms.efficiency[0];
      efficiency[1 + layer] = terms.efficiency[1];
    }
    const bool is_clear =
        !teeth_.is_sun_below || sun_clearance_mm(teeth_, point[1], point[2]) > 0.0;
    if (teeth_.least_Nm_rad && soft * *teeth_.least_Nm_rad > 1.0) return false;
    return is_clear && kg < claim_.bound_kg && kg_m2 <= most_kg_m2_ &&
           (!claim_.axial_length_mm || mm <= *claim_.axial_length_mm) &&
           (!demands_.efficiency || is_efficient(efficiency, 0.0));
  }

  bool holds_of_halves(const Node& node) {
    Range centre_mm{kInfinity, -kInfinity};
    for (const LayerCell& cell : node.cells[0]) {
      centre_mm.low = std::min(centre_mm.low, cell.box[0].low);
      centre_mm.high = std::max(centre_mm.high, cell.box[0].high);
    }
    constexpr double kNarrowest = 1e-10;
    if (effort_.is_ended || !(centre_mm.width() > kNarrowest * centre_mm.high)) return false;
    for (const int half : {0, 1}) {
      Node part_of = node;
      part_of.centre_mm = part(centre_mm, half, 2);
      if (!holds_of(std::move(part_of))) return false;
    }
    return true;
  }

  /// False: a layer has nothing left. The second layer first: it is the cheaper one.
  bool bound_all(Node& node) {
    for (const std::size_t layer : {1U, 0U}) {
      if (layer == 1 && !teeth_.has_second_layer()) {
        node.cells[1] = {no_layer(node.centre_mm)};
        continue;
      }
      const LayerLimits limits = limits_beside(node, 1 - layer);
      std::vector<LayerCell>& cells = node.cells[layer];
      std::erase_if(cells, [&](LayerCell& cell) {
        cell.box[0].low = std::max(cell.box[0].low, node.centre_mm.low);
        cell.box[0].high = std::min(cell.box[0].high, node.centre_mm.high);
        return !(cell.box[0].low <= cell.box[0].high) || !bound(layer, limits, cell);
      });
      if (cells.empty()) return false;
    }
    return true;
  }

  bool bound(std::size_t layer, const LayerLimits& limits, LayerCell& cell) {
    ++effort_.boxes;
    if (effort_.most_boxes > 0 && effort_.boxes > effort_.most_boxes) effort_.is_ended = true;
    if (effort_.boxes % 64 == 0 && effort_.should_stop()) effort_.is_ended = true;
    return bound_cell(teeth_, layer, demands_, limits, cell);
  }

  /// What the other layer leaves, at its least.
  LayerLimits limits_beside(const Node& node, std::size_t other) const {
    double kg = kInfinity, kg_m2 = kInfinity;
    for (const LayerCell& cell : node.cells[other]) {
      kg = std::min(kg, cell.least_kg);
      kg_m2 = std::min(kg_m2, cell.least_kg_m2);
    }
    return {claim_.bound_kg - kg, most_kg_m2_ - kg_m2};
  }

  /// Keeps the cells of pairs that are not closed; false: all are.
  bool keep_open_pairs(Node& node) {
    std::array<std::vector<bool>, 2> is_open;
    for (const std::size_t layer : {0U, 1U}) is_open[layer].resize(node.cells[layer].size());
    bool is_any = false;
    for (std::size_t i = 0; i < node.cells[0].size(); ++i) {
      for (std::size_t j = 0; j < node.cells[1].size(); ++j) {
        if (is_closed(node.cells[0][i], node.cells[1][j])) continue;
        if (!is_any) first_open_ = {node.cells[0][i].box, node.cells[1][j].box};
        is_open[0][i] = is_open[1][j] = is_any = true;
      }
    }
    for (const std::size_t layer : {0U, 1U}) {
      std::size_t place = 0;
      std::erase_if(node.cells[layer], [&](const LayerCell&) { return !is_open[layer][place++]; });
    }
    return is_any;
  }

  bool is_closed(const LayerCell& first, const LayerCell& second) const {
    const Range centre_mm{std::max(first.box[0].low, second.box[0].low),
                          std::min(first.box[0].high, second.box[0].high)};
    if (!(centre_mm.low <= centre_mm.high)) return true;
    if (first.least_kg + second.least_kg >= claim_.bound_kg) return true;
    if (is_too_soft(first, second)) return true;
    if (is_sun_in_the_way(first, second) || is_too_long(first, second) ||
        is_too_inert(first, second) || is_too_lossy(first, second)) {
      return true;
    }
    return is_outweighed(first, second, centre_mm);
  }

  /// Where faces that are stiff enough are too heavy, too long or too inert, or none are.
  bool is_too_soft(const LayerCell& first, const LayerCell& second) const {
    if (!teeth_.least_Nm_rad) return false;
    const auto least = [&](double LayerCell::*share) {
      const auto layer = [&](const LayerCell& cell, std::size_t which) {
        return SoftLayer{cell.least_mm, teeth_.widest_mm[which] * (1.0 + kShare) + 1e-6,
                         cell.least_softness, share == nullptr ? 1.0 : cell.*share};
      };
      return least_sum({layer(first, 0), layer(second, 1)}, *teeth_.least_Nm_rad * (1.0 - kShare));
    };
    return least(&LayerCell::least_kg_per_mm) >= claim_.bound_kg ||
           (claim_.axial_length_mm &&
            least(nullptr) > *claim_.axial_length_mm * (1.0 + kShare) + 1e-6) ||
           (demands_.inertia &&
            least(&LayerCell::least_kg_m2_per_mm) > most_kg_m2_ * (1.0 + kShare));
  }

  bool is_sun_in_the_way(const LayerCell& first, const LayerCell& second) const {
    return teeth_.is_sun_below &&
           sun_clearance_mm(teeth_, first.box[1].high, second.box[1].low) < -kForgiven;
  }
  bool is_too_long(const LayerCell& first, const LayerCell& second) const {
    return claim_.axial_length_mm &&
           first.least_mm + second.least_mm > *claim_.axial_length_mm * (1.0 + kShare) + 1e-6;
  }
  bool is_too_inert(const LayerCell& first, const LayerCell& second) const {
    return first.least_kg_m2 + second.least_kg_m2 > most_kg_m2_ * (1.0 + kShare);
  }
  /// A train loses less where a mesh does.
  bool is_too_lossy(const LayerCell& first, const LayerCell& second) const {
    return demands_.efficiency &&
           !is_efficient({first.efficiency[0], first.efficiency[1], second.efficiency[1]}, kShare);
  }
  /// Of the meshes with the sun, and with the ring of each layer.
  bool is_efficient(const std::array<double, 3>& efficiency, double slack) const {
    std::vector<double> meshes;
    for (const gearbox::MeshedGears& mesh : parts_.meshes) {
      const std::size_t layer = parts_.gear_layers[mesh.gear_2];
      meshes.push_back(efficiency[parts_.is_ring(mesh.gear_2) ? 1 + layer : 0]);
      if (!(meshes.back() > 0.0)) return false;
    }
    const TrainEfficiency best = train_efficiency(parts_, real_teeth_, meshes);
    return best.forward >= claim_.forward_efficiency.value_or(-1.0) - slack &&
           best.backward >= claim_.backward_efficiency.value_or(-1.0) - slack;
  }

  bool is_outweighed(const LayerCell& first, const LayerCell& second,
                     const Range& centre_mm) const {
    const std::array<Range, kPlaces> box{centre_mm, first.box[1], second.box[1]};
    std::vector<LinearTerm> terms;
    add_terms(first, TermKind::kFirstLayer, box, terms);
    add_terms(second, TermKind::kSecondLayer, box, terms);
    if (teeth_.is_sun_below) terms.push_back(sun_term(box));
    const bool is_none = !(claim_.bound_kg < kInfinity);
    const double least = weigh(terms, is_none ? 0.0 : claim_.bound_kg).least;
    return is_none ? least > 0.0 : least >= claim_.bound_kg;
  }

  /// Where no mass is asked for, a layer counts how far it misses a condition.
  void add_terms(const LayerCell& cell, TermKind layer, const std::array<Range, kPlaces>& box,
                 std::vector<LinearTerm>& terms) const {
    const bool is_none = !(claim_.bound_kg < kInfinity);
    const std::size_t shift = layer == TermKind::kFirstLayer ? 1 : 2;
    const auto add = [&](const PlacedForm& form, TermKind kind) {
      LinearTerm term{kind, form.constant, {}};
      double size = std::abs(form.constant);
      for (std::size_t i = 0; i < kVariables; ++i) {
        const Range& range = box[i == 0 ? 0 : shift];
        const double middle = 0.5 * (range.low + range.high);
        const double moved = form.slope[i] * (middle - form.reference[i]);
        const double half = std::max(range.high - middle, middle - range.low);
        term.constant += moved;
        term.slope[i == 0 ? 0 : shift] = form.slope[i] * half;
        size += std::abs(moved) + std::abs(form.slope[i]) * (half + kRounding * std::abs(middle));
      }
      term.constant -= 16.0 * kRounding * size;
      terms.push_back(term);
    };
    if (is_none) {
      terms.push_back({layer, 0.0, {}});
    } else {
      for (const PlacedForm& form : cell.masses) add(form, layer);
    }
    for (const PlacedForm& form : cell.conditions)
      add(form, is_none ? layer : TermKind::kCondition);
  }

  /// Below 0 where the sun clears planet 2.
  LinearTerm sun_term(const std::array<Range, kPlaces>& box) const {
    LinearTerm term;
    const double clearance_mm = sun_clearance_mm(teeth_, box[1].middle(), box[2].middle());
    term.constant = -clearance_mm - kForgiven - 1e-12 * (1.0 + std::abs(clearance_mm));
    term.slope = {0.0, -0.5 * teeth_.module_mm[0] * box[1].width() * (1.0 + 1e-12),
                  0.5 * teeth_.module_mm[1] * box[2].width() * (1.0 + 1e-12)};
    return term;
  }

  /// Cells are kept about as high as they are wide; false: none is too high.
  bool split_tall_cells(Node& node) {
    constexpr double kHighest = 0.7;
    bool is_any = false;
    for (const std::size_t layer : {0U, 1U}) {
      const LayerLimits limits = limits_beside(node, 1 - layer);
      std::vector<LayerCell> kept;
      for (LayerCell& cell : node.cells[layer]) {
        const double across = cell.box[0].width() / teeth_.module_mm[layer];
        const double height = cell.box[1].width();
        if (!(height > 1e-9) || !(height > kHighest * across) || effort_.is_ended) {
          kept.push_back(std::move(cell));
          continue;
        }
        is_any = true;
        for (const int half : {0, 1}) {
          LayerCell piece = cell;
          piece.box[1] = part(cell.box[1], half, 2);
          if (bound(layer, limits, piece)) kept.push_back(std::move(piece));
        }
      }
      node.cells[layer] = std::move(kept);
    }
    return is_any;
  }

  const TrainParts& parts_;
  const LoadedTeeth& teeth_;
  const SizedClaim& claim_;
  ProofEffort& effort_;
  Demands demands_;
  std::vector<double> real_teeth_;
  double most_kg_m2_ = kInfinity;
  std::array<CellBox, 2> first_open_{};  ///< Of the last node that was asked.
};

}  // namespace

bool holds_of_choice(const TrainParts& parts, const WholeNumbers& whole, const LoadedTeeth& teeth,
                     const SizedClaim& claim, ProofEffort& effort) {
  return ChoiceProof(parts, whole, teeth, claim, effort).run();
}

}  // namespace torquewright::gearbox::sized
