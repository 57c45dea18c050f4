// SPDX-License-Identifier: Apache-2.0
// The only file that includes Ipopt for nonlinear programs; of the search over discrete designs it
// is discrete/ipopt_relaxation.cpp.
#include "optimization/nonlinear/ipopt_program.hpp"

#include <algorithm>
#include <coin/IpIpoptApplication.hpp>
#include <coin/IpTNLP.hpp>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace torquewright::optimization {
namespace {

using Ipopt::Index;
using Ipopt::Number;

constexpr double kNoBound = 2e19;  // Ipopt takes 1e19 and beyond for infinite
// How far first points are moved off their bounds, over the unknowns' scales; Ipopt's default.
constexpr double kMostPush = 1e-2;
constexpr double kAcceptableFactor = 100.0;
constexpr int kAcceptableIterations = 10;

std::span<const double> numbers(const Number* first, Index count) {
  return {first, static_cast<std::size_t>(count)};
}
std::span<double> numbers(Number* first, Index count) {
  return {first, static_cast<std::size_t>(count)};
}

double bound_over(double bound, double scale) {
  return std::clamp(bound / scale, -kNoBound, kNoBound);
}

class SparseProblem final : public Ipopt::TNLP {
 public:
  explicit SparseProblem(Search& search) : search_(search), program_(search.program()) {}

  SearchEnd take(NonlinearStatus status) {
    if (thrown_) std::rethrow_exception(thrown_);
    end_.status = interruption_.value_or(status);
    return std::move(end_);
  }

  bool get_nlp_info(Index& n, Index& m, Index& nnz_jac_g, Index& nnz_h_lag,
                    IndexStyleEnum& index_style) override {
    n = program_.variable_count();
    m = program_.row_count();
    nnz_jac_g = static_cast<Index>(search_.assembly().jacobian_places().size());
    nnz_h_lag = static_cast<Index>(search_.assembly().hessian_places().size());
    index_style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* x_l, Number* x_u, Index, Number* g_l,
                       Number* g_u) override {
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
      x_l[i] = bound_over(program_.bounds()[i].lower, program_.scales()[i]);
      x_u[i] = bound_over(program_.bounds()[i].upper, program_.scales()[i]);
    }
    for (const auto& rows : program_.rows()) {
      for (std::size_t i = 0; i < rows->bounds().size(); ++i) {
        *g_l++ = bound_over(rows->bounds()[i].lower, rows->scales()[i]);
        *g_u++ = bound_over(rows->bounds()[i].upper, rows->scales()[i]);
      }
    }
    return true;
  }

  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool,
                          Number*) override {
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
      x[i] = program_.starts()[i] / program_.scales()[i];
    }
    return true;
  }

  bool eval_f(Index n, const Number* x, bool, Number& value) override {
    return guarded([&] {
      const Evaluation& here = search_.at(numbers(x, n));
      value = here.objective / search_.assembly().objective_scale();
      return here.is_finite;
    });
  }
  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    return guarded([&] { return search_.gradient(numbers(x, n), numbers(gradient, n)); });
  }
  bool eval_g(Index n, const Number* x, bool, Index, Number* g) override {
    return guarded([&] {
      const Evaluation& here = search_.at(numbers(x, n));
      std::copy(here.rows.begin(), here.rows.end(), g);
      return here.is_finite;
    });
  }
  bool eval_jac_g(Index n, const Number* x, bool, Index, Index count, Index* rows, Index* columns,
                  Number* values) override {
    if (values == nullptr) return give(search_.assembly().jacobian_places(), rows, columns);
    return guarded([&] { return search_.jacobian(numbers(x, n), numbers(values, count)); });
  }
  bool eval_h(Index n, const Number* x, bool, Number factor, Index m, const Number* lambda, bool,
              Index count, Index* rows, Index* columns, Number* values) override {
    if (values == nullptr) return give(search_.assembly().hessian_places(), rows, columns);
    return guarded([&] {
      return search_.hessian(numbers(x, n), factor, numbers(lambda, m), numbers(values, count));
    });
  }

  // Called in each iteration of the restoration phase too.
  bool intermediate_callback(Ipopt::AlgorithmMode mode, Index iteration, Number objective,
                             Number violation, Number, Number, Number, Number, Number, Number,
                             Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    return guarded([&] {
      end_.iterations = iteration;
      interruption_ = search_.interruption();
      if (interruption_) return false;
      if (!search_.options().on_iterate) return true;
      NonlinearIterate iterate = search_.last_finite();
      iterate.iteration = iteration;
      if (mode == Ipopt::RegularMode) {  // else objective and violation are another problem's
        iterate.objective = objective * search_.assembly().objective_scale();
        iterate.largest_violation = violation;
      }
      search_.options().on_iterate(iterate);
      return true;
    });
  }

  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number*,
                         const Number*, Index m, const Number*, const Number* lambda, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    end_.scaled.assign(x, x + n);
    end_.multipliers.assign(lambda, lambda + m);
  }

 private:
  static bool give(const std::vector<Place>& places, Index* rows, Index* columns) {
    for (const Place& place : places) {
      *rows++ = place.row;
      *columns++ = place.column;
    }
    return true;
  }

  /// An exception must not pass through Ipopt: it waits for take().
  template <typename Evaluate>
  bool guarded(const Evaluate& evaluate) {
    if (thrown_) return false;
    try {
      return evaluate();
    } catch (...) {
      thrown_ = std::current_exception();
      return false;
    }
  }

  Search& search_;
  const Program& program_;
  SearchEnd end_;
  std::optional<NonlinearStatus> interruption_;
  std::exception_ptr thrown_;
};

