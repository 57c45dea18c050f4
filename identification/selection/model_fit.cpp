// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/model_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

/// Steps of a fit; more are made only while each takes a share of what is left, as along the bent
/// valley of two parameters that nearly stand for one another.
constexpr int kFewSteps = 12, kMostSteps = 40;
constexpr double kWorthAStep = 1e-3;
constexpr double kSlopeStep = 1e-5;     ///< Of a parameter's size.
constexpr double kStraight = 1e-4;      ///< Of the loss: the slopes of before still hold.
constexpr double kConverged = 1e-7;     ///< Relative fall of the loss.
constexpr double kUndetermined = 1e-7;  ///< Relative power of a combination that nothing moves.
constexpr double kRaise = 10.0;         ///< Of the damping, after a step that led nowhere.
constexpr double kMostFall = 0.1;       ///< Of the damping, after a step that kept its promise.
constexpr double kSameNoise = 0.05;     ///< What a model may make more of the channels' noise.

/// Free are those that are inside their bounds or pulled inwards.
std::vector<bool> free_ones(const std::vector<FitParameter>& parameters, const Eigen::VectorXd& at,
                            const Eigen::VectorXd& descent) {
  std::vector<bool> free(parameters.size());
  for (std::size_t k = 0; k < free.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const bool low = at[i] <= parameters[k].lowest && descent[i] > 0.0;
    const bool high = at[i] >= parameters[k].highest && descent[i] < 0.0;
    free[k] = !low && !high;
  }
  return free;
}

/// Those free parameters whose columns hold something that the columns of others do not: members'
/// first, then what is always fitted, so that of two that coincide the stated value stays.
std::vector<bool> determined(const Eigen::MatrixXd& slopes, const std::vector<bool>& free,
                             Eigen::Index always) {
  const Eigen::Index p = slopes.rows();
  std::vector<bool> kept(free.size(), false);
  Eigen::MatrixXd left = slopes;
  for (Eigen::Index k = 0; k < p; ++k) {
    const Eigen::Index i = k < p - always ? always + k : k - (p - always);
    if (!free[static_cast<std::size_t>(i)]) continue;
    if (!(left(i, i) > kUndetermined * slopes(i, i))) continue;
    kept[static_cast<std::size_t>(i)] = true;
    left -= (left.col(i) * left.row(i) / left(i, i)).eval();
  }
  return kept;
}

/// A symmetric system by its scaled eigenvalues; what nothing determines stays where it is.
Eigen::VectorXd solved_for(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& right,
                           const std::vector<bool>& free, double damping) {
  const Eigen::Index p = right.size();
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(p);
  for (Eigen::Index i = 0; i < p; ++i) {
    if (free[static_cast<std::size_t>(i)] && slopes(i, i) > 0.0)
      scale[i] = 1.0 / std::sqrt(slopes(i, i));
  }
  const Eigen::MatrixXd unit = scale.asDiagonal() * slopes * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(unit);
  Eigen::VectorXd along = eigen.eigenvectors().transpose() * (scale.asDiagonal() * right);
  for (Eigen::Index i = 0; i < p; ++i) {
    const double power = eigen.eigenvalues()[i];
    along[i] = power > kUndetermined ? along[i] / (power + damping) : 0.0;
  }
  return scale.asDiagonal() * (eigen.eigenvectors() * along);
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& slopes, const std::vector<bool>& free) {
  const Eigen::Index p = slopes.rows();
  Eigen::MatrixXd result(p, p);
  for (Eigen::Index i = 0; i < p; ++i) {
    result.col(i) = solved_for(slopes, Eigen::VectorXd::Unit(p, i), free, 0.0);
  }
  return result;
}

Eigen::VectorXd clipped(const std::vector<FitParameter>& parameters, Eigen::VectorXd at) {
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    double& value = at[static_cast<Eigen::Index>(k)];
    value = std::clamp(value, parameters[k].lowest, parameters[k].highest);
  }
  return at;
}

}  // namespace

