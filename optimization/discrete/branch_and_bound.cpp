// SPDX-License-Identifier: Apache-2.0
#include "optimization/discrete/branch_and_bound.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <queue>

#include "optimization/discrete/branching.hpp"
#include "optimization/discrete/enumeration.hpp"
#include "optimization/discrete/propagation.hpp"
#include "optimization/discrete/relaxation.hpp"

namespace torquewright::optimization {
namespace {

// One Ipopt solve takes as long as propagation takes for so many boxes (bench/relaxation_modes.py).
constexpr std::int64_t kBoxesPerSolve = 200;
// Solves may take one part in so many of the time of a search: they have never saved more.
constexpr std::int64_t kPartsOfTime = 10;
// An ancestor's dual point still bounds a smaller box; a new one is worth a solve when the box has
// shrunk by this much. At 2, solves take most of the time; at 1000, the tree grows again.
constexpr double kShrinkage = 64.0;
constexpr std::int64_t kNodesBetweenReports = 512;

struct Node {
  std::size_t alternative;
  std::size_t place;  ///< In the alternative's proof tree.
  Box box;
  double bound;
  std::int64_t number;  ///< In the order of making: settles ties, so that runs repeat exactly.
  std::shared_ptr<const DualPoint> dual = nullptr;  ///< From an ancestor: it holds here as well.
  double dual_points = HUGE_VAL;                    ///< Points of the box it was made for.
};

struct WorseBound {
  bool operator()(const Node& a, const Node& b) const {
    return std::tie(a.bound, b.number) > std::tie(b.bound, a.number);  // later first among equals
  }
};

class Search {
 public:
  Search(std::span<const Judge> alternatives, const SearchOptions& options)
      : alternatives_(alternatives),
        options_(options),
        incumbents_(alternatives.front(), options.wanted) {
    result_.proofs.resize(alternatives.size());
    for (std::size_t i = 0; i < alternatives.size(); ++i) {
      has_shape_.push_back(has_shape(alternatives[i]));
      add_root(i);
    }
  }

  SearchResult run() {
    while (!open_.empty() && !is_over()) {
      Node node = take();
      relax(node);
      bound(node);
      if (prune(node)) continue;
      round(node);
      branch(std::move(node));
    }
    return finish();
  }

 private:
  const Judge& judge(const Node& node) const { return alternatives_[node.alternative]; }
  ProofNode& proof(const Node& node) { return result_.proofs[node.alternative][node.place]; }

  void add_root(std::size_t alternative) {
    const Box& domain = alternatives_[alternative].problem().domain;
    if (point_count(domain) == 0.0) return;
    result_.proofs[alternative].emplace_back();
    Node root{alternative, 0, domain, -HUGE_VAL, made_++};
    if (narrow(root)) {
      ++result_.nodes;
      options_.on_close(alternative, root.box, incumbents_.ceiling());
      return;
    }
    // Over the domain as it stands a cost may have no bound, and then a search that is ended before
    // it comes here has none.
    bound(root);
    open_.push(std::move(root));
  }

  bool is_over() const { return result_.nodes >= options_.max_nodes || options_.should_stop(); }

  Node take() {
    Node node = open_.top();
    open_.pop();
    if (result_.nodes++ % kNodesBetweenReports == 0) report(node.bound);
    return node;
  }

  // Shrinks the box. Returns true if that closed it.
  bool narrow(Node& node) {
    ProofNode& proof_node = proof(node);
    const auto refuting = propagate(judge(node), incumbents_.ceiling(), node.box, proof_node.cuts);
    if (!refuting) return false;
    proof_node.leaf = Leaf::kEmpty;
    proof_node.condition = *refuting;
    return true;
  }

  // Shrinks the box, then asks Ipopt about what is left of it, where that pays.
  void relax(Node& node) {
    if (narrow(node)) return;
    const bool is_worth_a_solve = pays_to_relax(node);
    if (!is_worth_a_solve && node.dual == nullptr) return;
    const Relaxation relaxation = relax_box(judge(node), node.box);
    if (node.dual != nullptr && apply_dual(node, relaxation)) return;
    if (!is_worth_a_solve) return;
    node.dual = std::make_shared<const DualPoint>(solve(relaxation, incumbents_.ceiling()));
    node.dual_points = point_count(node.box);
    ++result_.relaxations;
    apply_dual(node, relaxation);
  }

  bool pays_to_relax(const Node& node) const {
    if (is_small(node.box) || options_.relaxation == RelaxationUse::kNever) return false;
    if (options_.relaxation == RelaxationUse::kAlways) return true;
    if (!has_shape_[node.alternative]) return false;
    return point_count(node.box) * kShrinkage < node.dual_points &&
           (result_.relaxations + 1) * kBoxesPerSolve * kPartsOfTime <= made_;
  }