/// Ipopt's list takes no note of what it does not know.
void require_known(bool is_known, const std::string& option) {
  if (!is_known) throw std::logic_error("Ipopt does not take option " + option);
}

void set_options(Ipopt::OptionsList& list, const NonlinearOptions& options) {
  const auto set_name = [&](const std::string& option, const std::string& value) {
    require_known(list.SetStringValue(option, value), option);
  };
  const auto set_number = [&](const std::string& option, double value) {
    require_known(list.SetNumericValue(option, value), option);
  };
  const auto set_count = [&](const std::string& option, int value) {
    require_known(list.SetIntegerValue(option, value), option);
  };
  set_count("print_level", 0);
  set_name("sb", "yes");
  set_name("linear_solver", "mumps");
  set_name("mu_strategy", "monotone");
  set_number("mu_init", options.first_barrier);
  set_number("bound_push", std::min(kMostPush, options.first_barrier));
  set_number("slack_bound_push", std::min(kMostPush, options.first_barrier));
  set_number("tol", options.tolerance);
  set_number("constr_viol_tol", options.tolerance);
  set_number("acceptable_tol", kAcceptableFactor * options.tolerance);
  set_count("acceptable_iter", kAcceptableIterations);
  set_count("max_iter", options.most_iterations);
  // Assembly scales, so that every tolerance is one of scaled quantities.
  set_name("nlp_scaling_method", "none");
  // Rows are defined within the bounds alone.
  set_number("bound_relax_factor", 0.0);
  set_name("fixed_variable_treatment", "make_parameter");
}

NonlinearStatus status_of(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Solve_Succeeded:
    case Ipopt::Feasible_Point_Found:  // of as many equations as unknowns: nothing is left to
                                       // choose
      return NonlinearStatus::kSolved;
    case Ipopt::Solved_To_Acceptable_Level:
      return NonlinearStatus::kAcceptable;
    case Ipopt::Infeasible_Problem_Detected:
      return NonlinearStatus::kLocallyInfeasible;
    case Ipopt::Maximum_Iterations_Exceeded:
      return NonlinearStatus::kIterationLimit;
    case Ipopt::Maximum_CpuTime_Exceeded:
      return NonlinearStatus::kTimeLimit;
    case Ipopt::User_Requested_Stop:
      return NonlinearStatus::kInterrupted;
    case Ipopt::Diverging_Iterates:
      return NonlinearStatus::kDiverged;
    case Ipopt::Invalid_Number_Detected:
      return NonlinearStatus::kBadNumbers;
    case Ipopt::Not_Enough_Degrees_Of_Freedom:
      return NonlinearStatus::kOverdefined;
    case Ipopt::Search_Direction_Becomes_Too_Small:
    case Ipopt::Restoration_Failed:
    case Ipopt::Error_In_Step_Computation:
    case Ipopt::Invalid_Problem_Definition:
    case Ipopt::Invalid_Option:
    case Ipopt::Unrecoverable_Exception:
    case Ipopt::NonIpopt_Exception_Thrown:
    case Ipopt::Insufficient_Memory:
    case Ipopt::Internal_Error:
      break;
  }
  return NonlinearStatus::kStalled;
}

}  // namespace

SearchEnd run_ipopt(Search& search) {
  // Without a console: stdout is for results.
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  set_options(*application->Options(), search.options());
  application->Initialize("");
  Ipopt::SmartPtr<SparseProblem> problem = new SparseProblem(search);
  NonlinearStatus status = NonlinearStatus::kStalled;
  try {
    status = status_of(application->OptimizeTNLP(GetRawPtr(problem)));
  } catch (const Ipopt::IpoptException&) {
    // What Ipopt throws past its own return codes: it stopped, and the best point is kept.
  }
  return problem->take(status);
}

}  // namespace torquewright::optimization
