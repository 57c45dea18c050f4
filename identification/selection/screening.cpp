// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/screening.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "optimization/fit/least_squares_in_box.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kPaired = 14;  ///< Candidates of which pairs are made.
constexpr std::size_t kTeeth = 4;    ///< Waves of a comb.

/// A candidate at one of its starts, beside the model.
struct ScreenTrial {
  const EffectCandidate* candidate = nullptr;
  std::vector<double> start;
  Eigen::VectorXd offset;  ///< (n) What the start itself changes.
  Eigen::MatrixXd slopes;  ///< (n x q)
  Eigen::VectorXd sizes;   ///< (q) Of the parameters.
  double loss = 0.0;
  Eigen::VectorXd move;  ///< (q) From the start.
};

struct Solution {
  Eigen::VectorXd move;
  double loss = 0.0;
};

class Screen {
 public:
  Screen(const ModelFitter& fitter, const ModelFit& model, const EffectSet& candidates,
         double least_change_rms)
      : fitter_(fitter), model_(model), least_change_rms_(least_change_rms) {
    training_ = Eigen::VectorXd::Zero(fitter.rows().count());
    for (const Rows::Block& block : fitter.rows().blocks()) {
      if (!block.is_held_out()) training_.segment(block.begin, block.count).setOnes();
    }
    own_ = training_.asDiagonal() *
           fitter.slopes(model.members, model.coordinates, model.residual, fitter.rows().signals());
    for (Eigen::Index k = 0; k < own_.cols(); ++k) {
      if (!model.is_free[static_cast<std::size_t>(k)]) own_.col(k).setZero();
    }
    for (const EffectCandidate* each : candidates) {
      if (std::find(model.members.begin(), model.members.end(), each) != model.members.end())
        continue;
      try_starts(*each);
    }
  }

  Screening take(bool with_pairs) {
    std::sort(best_.begin(), best_.end(),
              [](const ScreenTrial& a, const ScreenTrial& b) { return a.loss < b.loss; });
    for (const ScreenTrial& trial : best_) {
      result_.singles.push_back({{trial.candidate}, start_of({&trial}, {trial.move}), trial.loss});
    }
    if (with_pairs) {
      add_pairs();
      add_combs();
    }
    return std::move(result_);
  }

 private:
  Eigen::VectorXd coordinates_with(const std::vector<double>& start) const {
    Eigen::VectorXd all(model_.coordinates.size() + static_cast<Eigen::Index>(start.size()));
    all << model_.coordinates,
        Eigen::Map<const Eigen::VectorXd>(start.data(), static_cast<Eigen::Index>(start.size()));
    return all;
  }

  void try_starts(const EffectCandidate& candidate) {
    ScreenTrial best;
    bool is_moved = false;
    const auto take = [&](const ScreenTrial& trial) {
      is_moved = is_moved || moves(trial);
      const bool is_better = best.candidate == nullptr || trial.loss < best.loss;
      if (trial.candidate != nullptr && is_better) best = trial;
    };
    for (const std::vector<double>& start : candidate.starts) {
      const ScreenTrial trial = tried(candidate, start);
      take(trial);
      // A law that takes the place of another starts from nothing, where meshes may drive that are
      // driven beside it: the estimate is made once more from where it leads.
      const bool is_far = trial.candidate != nullptr && trial.offset.norm() > least_change();
      if (is_far) take(tried(candidate, moved_start(trial, trial.move)));
    }
    if (!is_moved || best.candidate == nullptr) {
      result_.silent.push_back(&candidate);
    } else {
      best_.push_back(std::move(best));
    }
  }

  /// Without a candidate where it is no number.
  ScreenTrial tried(const EffectCandidate& candidate, const std::vector<double>& start) const {
    EffectSet members = model_.members;
    members.push_back(&candidate);
    const auto count = static_cast<Eigen::Index>(candidate.parameters.size());
    ScreenTrial trial;
    trial.start = start;
    const Eigen::VectorXd at = coordinates_with(start);
    const Eigen::VectorXd here = fitter_.residual(members, at);
    trial.offset = training_.asDiagonal() * (here - model_.residual);
    trial.slopes.resize(here.size(), count);
    trial.sizes.resize(count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const FitParameter& parameter = candidate.parameters[static_cast<std::size_t>(k)];
      const Eigen::Index place = model_.coordinates.size() + k;
      double step = 1e-4 * parameter.size;
      if (at[place] + step > parameter.highest) step = -step;
      Eigen::VectorXd moved = at;
      moved[place] += step;
      trial.slopes.col(k) =
          training_.asDiagonal() * ((fitter_.residual(members, moved) - here) / step);
      trial.sizes[k] = parameter.size;
    }
    if (!trial.offset.allFinite() || !trial.slopes.allFinite()) return trial;
    trial.candidate = &candidate;
    evaluate(trial);
    return trial;
  }

  /// Whether it changes the prediction, or a sensible size of one of its parameters does.
  bool moves(const ScreenTrial& trial) const {
    return trial.offset.norm() > least_change() ||
           (trial.slopes.colwise().norm().transpose().cwiseProduct(trial.sizes).array() >
            least_change())
               .any();
  }