bool ModelFit::holds(const std::string& effect) const {
  return std::any_of(members.begin(), members.end(),
                     [&](const EffectCandidate* each) { return each->effect == effect; });
}

Eigen::Index ModelFit::first_of(std::size_t member) const {
  Eigen::Index at = always;
  for (std::size_t m = 0; m < member; ++m)
    at += static_cast<Eigen::Index>(members[m]->parameters.size());
  return at;
}

PartOfModel part_of(const ModelFit& fit,
                    const std::function<bool(const EffectCandidate& member)>& stays) {
  PartOfModel part;
  std::vector<double> kept(fit.coordinates.data(), fit.coordinates.data() + fit.always);
  for (std::size_t m = 0; m < fit.members.size(); ++m) {
    if (!stays(*fit.members[m])) continue;
    part.members.push_back(fit.members[m]);
    const double* first = fit.coordinates.data() + fit.first_of(m);
    kept.insert(kept.end(), first, first + fit.members[m]->parameters.size());
  }
  part.coordinates =
      Eigen::Map<const Eigen::VectorXd>(kept.data(), static_cast<Eigen::Index>(kept.size()));
  return part;
}

/// A place in the space of parameters, with all that was found there.
struct ModelFitter::Point {
  Eigen::VectorXd coordinates, residual, noise;
  Eigen::MatrixXd slopes, noise_slopes;
  std::vector<BlockSums> sums;
  Eigen::MatrixXd power;      ///< Of the training blocks, with noise: what steps go by.
  Eigen::MatrixXd net_power;  ///< The same less noise.
  Eigen::VectorXd descent;    ///< Of the training blocks, less noise.
  double loss = 0.0;
  double noise_loss = 0.0;
};

/// What is uncertain is stated all the same: one more observation of each such value, known to its
/// own size, in which a row's residual is as large as it is in the other rows.
struct ModelFitter::Stated {
  Eigen::VectorXd at, per_size2;  ///< (p x 1) The latter nothing for all others.

  Eigen::VectorXd descent(const Point& point, double rows) const {
    return weight(point, rows) * per_size2.cwiseProduct(point.coordinates - at);
  }
  Eigen::MatrixXd power(const Point& point, double rows) const {
    return weight(point, rows) * per_size2.asDiagonal().toDenseMatrix();
  }
  /// `weight`: of a point nearby.
  double loss(const Point& point, double weight) const {
    return weight * (point.coordinates - at).cwiseAbs2().dot(per_size2);
  }
  static double weight(const Point& point, double rows) {
    return std::max(0.0, point.loss + point.noise_loss) / rows;
  }
};

ModelFitter::ModelFitter(const ForwardEquation& equation, const Rows& rows,
                         const std::vector<Signals>& replica)
    : equation_(equation),
      rows_(rows),
      replica_(replica),
      of_rows_(residual_on(rows.signals())),
      of_replica_(residual_on(replica)) {}

ResidualOfStretch ModelFitter::residual_on(const std::vector<Signals>& stretches) const {
  if (equation_.residual_on) return equation_.residual_on(stretches);
  return [&equation = equation_, &stretches](const Hypothesis& supposed, std::size_t stretch) {
    return equation.residual(supposed, stretches[stretch]);
  };
}

std::vector<FitParameter> ModelFitter::parameters(const EffectSet& members) const {
  std::vector<FitParameter> all = equation_.always;
  for (const EffectCandidate* member : members) {
    all.insert(all.end(), member->parameters.begin(), member->parameters.end());
  }
  return all;
}

Eigen::VectorXd ModelFitter::always_start() const {
  return Eigen::Map<const Eigen::VectorXd>(
      equation_.always_start.data(), static_cast<Eigen::Index>(equation_.always_start.size()));
}

