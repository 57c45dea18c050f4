// SPDX-License-Identifier: Apache-2.0
// The only file that includes Ipopt for the search over discrete designs; for nonlinear programs it
// is nonlinear/ipopt_program.cpp.
#include <algorithm>
#include <cmath>
#include <coin/IpIpoptApplication.hpp>
#include <coin/IpIpoptCalculatedQuantities.hpp>
#include <coin/IpIpoptData.hpp>
#include <coin/IpOrigIpoptNLP.hpp>
#include <coin/IpTNLP.hpp>
#include <coin/IpTNLPAdapter.hpp>

#include "optimization/discrete/relaxation.hpp"

namespace torquewright::optimization {
namespace {

using Ipopt::Index;
using Ipopt::Number;

// Price of violating the scaled conditions. Too small: the bound of a box without feasible points
// stays low. Too large: Ipopt needs more iterations.
constexpr double kPenalty = 1e3;
// Share of the gain's variation below which the gap between primal and dual is not worth a step.
constexpr double kGapShare = 1e-4;

// minimise  -gain(x)/scale + penalty t   subject to   h_c(x)/scale_c + t >= 0,  t >= 0,  x in the
// box. Convex, and never infeasible: t can always grow. So Ipopt is never asked whether a box is
// empty; its multipliers tell, and they are checked.
class ElasticProblem final : public Ipopt::TNLP {
 public:
  ElasticProblem(const Relaxation& relaxation, double ceiling)
      : relaxation_(relaxation),
        ceiling_(ceiling),
        count_(static_cast<Index>(relaxation.box.size())) {
    for (const Range& range : relaxation.box) best_.point.push_back(range.interval().middle());
    best_.multipliers.assign(relaxation.condition_count, 0.0);
  }

  DualPoint take() { return std::move(best_); }

  bool get_nlp_info(Index& n, Index& m, Index& nnz_jac_g, Index& nnz_h_lag,
                    IndexStyleEnum& index_style) override {
    n = count_ + 1;
    m = static_cast<Index>(relaxation_.conditions.size());
    nnz_jac_g = m * n;
    nnz_h_lag = count_ * (count_ + 1) / 2;
    index_style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* x_l, Number* x_u, Index m, Number* g_l,
                       Number* g_u) override {
    for (Index i = 0; i < count_; ++i) {
      const Interval range = relaxation_.box[static_cast<std::size_t>(i)].interval();
      x_l[i] = range.lower;
      x_u[i] = range.upper;
    }
    x_l[n - 1] = 0.0;
    x_u[n - 1] = 2.0;  // every h_c/scale_c lies within [-1, 1]
    std::fill(g_l, g_l + m, 0.0);
    std::fill(g_u, g_u + m, 2e19);
    return true;
  }

  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool,
                          Number*) override {
    std::copy(best_.point.begin(), best_.point.end(), x);
    x[n - 1] = 1.0;
    return true;
  }

  bool eval_f(Index n, const Number* x, bool, Number& value) override {
    value = -scaled_gain(x) + kPenalty * x[n - 1];
    return true;
  }
  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    const ValueAndSlope gain = evaluate(relaxation_.gain, point_at(x));
    for (std::size_t i = 0; i < relaxation_.box.size(); ++i) {
      gradient[i] = -gain.slope[i].middle() / relaxation_.gain_scale;
    }
    gradient[n - 1] = kPenalty;
    return true;
  }

  bool eval_g(Index n, const Number* x, bool, Index, Number* g) override {
    for (const RelaxedCondition& condition : relaxation_.conditions) {
      *g++ = evaluate(condition.form, point_at(x)).value.middle() / condition.scale + x[n - 1];
    }
    return true;
  }

  bool eval_jac_g(Index n, const Number* x, bool, Index m, Index, Index* rows, Index* columns,
                  Number* values) override {
    Index entry = 0;
    for (Index c = 0; c < m; ++c) {
      const RelaxedCondition& condition = relaxation_.conditions[static_cast<std::size_t>(c)];
      ValueAndSlope part;
      if (values != nullptr) part = evaluate(condition.form, point_at(x));
      for (Index i = 0; i < n; ++i, ++entry) {
        if (values == nullptr) {
          rows[entry] = c;
          columns[entry] = i;
        } else if (i == n - 1) {
          values[entry] = 1.0;
        } else {
          values[entry] = part.slope[static_cast<std::size_t>(i)].middle() / condition.scale;
        }
      }
    }
    return true;
  }

  bool eval_h(Index, const Number* x, bool, Number factor, Index, const Number* lambda, bool, Index,
              Index* rows, Index* columns, Number* values) override {
    Index entry = 0;
    for (Index i = 0; i < count_; ++i) {
      for (Index j = 0; j <= i; ++j, ++entry) {
        if (values == nullptr) {
          rows[entry] = i;
          columns[entry] = j;
          continue;
        }
        const auto point = point_at(x);
        values[entry] = -factor * curvature(relaxation_.gain, point, i, j) / relaxation_.gain_scale;
        const Number* multiplier = lambda;
        for (const RelaxedCondition& condition : relaxation_.conditions) {
          values[entry] += *multiplier++ * curvature(condition.form, point, i, j) / condition.scale;
        }
      }
    }
    return true;
  }

