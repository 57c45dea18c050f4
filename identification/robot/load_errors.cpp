// SPDX-License-Identifier: Apache-2.0
#include "identification/robot/load_errors.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Of = FreeValue::Of;

constexpr double kLeastSquare = 25.0;  ///< 5 standard errors.
constexpr double kAsGood = 0.8;        ///< Of what the best takes.
constexpr std::size_t kMostErrors = 3, kMostReadings = 4;
/// Of what was thought possible: a reading beyond it is no reading.
constexpr double kMostDeviations = 4.0;

bool is_of_body(const FreeValue& which) { return which.of == Of::kMass || which.of == Of::kCenter; }

/// What the runs say of some values, all others being as free as they are.
struct Form {
  std::vector<std::size_t> values;
  MatrixXd power;  ///< In deviations of the values.
  VectorXd right;  ///< power * change that they ask for.
};

MatrixXd part(const MatrixXd& of, const std::vector<Index>& rows, const std::vector<Index>& cols) {
  MatrixXd chosen(static_cast<Index>(rows.size()), static_cast<Index>(cols.size()));
  for (Index a = 0; a < chosen.rows(); ++a) {
    for (Index b = 0; b < chosen.cols(); ++b) {
      chosen(a, b) = of(rows[static_cast<std::size_t>(a)], cols[static_cast<std::size_t>(b)]);
    }
  }
  return chosen;
}

double known_power_of(const FreeValue& which) {
  return std::isfinite(which.deviation) ? 1.0 / (which.deviation * which.deviation) : 0.0;
}

Form form_of(const ValueFit& fit, const Limb& limb) {
  Form form;
  std::vector<Index> own, others;
  for (std::size_t k = 0; k < fit.values.size(); ++k) {
    const FreeValue& which = fit.values[k].which;
    const bool is_own = is_of_body(which) && std::find(limb.joints.begin(), limb.joints.end(),
                                                       which.joint) != limb.joints.end();
    (is_own ? own : others).push_back(static_cast<Index>(k));
    if (is_own) form.values.push_back(k);
  }
  MatrixXd known = part(fit.information, others, others);
  for (Index a = 0; a < known.rows(); ++a) {
    const FreeValue& which =
        fit.values[static_cast<std::size_t>(others[static_cast<std::size_t>(a)])].which;
    known(a, a) += known_power_of(which) + 1e-9 / (which.size * which.size);
  }
  const MatrixXd between = part(fit.information, others, own);
  form.power = part(fit.information, own, own) - between.transpose() * known.ldlt().solve(between);
  VectorXd change(form.power.rows());
  form.right.resize(change.size());
  for (Index a = 0; a < change.size(); ++a) {
    const FittedValue& value = fit.values[form.values[static_cast<std::size_t>(a)]];
    change[a] = value.value - value.stated;
  }
  form.right = form.power * change;
  for (Index a = 0; a < change.size(); ++a) {
    // At the fit's end what was known before pulls as much as the runs do.
    const FittedValue& value = fit.values[form.values[static_cast<std::size_t>(a)]];
    form.right[a] += known_power_of(value.which) * change[a];
    const double deviation = value.which.deviation;
    form.right[a] *= deviation;
    form.power.row(a) *= deviation;
    form.power.col(a) *= deviation;
  }
  return form;
}

std::string body_name(const RobotModel& model, std::size_t joint) {
  return model.load.robot->tree.bodies[model.load.robot->bodies[joint]].name;
}

/// What one number takes of the squares that are left, and where it has to be for it.
struct Taken {
  Index place = 0;
  double square = 0.0, change = 0.0;
};

std::vector<Taken> all_taken(const Form& form, const VectorXd& right) {
  std::vector<Taken> all;
  for (Index a = 0; a < right.size(); ++a) {
    if (!(form.power(a, a) > 1.0)) continue;  // the runs say less of it than was known
    const double change = right[a] / form.power(a, a);
    if (std::abs(change) > kMostDeviations) continue;
    all.push_back({a, right[a] * change, change});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Taken& x, const Taken& y) { return x.square > y.square; });
  return all;
}

void add_errors(const RobotModel& stated, const ValueFit& fit, const Form& form, std::size_t limb,
                std::vector<LoadError>& errors) {
  VectorXd right = form.right;
  for (std::size_t number = 0; number < kMostErrors; ++number) {
    const std::vector<Taken> taken = all_taken(form, right);
    if (taken.empty() || taken.front().square < kLeastSquare) return;
    LoadError error;
    error.limb = limb;
    error.sigmas = std::sqrt(taken.front().square);
    for (const Taken& each : taken) {
      if (each.square < kAsGood * taken.front().square) break;
      if (error.readings.size() == kMostReadings) break;
      const FreeValue& which = fit.values[form.values[static_cast<std::size_t>(each.place)]].which;
      error.readings.push_back({which, body_name(stated, which.joint),
                                each.change * which.deviation,
                                which.deviation / std::sqrt(form.power(each.place, each.place))});
    }
    right -= taken.front().change * form.power.col(taken.front().place);
    errors.push_back(std::move(error));
  }
}

std::string reading_text(const LoadReading& reading, const std::string& whose) {
  if (reading.which.of == Of::kMass) {
    return fmt::format("{} weighs {:.2g} kg {}", whose, std::abs(reading.change),
                       reading.change > 0.0 ? "more" : "less");
  }
  return fmt::format("{}'s centre of mass lies {:.2g} mm further along its {}{}", whose,
                     1e3 * std::abs(reading.change), reading.change > 0.0 ? "+" : "-",
                     "xyz"[reading.which.parameter]);
}

}  // namespace

LoadErrors load_errors(const RobotModel& stated, const ValueFit& fit) {
  LoadErrors found;
  if (fit.values.empty() || fit.information.size() == 0) return found;
  const std::vector<Limb> limbs = limbs_of(stated.load);
  for (std::size_t limb = 0; limb < limbs.size(); ++limb) {
    LoadRank rank;
    for (const std::size_t joint : limbs[limb].joints) {
      rank.bodies.push_back(body_name(stated, joint));
    }
    const Form form = form_of(fit, limbs[limb]);
    rank.of = form.values.size();
    if (rank.of > 0) {
      const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(form.power, Eigen::EigenvaluesOnly);
      for (const double each : solver.eigenvalues()) rank.told += each > 1.0 ? 1 : 0;
      add_errors(stated, fit, form, limb, found.errors);
    }
    found.limbs.push_back(std::move(rank));
  }
  return found;
}

std::string sentence_of(const LoadError& error) {
  std::string text;
  for (const LoadReading& each : error.readings) {
    text += (text.empty() ? "" : ", or ") + reading_text(each, each.body);
  }
  return text + (error.readings.size() > 1 ? ": the log cannot tell which." : ".");
}

}  // namespace torquewright::identification