  // Raises the bound, or closes the box. Returns true if closed.
  bool apply_dual(Node& node, const Relaxation& relaxation) {
    const DualBound known = dual_bound(relaxation, *node.dual);
    const bool is_refuted = known.is_infeasible || known.least_cost > incumbents_.ceiling();
    node.bound = std::max(node.bound, known.least_cost);
    if (!is_refuted) return false;
    ++result_.refuted_by_relaxation;
    ProofNode& proof_node = proof(node);
    proof_node.leaf = Leaf::kRelaxation;
    proof_node.point = node.dual->point;
    for (std::size_t i = 0; i < node.box.size(); ++i) {
      const Interval range = node.box[i].interval();
      proof_node.point[i] = std::clamp(proof_node.point[i], range.lower, range.upper);
    }
    for (const RelaxedCondition& condition : relaxation.conditions) {
      const double multiplier = node.dual->multipliers[condition.condition];
      if (std::isfinite(multiplier) && multiplier > 0.0) {
        proof_node.multipliers.push_back({condition.condition, multiplier});
      }
    }
    if (!known.is_infeasible) proof_node.multipliers.push_back({kQuantity, 1.0});
    return true;
  }

  void bound(Node& node) {
    if (proof(node).leaf != Leaf::kOpen) return;
    node.bound = std::max(node.bound, judge(node).cost_over(node.box).lower);
  }

  // True when nothing is left to do here: refuted, or small enough to look at every point.
  bool prune(const Node& node) {
    ProofNode& proof_node = proof(node);
    if (proof_node.leaf == Leaf::kOpen && is_small(node.box)) {
      result_.points_enumerated += static_cast<std::int64_t>(point_count(node.box));
      for_each_point(node.box,
                     [&](std::span<const std::int64_t> point) { offer(node.alternative, point); });
      proof_node.leaf = Leaf::kEnumerated;
    }
    if (proof_node.leaf == Leaf::kOpen) return false;
    options_.on_close(node.alternative, node.box, incumbents_.ceiling());
    return true;
  }

  void offer(std::size_t alternative, std::span<const std::int64_t> point) {
    const Judge& judge = alternatives_[alternative];
    if (judge.cost_around(point).lower > incumbents_.ceiling() || !judge.is_feasible(point)) return;
    const PreciseInterval cost = judge.cost_at(point);
    if (cost.is_nowhere()) return;
    incumbents_.offer({alternative, {point.begin(), point.end()}, cost});
  }

  // A first guess at a good point: one variable after the other is fixed near the relaxation's
  // point (or the middle), and the rest follows.
  void round(const Node& node) {
    Box box = node.box;
    std::vector<Cut> unused;
    std::vector<std::int64_t> point;
    for (std::size_t i = 0; i < box.size(); ++i) {
      const double target = node.dual == nullptr ? box[i].interval().middle() : node.dual->point[i];
      const auto value = std::clamp(std::llround(target), static_cast<long long>(box[i].lower),
                                    static_cast<long long>(box[i].upper));
      box[i] = {value, value};
      if (propagate(judge(node), incumbents_.ceiling(), box, unused)) return;
      point.push_back(value);
    }
    offer(node.alternative, point);
  }

  void branch(Node node) {
    const Split split = choose_split(node.box);
    ProofTree& tree = result_.proofs[node.alternative];
    const std::size_t first_child = tree.size();
    ProofNode& parent = tree[node.place];
    parent.leaf = Leaf::kSplit;
    parent.split_variable = split.variable;
    parent.split_value = split.value;
    parent.children[0] = first_child;
    parent.children[1] = first_child + 1;
    tree.resize(first_child + 2);  // moves the nodes: `parent` is no longer valid
    open_.push({node.alternative, first_child, first_half(node.box, split), node.bound, made_++,
                node.dual, node.dual_points});
    open_.push({node.alternative, first_child + 1, second_half(std::move(node.box), split),
                node.bound, made_++, node.dual, node.dual_points});
  }

  void report(double bound) const {
    Progress progress{result_.nodes, open_.size(), incumbents_.solutions().size()};
    if (!incumbents_.solutions().empty()) {
      progress.best_cost = incumbents_.solutions().front().cost.nearest();
    }
    progress.bound = bound;
    options_.report(progress);
  }

  SearchResult finish() {
    result_.status = open_.empty() ? SearchStatus::kComplete : SearchStatus::kLimit;
    result_.solutions = incumbents_.solutions();
    if (!result_.solutions.empty()) {
      result_.bound = result_.solutions.front().cost.outward().lower;
    }
    for (; !open_.empty(); open_.pop()) {
      const Node& node = open_.top();
      const double known = std::max(node.bound, judge(node).cost_over(node.box).lower);
      result_.bound = std::min(result_.bound, known);
    }
    return std::move(result_);
  }

  std::span<const Judge> alternatives_;
  const SearchOptions& options_;
  Incumbents incumbents_;
  std::vector<bool> has_shape_;  ///< By alternative.
  std::priority_queue<Node, std::vector<Node>, WorseBound> open_;
  std::int64_t made_ = 0;
  SearchResult result_;
};

}  // namespace

SearchResult minimise(std::span<const Judge> alternatives, const SearchOptions& options) {
  if (alternatives.empty()) return {SearchStatus::kComplete, {}, HUGE_VAL, 0, 0, 0, 0, {}};
  return Search(alternatives, options).run();
}

}  // namespace torquewright::optimization
