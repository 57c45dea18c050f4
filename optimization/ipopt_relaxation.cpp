// SPDX-License-Identifier: Apache-2.0
// The only file that includes Ipopt.
#include <coin/IpIpoptApplication.hpp>
#include <coin/IpIpoptCalculatedQuantities.hpp>
#include <coin/IpIpoptData.hpp>
#include <coin/IpOrigIpoptNLP.hpp>
#include <coin/IpTNLP.hpp>
#include <coin/IpTNLPAdapter.hpp>

#include <algorithm>
#include <cmath>

#include "optimization/relaxation.hpp"

namespace torquewright::optimization {
namespace {

using Ipopt::Index;
using Ipopt::Number;

// maximise t  subject to  h_c(x)/scale_c - t >= 0,  x in the box.
// Convex, and never infeasible: t can always fall. t < 0 at the best point means that no x satisfies
// all conditions; the multipliers then tell which sum of them shows it.
class DeepestPoint final : public Ipopt::TNLP {
 public:
  DeepestPoint(const std::vector<RelaxedCondition>& conditions, const Box& box)
      : conditions_(conditions), box_(box), count_(static_cast<Index>(box.size())) {
    for (const Range& range : box) result.point.push_back(range.interval().middle());
  }

  RelaxationResult result;

  bool get_nlp_info(Index& n, Index& m, Index& nnz_jac_g, Index& nnz_h_lag,
                    IndexStyleEnum& index_style) override {
    n = count_ + 1;
    m = static_cast<Index>(conditions_.size());
    nnz_jac_g = m * n;
    nnz_h_lag = count_ * (count_ + 1) / 2;
    index_style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* x_l, Number* x_u, Index m, Number* g_l,
                       Number* g_u) override {
    for (Index i = 0; i < count_; ++i) {
      x_l[i] = box_[static_cast<std::size_t>(i)].interval().lower;
      x_u[i] = box_[static_cast<std::size_t>(i)].interval().upper;
    }
    x_l[n - 1] = -2.0;  // every h_c/scale_c lies within [-1, 1]
    x_u[n - 1] = 1.0;
    std::fill(g_l, g_l + m, 0.0);
    std::fill(g_u, g_u + m, 2e19);
    return true;
  }

  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool,
                          Number*) override {
    std::copy(result.point.begin(), result.point.end(), x);
    x[n - 1] = -1.0;
    return true;
  }

  bool eval_f(Index n, const Number* x, bool, Number& value) override {
    value = -x[n - 1];
    return true;
  }
  bool eval_grad_f(Index n, const Number*, bool, Number* gradient) override {
    std::fill(gradient, gradient + n, 0.0);
    gradient[n - 1] = -1.0;
    return true;
  }

  bool eval_g(Index n, const Number* x, bool, Index m, Number* g) override {
    for (Index c = 0; c < m; ++c) {
      const RelaxedCondition& condition = conditions_[static_cast<std::size_t>(c)];
      g[c] = evaluate(condition.form, point_at(x)).value.middle() / condition.scale - x[n - 1];
    }
    return true;
  }

  bool eval_jac_g(Index n, const Number* x, bool, Index m, Index, Index* rows, Index* columns,
                  Number* values) override {
    Index entry = 0;
    for (Index c = 0; c < m; ++c) {
      const RelaxedCondition& condition = conditions_[static_cast<std::size_t>(c)];
      ValueAndSlope part;
      if (values != nullptr) part = evaluate(condition.form, point_at(x));
      for (Index i = 0; i < n; ++i, ++entry) {
        if (values == nullptr) {
          rows[entry] = c;
          columns[entry] = i;
        } else {
          values[entry] = i == n - 1 ? -1.0
                                     : part.slope[static_cast<std::size_t>(i)].middle() /
                                           condition.scale;
        }
      }
    }
    return true;
  }

  bool eval_h(Index, const Number* x, bool, Number, Index m, const Number* lambda, bool, Index,
              Index* rows, Index* columns, Number* values) override {
    Index entry = 0;
    for (Index i = 0; i < count_; ++i) {
      for (Index j = 0; j <= i; ++j, ++entry) {
        if (values == nullptr) {
          rows[entry] = i;
          columns[entry] = j;
          continue;
        }
        values[entry] = 0.0;
        for (Index c = 0; c < m; ++c) {
          const RelaxedCondition& condition = conditions_[static_cast<std::size_t>(c)];
          values[entry] += lambda[c] * curvature(condition.form, point_at(x), i, j) /
                           condition.scale;
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
    std::vector<Number> x(box_.size() + 1), y(conditions_.size());
    adapter->ResortX(*data->curr()->x(), x.data());
    adapter->ResortG(*data->curr()->y_c(), *data->curr()->y_d(), y.data());
    return !judge(x.data(), y.data());
  }

  void finalize_solution(Ipopt::SolverReturn, Index, const Number* x, const Number*, const Number*,
                         Index, const Number*, const Number* lambda, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    if (!result.refutation) judge(x, lambda);
  }

 private:
  std::span<const double> point_at(const Number* x) const { return {x, box_.size()}; }

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

  // True when there is nothing more to learn: refuted, or a point satisfies all conditions.
  bool judge(const Number* x, const Number* lambda) {
    Refutation trial;
    for (std::size_t i = 0; i < box_.size(); ++i) {
      const Interval range = box_[i].interval();
      if (!std::isfinite(x[i])) return false;
      trial.point.push_back(std::clamp(x[i], range.lower, range.upper));
    }
    result.point = trial.point;
    bool satisfies_all = true;
    for (std::size_t c = 0; c < conditions_.size(); ++c) {
      // Ipopt's multipliers of g >= 0 are negative; the scale belongs to the condition.
      trial.multipliers.push_back(std::max(0.0, -lambda[c]) / conditions_[c].scale);
      satisfies_all &= evaluate(conditions_[c].form, trial.point).value.lower >= 0.0;
    }
    if (satisfies_all) return true;
    if (greatest_sum(conditions_, box_, trial) >= 0.0) return false;
    result.refutation = std::move(trial);
    return true;
  }

  const std::vector<RelaxedCondition>& conditions_;
  const Box& box_;
  Index count_;
};

Ipopt::SmartPtr<Ipopt::IpoptApplication> make_application() {
  // Without a console: stdout is for results.
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  auto options = application->Options();
  options->SetStringValue("sb", "yes");
  options->SetIntegerValue("print_level", 0);
  options->SetIntegerValue("max_iter", 40);
  // A loose solve still gives a valid bound: whatever the multipliers, they are checked.
  options->SetNumericValue("tol", 1e-6);
  options->SetStringValue("mu_strategy", "monotone");
  options->SetStringValue("nlp_scaling_method", "none");
  options->SetNumericValue("bound_relax_factor", 0.0);
  application->Initialize("");
  return application;
}

}  // namespace

RelaxationResult solve_relaxation(const std::vector<RelaxedCondition>& conditions, const Box& box) {
  static thread_local const auto application = make_application();
  Ipopt::SmartPtr<DeepestPoint> problem = new DeepestPoint(conditions, box);
  try {
    application->OptimizeTNLP(GetRawPtr(problem));
  } catch (const Ipopt::IpoptException&) {
    // A failed solve yields what was found before it failed.
  }
  return std::move(problem->result);
}

}  // namespace torquewright::optimization