Hypothesis ModelFitter::hypothesis(const EffectSet& members,
                                   const Eigen::VectorXd& coordinates) const {
  Hypothesis hypothesis = equation_.stated;
  const std::span<const double> all(coordinates.data(),
                                    static_cast<std::size_t>(coordinates.size()));
  std::size_t at = equation_.always.size();
  if (at > 0) equation_.apply_always(all.first(at), hypothesis);
  for (const EffectCandidate* member : members) {
    member->apply(all.subspan(at, member->parameters.size()), hypothesis);
    at += member->parameters.size();
  }
  return hypothesis;
}

Eigen::VectorXd ModelFitter::residual(const EffectSet& members, const Eigen::VectorXd& coordinates,
                                      const std::vector<Signals>& like) const {
  const Hypothesis supposed = hypothesis(members, coordinates);
  const ResidualOfStretch& of = &like == &replica_ ? of_replica_ : of_rows_;
  const auto of_stretch = [&](const Signals& stretch) {
    return of(supposed, static_cast<std::size_t>(&stretch - like.data()));
  };
  return rows_.values(of_stretch, like);
}

Eigen::VectorXd ModelFitter::residual(const EffectSet& members,
                                      const Eigen::VectorXd& coordinates) const {
  return residual(members, coordinates, rows_.signals());
}

Eigen::VectorXd ModelFitter::noise(const EffectSet& members,
                                   const Eigen::VectorXd& coordinates) const {
  return residual(members, coordinates, replica_) - residual(members, coordinates);
}

Eigen::MatrixXd ModelFitter::slopes(const EffectSet& members, const Eigen::VectorXd& coordinates,
                                    const Eigen::VectorXd& here,
                                    const std::vector<Signals>& like) const {
  const std::vector<FitParameter> all = parameters(members);
  Eigen::MatrixXd slopes(here.size(), coordinates.size());
  for (Eigen::Index k = 0; k < coordinates.size(); ++k) {
    const FitParameter& parameter = all[static_cast<std::size_t>(k)];
    double step = kSlopeStep * parameter.size;
    if (coordinates[k] + step > parameter.highest) step = -step;
    Eigen::VectorXd moved = coordinates;
    moved[k] += step;
    slopes.col(k) = (residual(members, moved, like) - here) / step;
  }
  return slopes;
}

ModelFitter::Point ModelFitter::point(const EffectSet& members,
                                      const Eigen::VectorXd& coordinates) const {
  Point point;
  point.coordinates = coordinates;
  point.residual = residual(members, coordinates);
  point.noise = residual(members, coordinates, replica_) - point.residual;
  for (const Rows::Block& block : rows_.blocks()) {
    BlockSums sums;
    sums.noise = point.noise.segment(block.begin, block.count).squaredNorm();
    sums.loss = point.residual.segment(block.begin, block.count).squaredNorm() - sums.noise;
    if (!block.is_held_out()) {
      point.loss += sums.loss;
      point.noise_loss += sums.noise;
    }
    point.sums.push_back(std::move(sums));
  }
  return point;
}

void ModelFitter::add_slopes(const EffectSet& members, Point& point) const {
  point.slopes = slopes(members, point.coordinates, point.residual, rows_.signals());
  point.noise_slopes =
      slopes(members, point.coordinates, point.residual + point.noise, replica_) - point.slopes;
  add_products(point);
}

void ModelFitter::add_products(Point& point) const {
  const Eigen::Index p = point.coordinates.size();
  point.power = point.net_power = Eigen::MatrixXd::Zero(p, p);
  point.descent = Eigen::VectorXd::Zero(p);
  for (std::size_t b = 0; b < point.sums.size(); ++b) {
    const Rows::Block& block = rows_.blocks()[b];
    const auto slopes = point.slopes.middleRows(block.begin, block.count);
    const auto noise = point.noise_slopes.middleRows(block.begin, block.count);
    BlockSums& sums = point.sums[b];
    const Eigen::MatrixXd power = slopes.transpose() * slopes;
    sums.slopes = power - noise.transpose() * noise;
    sums.descent = slopes.transpose() * point.residual.segment(block.begin, block.count) -
                   noise.transpose() * point.noise.segment(block.begin, block.count);
    if (block.is_held_out()) continue;
    point.power += power;
    point.net_power += sums.slopes;
    point.descent += sums.descent;
  }
}

