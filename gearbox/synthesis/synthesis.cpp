// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis/synthesis.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <set>
#include <utility>

#include "gearbox/any_topology.hpp"
#include "gearbox/synthesis/inner_bound.hpp"
#include "gearbox/synthesis/local_search.hpp"

namespace torquewright::gearbox {
namespace {

using optimization::kInfinity;

constexpr std::size_t kUnopened = std::numeric_limits<std::size_t>::max();
/// Relative width of a box below which rounding decides; what is left open there keeps its bound.
constexpr double kLeastWidth = 1e-10;
/// Parts of a slice's shifts to begin with.
constexpr int kCells = 5;

/// A choice that is not opened yet, or a part of one that is.
struct Node {
  double bound_kg = 0.0;
  std::size_t choice = 0;
  std::size_t part = kUnopened;
};

struct HeavierLast {
  bool operator()(const Node& a, const Node& b) const {
    if (a.bound_kg != b.bound_kg) return a.bound_kg > b.bound_kg;
    return a.choice != b.choice ? a.choice > b.choice : a.part > b.part;
  }
};

class Search {
 public:
  Search(const Problem& problem, const SynthesisOptions& options)
      : problem_(problem),
        options_(options),
        modules_(layer_modules(problem)),
        gap_(io::nearest(problem.synthesis->gap)),
        choices_(train_choices(problem, modules_, options.max_choices)) {}

  SynthesisResult run() {
    result_.choices = static_cast<std::int64_t>(choices_.size());
    const bool is_whole = choices_.size() <= options_.max_choices;
    sort_choices();
    seek_early_designs();
    for (std::size_t i = 0; i < choices_.size(); ++i) queue_.push({0.0, i, kUnopened});
    bool is_ended = !is_whole;
    while (!is_ended && !queue_.empty() && queue_.top().bound_kg < cutoff_kg()) {
      is_ended = options_.should_stop() ||
                 (options_.max_boxes > 0 && result_.boxes >= options_.max_boxes) ||
                 (options_.any && result_.best);
      if (!is_ended) step();
    }
    finish(is_ended, is_whole);
    return std::move(result_);
  }

 private:
  double best_kg() const { return result_.best ? result_.best->mass_kg : kInfinity; }
  /// What is not lighter by more than the gap is of no interest, nor what is too heavy.
  double cutoff_kg() const {
    if (result_.best) return best_kg() * (1.0 - gap_);
    const auto& most_kg = problem_.floors.mass_kg;
    return most_kg ? io::nearest(*most_kg) * (1.0 + 1e-9) : kInfinity;
  }

  /// By what they weigh with ordinary shifts, so that light designs are found soon.
  void sort_choices() {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < choices_.size(); ++i) {
      const InnerCase inner = inner_case(problem_, modules_, choices_[i]);
      order.emplace_back(ordinary_mass_kg(inner), i);
    }
    std::sort(order.begin(), order.end());
    std::vector<TrainChoice> sorted;
    for (const auto& [mass_kg, place] : order) sorted.push_back(choices_[place]);
    choices_ = std::move(sorted);
  }

  void step() {
    const Node node = queue_.top();
    queue_.pop();
    const InnerCase inner = inner_case(problem_, modules_, choices_[node.choice]);
    if (node.part == kUnopened) return open(node.choice, inner);
    InnerNode part = take(node.part);
    const InnerBound bound = bounded(inner, part, bound_inner);
    if (bound.is_empty) return;
    const double bound_kg = std::max(node.bound_kg, bound.mass_kg * (1.0 - 1e-9));
    if (bound_kg >= cutoff_kg()) return;
    seek_design(node.choice, inner, part, bound);
    if (bound_kg < cutoff_kg()) split(node.choice, part, bound_kg);
  }

  using Bound = InnerBound (*)(const InnerCase&, double, InnerNode&);

  InnerBound bounded(const InnerCase& inner, InnerNode& part, Bound bound) {
    ++result_.boxes;
    if (result_.boxes % 256 == 0) report();
    return bound(inner, cutoff_kg(), part);
  }

  /// Slices of the centre distance that are narrow enough for bounds to say something; of most
  /// choices that no design can be made of, a rough bound of the whole says so.
  void open(std::size_t choice, const InnerCase& inner) {
    ++result_.opened;
    const auto whole = inner_box(problem_, inner);
    if (!whole) return exclude("profile_shift");
    InnerNode all = whole_node(*whole, inner.has_second_layer, 1);
    const InnerBound rough = bounded(inner, all, bound_roughly);
    std::set<std::string> reasons;
    if (is_of_interest(rough)) {
      open_slices(choice, inner, {all.centre_mm, (*whole)[1]}, reasons);
    } else {
      reasons.insert(reason_of(inner, rough));
    }
    if (reasons.size() == 1 && !reasons.begin()->empty()) exclude(*reasons.begin());
  }