  bool intermediate_callback(Ipopt::AlgorithmMode, Index, Number, Number, Number, Number, Number,
                             Number, Number, Number, Index, const Ipopt::IpoptData* data,
                             Ipopt::IpoptCalculatedQuantities* quantities) override {
    auto* problem = dynamic_cast<Ipopt::OrigIpoptNLP*>(GetRawPtr(quantities->GetIpoptNLP()));
    if (problem == nullptr) return true;  // in its restoration phase: nothing to read
    auto* adapter = dynamic_cast<Ipopt::TNLPAdapter*>(GetRawPtr(problem->nlp()));
    if (adapter == nullptr) return true;
    std::vector<Number> x(relaxation_.box.size() + 1), y(relaxation_.conditions.size());
    adapter->ResortX(*data->curr()->x(), x.data());
    adapter->ResortG(*data->curr()->y_c(), *data->curr()->y_d(), y.data());
    return !is_enough(x.data(), y.data());
  }

  void finalize_solution(Ipopt::SolverReturn, Index, const Number* x, const Number*, const Number*,
                         Index, const Number*, const Number* lambda, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    is_enough(x, lambda);
  }

 private:
  std::span<const double> point_at(const Number* x) const { return {x, relaxation_.box.size()}; }

  double scaled_gain(const Number* x) const {
    return evaluate(relaxation_.gain, point_at(x)).value.middle() / relaxation_.gain_scale;
  }

  // -u^2/v has the second derivatives -2/v (u_i - r v_i)(u_j - r v_j), r = u/v.
  static double curvature(const ConcaveForm& form, std::span<const double> point, Index i,
                          Index j) {
    double total = 0.0;
    for (const SquareTerm& term : form.squares) {
      const double v = term.v ? term.v->at(point).middle() : 1.0;
      const double r = term.u.at(point).middle() / v;
      const auto direction = [&](Index k) {
        const auto index = static_cast<std::size_t>(k);
        const double dv = term.v ? term.v->coefficients[index].middle() : 0.0;
        return term.u.coefficients[index].middle() - r * dv;
      };
      total -= 2.0 * term.weight.middle() / v * direction(i) * direction(j);
    }
    return total;
  }

  // Keeps the dual point if it is the best so far. True when more steps would teach nothing.
  bool is_enough(const Number* x, const Number* lambda) {
    DualPoint trial{{x, x + relaxation_.box.size()},
                    std::vector<double>(relaxation_.condition_count, 0.0)};
    if (!std::all_of(trial.point.begin(), trial.point.end(),
                     [](double value) { return std::isfinite(value); })) {
      return false;
    }
    for (const RelaxedCondition& condition : relaxation_.conditions) {
      // Ipopt's multipliers of g >= 0 are negative; the scales belong to gain and condition.
      trial.multipliers[condition.condition] =
          std::max(0.0, -*lambda++) * relaxation_.gain_scale / condition.scale;
    }
    const DualBound bound = dual_bound(relaxation_, trial);
    if (bound.is_infeasible || bound.least_cost > best_bound_) {
      best_bound_ = bound.least_cost;
      best_ = std::move(trial);
    }
    if (bound.is_infeasible || bound.least_cost > ceiling_) return true;
    const double primal = x[count_] < 1e-6 ? -scaled_gain(x) : HUGE_VAL;
    return primal - best_bound_ / relaxation_.gain_scale < kGapShare;
  }

  const Relaxation& relaxation_;
  double ceiling_;
  Index count_;
  DualPoint best_;
  double best_bound_ = -HUGE_VAL;
};

Ipopt::SmartPtr<Ipopt::IpoptApplication> make_application() {
  // Without a console: stdout is for results.
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  auto options = application->Options();
  options->SetStringValue("sb", "yes");
  options->SetIntegerValue("print_level", 0);
  options->SetIntegerValue("max_iter", 40);
  // A loose solve still gives a valid bound: whatever the multipliers, they are checked.
  options->SetNumericValue("tol", 1e-4);
  options->SetStringValue("nlp_scaling_method", "none");
  options->SetNumericValue("bound_relax_factor", 0.0);
  application->Initialize("");
  return application;
}

}  // namespace

DualPoint solve(const Relaxation& relaxation, double ceiling) {
  static thread_local const auto application = make_application();
  Ipopt::SmartPtr<ElasticProblem> problem = new ElasticProblem(relaxation, ceiling);
  try {
    application->OptimizeTNLP(GetRawPtr(problem));
  } catch (const Ipopt::IpoptException&) {
    // A failed solve yields what was found before it failed.
  }
  return problem->take();
}

}  // namespace torquewright::optimization