ModelFitter::Stated ModelFitter::stated(Eigen::Index count) const {
  Stated stated{Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count)};
  for (std::size_t k = 0; k < equation_.pointers.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    stated.at[i] = equation_.always_start[k];
    stated.per_size2[i] = 1.0 / (equation_.always[k].size * equation_.always[k].size);
  }
  return stated;
}

/// Steps of Levenberg and Marquardt from a point that has its slopes.
ModelFitter::Point ModelFitter::descended(const EffectSet& members,
                                          const std::vector<FitParameter>& all, Point here) const {
  const auto always = static_cast<Eigen::Index>(equation_.always.size());
  const auto rows = static_cast<double>(rows_.count());
  const Stated stated = this->stated(here.coordinates.size());
  double damping = 1e-6;
  for (int step = 0; step < kMostSteps && here.coordinates.size() > 0; ++step) {
    const Eigen::MatrixXd held = stated.power(here, rows);
    const Eigen::VectorXd descent = here.descent + stated.descent(here, rows);
    const std::vector<bool> free =
        determined(here.power + held, free_ones(all, here.coordinates, descent), always);
    const Eigen::VectorXd move = solved_for(here.power + held, -descent, free, damping);
    Point there = point(members, clipped(all, here.coordinates + move));
    const double weight = Stated::weight(here, rows);
    const double fall =
        here.loss - there.loss + stated.loss(here, weight) - stated.loss(there, weight);
    const double matters = kConverged * (std::abs(here.loss) + here.noise_loss);
    // A model that makes more of the channels' noise than there is to explain has gone astray.
    const bool is_noisier = there.noise_loss > std::max(here.loss + here.noise_loss,
                                                        (1.0 + kSameNoise) * here.noise_loss);
    if (is_noisier || !(fall > 0.0)) {
      if (damping > 1e3 || move.norm() == 0.0 || -move.dot(descent) < matters) break;
      damping *= kRaise;
      continue;
    }
    const Eigen::VectorXd moved = there.coordinates - here.coordinates;
    const double promised = -moved.dot(2.0 * descent + (here.net_power + held) * moved);
    // What did nothing here, as an exponent beside a coefficient of zero, may do something there.
    const bool is_silent = (here.power.diagonal().array() <= 0.0).any();
    const double bent = std::abs(fall - promised);
    if (!is_silent && bent < kStraight * (std::abs(there.loss) + there.noise_loss)) {
      there.slopes = std::move(here.slopes);
      there.noise_slopes = std::move(here.noise_slopes);
      add_products(there);
    } else {
      add_slopes(members, there);
    }
    here = std::move(there);
    // By how much of the promise was kept: Nielsen, "Damping parameter in Marquardt's method",
    // IMM report 1999-05, Technical University of Denmark.
    const double kept = promised > 0.0 ? fall / promised : 1.0;
    const double less = 1.0 - std::pow(2.0 * std::min(kept, 1.0) - 1.0, 3);
    damping = std::max(1e-9, damping * std::clamp(less, kMostFall, 2.0));
    const double left = std::abs(here.loss) + here.noise_loss;
    if (fall < matters || (step >= kFewSteps && fall < kWorthAStep * left)) break;
  }
  return here;
}

ModelFit ModelFitter::fit(const EffectSet& members, const Eigen::VectorXd& start) const {
  const std::vector<FitParameter> all = parameters(members);
  Point first = point(members, clipped(all, start));
  add_slopes(members, first);
  ModelFit fit;
  fit.members = members;
  fit.always = static_cast<Eigen::Index>(equation_.always.size());
  finish(all, descended(members, all, std::move(first)), fit);
  if (fit.is_valid && equation_.is_possible)
    fit.is_valid = equation_.is_possible(hypothesis(members, fit.coordinates));
  return fit;
}