  void open_slices(std::size_t choice, const InnerCase& inner, const InnerBox& whole,
                   std::set<std::string>& reasons) {
    constexpr double kSlice = 0.3;  // In modules.
    const double width = whole[0].upper - whole[0].lower;
    const int slices =
        std::max(1, static_cast<int>(std::ceil(width / (kSlice * inner.module_mm[0]))));
    for (int i = 0; i < slices; ++i) {
      const double step = width / slices;
      InnerBox box = whole;
      box[0].lower = whole[0].lower + i * step;
      if (i + 1 < slices) box[0].upper = whole[0].lower + (i + 1) * step;
      InnerNode part = whole_node(box, inner.has_second_layer, kCells);
      const InnerBound bound = bounded(inner, part, bound_inner);
      reasons.insert(reason_of(inner, bound));
      if (!is_of_interest(bound)) continue;
      queue_.push({bound.mass_kg * (1.0 - 1e-9), choice, keep(std::move(part))});
    }
  }

  bool is_of_interest(const InnerBound& bound) const {
    return !bound.is_empty && bound.mass_kg * (1.0 - 1e-9) < cutoff_kg();
  }

  /// The margin that leaves nothing of a part; none: it takes more than one, or the mass.
  static std::string reason_of(const InnerCase& inner, const InnerBound& bound) {
    if (!bound.is_empty || !bound.empty_margin) return "";
    const auto [layer, margin] = *bound.empty_margin;
    return margin_names(inner, layer)[margin];
  }

  static InnerNode whole_node(const InnerBox& box, bool has_second_layer, int parts) {
    InnerNode node{box[0], {}};
    const double step = (box[1].upper - box[1].lower) / parts;
    for (int i = 0; i < parts; ++i) {
      LayerCell cell{.box = box};
      cell.box[1].lower = box[1].lower + i * step;
      if (i + 1 < parts) cell.box[1].upper = box[1].lower + (i + 1) * step;
      for (auto& cells : node.cells) cells.push_back(cell);
    }
    if (!has_second_layer) node.cells[1] = {LayerCell{.box = {box[0], Interval{0.0, 0.0}}}};
    return node;
  }

  void split(std::size_t choice, const InnerNode& part, double bound_kg) {
    const Interval& range = part.centre_mm;
    if (!(range.upper - range.lower > kLeastWidth * range.upper)) {
      undecided_kg_ = std::min(undecided_kg_, bound_kg);
      return;
    }
    for (const bool is_upper : {false, true}) {
      InnerNode half = part;
      (is_upper ? half.centre_mm.lower : half.centre_mm.upper) = range.middle();
      queue_.push({bound_kg, choice, keep(std::move(half))});
    }
  }

  std::size_t keep(InnerNode part) {
    if (free_.empty()) {
      parts_.push_back(std::move(part));
      return parts_.size() - 1;
    }
    const std::size_t place = free_.back();
    free_.pop_back();
    parts_[place] = std::move(part);
    return place;
  }

  InnerNode take(std::size_t place) {
    free_.push_back(place);
    return std::exchange(parts_[place], {});
  }

  /// A good mass to begin with lets most boxes go unsplit.
  void seek_early_designs() {
    constexpr std::size_t kMost = 40;
    for (std::size_t i = 0; i < choices_.size() && i < kMost; ++i) {
      const InnerCase inner = inner_case(problem_, modules_, choices_[i]);
      const auto whole = inner_box(problem_, inner);
      if (whole) seek_from(i, inner, {(*whole)[0].middle(), 0.3, 0.3}, kFarStep);
    }
  }

  /// From the middle of a part: where it is better than what is known, and at a choice's first,
  /// second, fourth, eighth ... part. A bound's place lies on margins, or beyond by what rounding
  /// may make of them, so that it is no design where the lightest one lies in a corner; from there
  /// designs are sought no farther away than the part is wide.
  void seek_design(std::size_t choice, const InnerCase& inner, const InnerNode& part,
                   const InnerBound& bound) {
    const auto middle_kg = mass_at(inner, bound.middle);
    const bool is_better = middle_kg && *middle_kg < best_kg();
    const std::uint32_t count = ++parts_bounded_[choice];
    if (count == 1 || is_better) seek_from(choice, inner, bound.middle, kFarStep);
    if (count == 1 || !std::has_single_bit(count)) return;
    const InnerBox whole = *inner_box(problem_, inner);
    const double share = width_of(part.centre_mm) / width_of(whole[0]);
    seek_from(choice, inner, bound.middle, std::clamp(share, 1e-8, kFarStep));
  }

  static double width_of(const Interval& range) { return range.upper - range.lower; }