  double least_change() const { return least_change_rms_ * std::sqrt(training_.sum()); }

  void evaluate(ScreenTrial& trial) const {
    const Solution solution = solved({&trial});
    trial.loss = solution.loss;
    trial.move = solution.move.tail(trial.slopes.cols());
  }

  /// The model's columns, then those of the trials, all beside one another.
  Solution solved(const std::vector<const ScreenTrial*>& trials) const {
    Eigen::Index p = own_.cols();
    Eigen::VectorXd residual = training_.asDiagonal() * model_.residual;
    for (const ScreenTrial* trial : trials) {
      p += trial->slopes.cols();
      residual += trial->offset;
    }
    Eigen::MatrixXd columns(residual.size(), p);
    columns.leftCols(own_.cols()) = own_;
    Eigen::VectorXd lowest = Eigen::VectorXd::Constant(p, -1e300), highest = -lowest;
    Eigen::Index at = own_.cols();
    for (const ScreenTrial* trial : trials) {
      columns.middleCols(at, trial->slopes.cols()) = trial->slopes;
      for (Eigen::Index k = 0; k < trial->slopes.cols(); ++k, ++at) {
        const auto index = static_cast<std::size_t>(k);
        lowest[at] = trial->candidate->parameters[index].lowest - trial->start[index];
        highest[at] = trial->candidate->parameters[index].highest - trial->start[index];
      }
    }
    const Eigen::MatrixXd power = columns.transpose() * columns;
    const Eigen::VectorXd right = columns.transpose() * residual;
    Solution solution{optimization::least_squares_in_box(power, right, lowest, highest), 0.0};
    solution.loss = residual.squaredNorm() + 2.0 * right.dot(solution.move) +
                    solution.move.dot(power * solution.move);
    return solution;
  }

  static std::vector<double> moved_start(const ScreenTrial& trial, const Eigen::VectorXd& move) {
    std::vector<double> moved;
    for (std::size_t k = 0; k < trial.start.size(); ++k) {
      const FitParameter& parameter = trial.candidate->parameters[k];
      // Along a logarithm the linear model does not reach far.
      const double most = parameter.is_scale ? 1.0 : 1e300;
      const double by = std::clamp(move[static_cast<Eigen::Index>(k)], -most, most);
      moved.push_back(std::clamp(trial.start[k] + by, parameter.lowest, parameter.highest));
    }
    return moved;
  }

  Eigen::VectorXd start_of(const std::vector<const ScreenTrial*>& trials,
                           const std::vector<Eigen::VectorXd>& moves) const {
    std::vector<double> all(model_.coordinates.data(),
                            model_.coordinates.data() + model_.coordinates.size());
    for (std::size_t t = 0; t < trials.size(); ++t) {
      const std::vector<double> start = moved_start(*trials[t], moves[t]);
      all.insert(all.end(), start.begin(), start.end());
    }
    return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
  }

  Prospect together(const std::vector<const ScreenTrial*>& trials) const {
    const Solution solution = solved(trials);
    Prospect prospect;
    std::vector<Eigen::VectorXd> moves;
    Eigen::Index at = own_.cols();
    for (const ScreenTrial* trial : trials) {
      prospect.added.push_back(trial->candidate);
      moves.push_back(solution.move.segment(at, trial->slopes.cols()));
      at += trial->slopes.cols();
    }
    prospect.start = start_of(trials, moves);
    prospect.loss = solution.loss;
    return prospect;
  }

  void add_pairs() {
    const std::size_t count = std::min(kPaired, best_.size());
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = a + 1; b < count; ++b) {
        result_.pairs.push_back(together({&best_[a], &best_[b]}));
      }
    }
    sort_by_loss(result_.pairs);
  }

  /// A machine's waves come in numbers, and each is noise to the others.
  void add_combs() {
    std::map<std::string, std::vector<const ScreenTrial*>> waves;  // By kind.
    for (const ScreenTrial& trial : best_) {
      if (trial.candidate->order == 0.0) continue;
      const std::string& key = trial.candidate->key;
      auto& teeth = waves[key.substr(0, key.find(':'))];
      if (teeth.size() < kTeeth) teeth.push_back(&trial);
    }
    for (const auto& [kind, teeth] : waves) {
      if (teeth.size() > 1) result_.combs.push_back(together(teeth));
    }
    sort_by_loss(result_.combs);
  }

  static void sort_by_loss(std::vector<Prospect>& prospects) {
    std::sort(prospects.begin(), prospects.end(),
              [](const Prospect& x, const Prospect& y) { return x.loss < y.loss; });
  }

  const ModelFitter& fitter_;
  const ModelFit& model_;
  double least_change_rms_;
  Eigen::VectorXd training_;  ///< 1 where a row may be fitted.
  Eigen::MatrixXd own_;
  std::vector<ScreenTrial> best_;
  Screening result_;
};

}  // namespace

Screening screen(const ModelFitter& fitter, const ModelFit& model, const EffectSet& candidates,
                 double least_change_rms, bool with_pairs) {
  return Screen(fitter, model, candidates, least_change_rms).take(with_pairs);
}

}  // namespace torquewright::identification