void ModelFitter::finish(const std::vector<FitParameter>& all, const Point& point,
                         ModelFit& fit) const {
  fit.coordinates = point.coordinates;
  fit.residual = point.residual;
  fit.noise = point.noise;
  fit.sums = point.sums;
  fit.loss = point.loss;
  fit.noise_loss = point.noise_loss;
  const Eigen::Index p = point.coordinates.size();
  const auto rows = static_cast<double>(rows_.count());
  const Eigen::MatrixXd held = stated(p).power(point, rows);
  const Eigen::VectorXd held_descent = stated(p).descent(point, rows);
  const Eigen::VectorXd all_descent = point.descent + held_descent;
  fit.is_free =
      determined(point.power + held, free_ones(all, point.coordinates, all_descent), fit.always);
  fit.is_valid = point.residual.allFinite() && point.coordinates.allFinite();
  for (Eigen::Index i = fit.always; i < p; ++i) {
    if (all[static_cast<std::size_t>(i)].is_at_edge(point.coordinates[i])) fit.is_valid = false;
  }
  const std::size_t folds = rows_.folds();
  std::vector<Eigen::MatrixXd> power(folds, Eigen::MatrixXd::Zero(p, p));
  std::vector<Eigen::VectorXd> descent(folds, Eigen::VectorXd::Zero(p));
  Eigen::MatrixXd total = held, scatter = Eigen::MatrixXd::Zero(p, p);
  for (std::size_t b = 0; b < fit.sums.size(); ++b) {
    const std::size_t fold = rows_.blocks()[b].fold;
    if (fold == kHeldOut) continue;
    power[fold] += fit.sums[b].slopes;
    descent[fold] += fit.sums[b].descent;
    total += fit.sums[b].slopes;
    scatter += fit.sums[b].descent * fit.sums[b].descent.transpose();
  }
  std::vector<Eigen::VectorXd> moves(folds, Eigen::VectorXd::Zero(p));
  Eigen::MatrixXd between = Eigen::MatrixXd::Zero(p, p);
  for (std::size_t f = 0; f < folds && p > 0; ++f) {
    moves[f] =
        clipped(all, point.coordinates + solved_for(total - power[f], -(all_descent - descent[f]),
                                                    fit.is_free, 0.0)) -
        point.coordinates;
    between += moves[f] * moves[f].transpose();
  }
  const Eigen::MatrixXd bread = inverse(total, fit.is_free);
  fit.covariance = bread * scatter * bread;
  // The jackknife over folds, where it is the larger: runs that disagree.
  between *= folds > 1 ? static_cast<double>(folds - 1) / static_cast<double>(folds) : 0.0;
  for (Eigen::Index i = 0; i < p; ++i) {
    if (between(i, i) > fit.covariance(i, i)) {
      const double factor = std::sqrt(between(i, i) / std::max(1e-300, fit.covariance(i, i)));
      fit.covariance.row(i) *= factor;
      fit.covariance.col(i) *= factor;
    }
  }
  for (std::size_t b = 0; b < fit.sums.size(); ++b) {
    const BlockSums& sums = fit.sums[b];
    const std::size_t fold = rows_.blocks()[b].fold;
    double loss = sums.loss;
    if (fold != kHeldOut && p > 0) {
      loss += 2.0 * sums.descent.dot(moves[fold]) + moves[fold].dot(sums.slopes * moves[fold]);
      loss = std::max(loss, -sums.noise);  // No residual is less than nothing.
      fit.unseen_loss += loss;
    } else if (fold != kHeldOut) {
      fit.unseen_loss += loss;
    }
    fit.unseen.push_back(loss);
  }
}

}  // namespace torquewright::identification