  void seek_from(std::size_t choice, const InnerCase& inner, const std::array<double, 3>& start,
                 double step) {
    const InnerBox whole = *inner_box(problem_, inner);
    // Only what is near the best is worth more.
    std::optional<InnerPoint> found;
    std::array<double, 3> from = start;
    for (const auto& [trials, near] : {std::pair{60, 1.3}, {300, 1.03}, {2000, 1.0}}) {
      found = light_point(inner, whole, from, trials, step);
      if (!found && trials > 60) return;
      if (!found) continue;
      if (found->mass_kg >= near * best_kg()) return;
      from = found->point;
    }
    SizedDesign sized = sized_design(problem_, modules_, choices_[choice], found->point);
    if (!sized.objection.empty() || sized.mass_kg >= best_kg()) return;
    result_.best = std::move(sized);
    report();
  }

  void exclude(const std::string& name) { ++result_.excluded_by[name]; }
  double bound_now_kg() const {
    const double open_kg = queue_.empty() ? kInfinity : queue_.top().bound_kg;
    return std::min({open_kg, undecided_kg_, cutoff_kg()});
  }

  void report() {
    options_.report({result_.boxes, static_cast<std::int64_t>(queue_.size()),
                     result_.best ? std::optional(best_kg()) : std::nullopt, bound_now_kg()});
  }

  void finish(bool is_ended, bool is_whole) {
    result_.bound_kg = is_whole ? bound_now_kg() : 0.0;
    const bool is_closed = result_.best && result_.bound_kg >= best_kg() * (1.0 - gap_);
    if (is_closed && is_whole) {
      result_.status = SynthesisStatus::kOptimal;
    } else if (!is_ended && !result_.best && undecided_kg_ == kInfinity) {
      result_.status = SynthesisStatus::kInfeasible;
      result_.bound_kg = kInfinity;
    }
  }

  const Problem& problem_;
  const SynthesisOptions& options_;
  LayerModules modules_;
  double gap_;
  std::vector<TrainChoice> choices_;
  std::priority_queue<Node, std::vector<Node>, HeavierLast> queue_;
  std::vector<InnerNode> parts_;
  std::vector<std::size_t> free_;
  std::vector<std::uint32_t> parts_bounded_ = std::vector<std::uint32_t>(choices_.size());
  double undecided_kg_ = kInfinity;
  SynthesisResult result_;
};

/// One topology after the other; the answer is over all of them.
class TopologySearch {
 public:
  TopologySearch(const Problem& problem, const SynthesisOptions& options)
      : problem_(problem), options_(options) {
    all_.bound_kg = kInfinity;
  }

  SynthesisResult run() {
    for (const TrainParts& parts : all_train_parts()) {
      add(parts.name, found_of(as_topology(problem_, parts)));
      if (options_.any && all_.best) break;
    }
    judge();
    return std::move(all_);
  }

 private:
  /// Of a topology that no box is left for nothing is known.
  SynthesisResult found_of(const Problem& problem) const {
    SynthesisOptions options = options_;
    if (options.max_boxes > 0 && (options.max_boxes -= all_.boxes) <= 0) return {};
    return Search(problem, options).run();
  }

  void add(std::string_view name, SynthesisResult found) {
    TopologyAnswer answer{std::string(name), found.status,  {},
                          found.bound_kg,    found.choices, found.excluded_by};
    if (found.best) answer.mass_kg = found.best->mass_kg;
    all_.topologies.push_back(std::move(answer));
    all_.bound_kg = std::min(all_.bound_kg, found.bound_kg);
    all_.choices += found.choices;
    all_.opened += found.opened;
    all_.boxes += found.boxes;
    for (const auto& [margin, count] : found.excluded_by) all_.excluded_by[margin] += count;
    const bool is_lighter = found.best && (!all_.best || found.best->mass_kg < all_.best->mass_kg);
    if (is_lighter) all_.best = std::move(found.best);
  }

  void judge() {
    const bool is_none = std::all_of(
        all_.topologies.begin(), all_.topologies.end(),
        [](const TopologyAnswer& answer) { return answer.status == SynthesisStatus::kInfeasible; });
    const double gap = io::nearest(problem_.synthesis->gap);
    const bool is_whole = all_.topologies.size() == all_train_parts().size();
    if (is_none) {
      all_.status = SynthesisStatus::kInfeasible;
    } else if (is_whole && all_.best && all_.bound_kg >= all_.best->mass_kg * (1.0 - gap)) {
      all_.status = SynthesisStatus::kOptimal;
    }
  }

  const Problem& problem_;
  const SynthesisOptions& options_;
  SynthesisResult all_;
};

}  // namespace

SynthesisResult synthesise(const Problem& problem, const SynthesisOptions& options) {
  if (is_topology_open(problem)) return TopologySearch(problem, options).run();
  return Search(problem, options).run();
}

}  // namespace torquewright::gearbox
