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
constexpr int kMinimumDegree = 0;  // MUMPS users' guide, ICNTL(7)
constexpr double kAcceptableFactor = 100.0;
constexpr int kAcceptableIterations = 10;

double bound_over(double bound, double scale) {
  return std::clamp(bound / scale, -kNoBound, kNoBound);
}

/// The search's program. Of one with as many equations as free unknowns Ipopt would take any point
/// that meets the equations and leave multipliers as they are, which is wrong where equations
/// depend on each other (Hock and Schittkowski's problem 55): it gets a spare unknown t, costing
/// t^2/2, that nothing depends on.
class SparseProblem final : public Ipopt::TNLP {
 public:
  explicit SparseProblem(Search& search)
      : search_(search),
        program_(search.program()),
        has_spare_(program_.equation_count() == program_.free_variable_count()) {}

  SearchEnd take(NonlinearStatus status) {
    if (thrown_) std::rethrow_exception(thrown_);
    end_.status = interruption_.value_or(status);
    return std::move(end_);
  }

  bool get_nlp_info(Index& n, Index& m, Index& nnz_jac_g, Index& nnz_h_lag,
                    IndexStyleEnum& index_style) override {
    n = program_.variable_count() + (has_spare_ ? 1 : 0);
    m = program_.row_count();
    nnz_jac_g = static_cast<Index>(search_.assembly().jacobian_places().size());
    nnz_h_lag =
        static_cast<Index>(search_.assembly().hessian_places().size()) + (has_spare_ ? 1 : 0);
    index_style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index, Number* x_l, Number* x_u, Index, Number* g_l, Number* g_u) override {
    for (std::size_t i = 0; i < unknown_count(); ++i) {
      *x_l++ = bound_over(program_.bounds()[i].lower, program_.scales()[i]);
      *x_u++ = bound_over(program_.bounds()[i].upper, program_.scales()[i]);
    }
    if (has_spare_) {
      *x_l = -kNoBound;
      *x_u = kNoBound;
    }
    for (const auto& rows : program_.rows()) {
      for (std::size_t i = 0; i < rows->bounds().size(); ++i) {
        *g_l++ = bound_over(rows->bounds()[i].lower, rows->scales()[i]);
        *g_u++ = bound_over(rows->bounds()[i].upper, rows->scales()[i]);
      }
    }
    return true;
  }

  bool get_starting_point(Index, bool, Number* x, bool, Number*, Number*, Index, bool,
                          Number*) override {
    for (std::size_t i = 0; i < unknown_count(); ++i) {
      *x++ = program_.starts()[i] / program_.scales()[i];
    }
    if (has_spare_) *x = 0.0;
    return true;
  }

  bool eval_f(Index, const Number* x, bool, Number& value) override {
    return guarded([&] {
      const Evaluation& here = search_.at(unknowns(x));
      value = here.objective / search_.assembly().objective_scale();
      if (has_spare_) value += 0.5 * x[unknown_count()] * x[unknown_count()];
      return here.is_finite;
    });
  }
  bool eval_grad_f(Index, const Number* x, bool, Number* gradient) override {
    if (has_spare_) gradient[unknown_count()] = x[unknown_count()];
    return guarded([&] { return search_.gradient(unknowns(x), {gradient, unknown_count()}); });
  }
  bool eval_g(Index, const Number* x, bool, Index, Number* g) override {
    return guarded([&] {
      const Evaluation& here = search_.at(unknowns(x));
      std::copy(here.rows.begin(), here.rows.end(), g);
      return here.is_finite;
    });
  }
  bool eval_jac_g(Index, const Number* x, bool, Index, Index, Index* rows, Index* columns,
                  Number* values) override {
    const std::vector<Place>& places = search_.assembly().jacobian_places();
    if (values == nullptr) return give(places, rows, columns);
    return guarded([&] { return search_.jacobian(unknowns(x), {values, places.size()}); });
  }
  bool eval_h(Index, const Number* x, bool, Number factor, Index m, const Number* lambda, bool,
              Index, Index* rows, Index* columns, Number* values) override {
    const std::vector<Place>& places = search_.assembly().hessian_places();
    if (values == nullptr) {
      if (has_spare_) rows[places.size()] = columns[places.size()] = program_.variable_count();
      return give(places, rows, columns);
    }
    if (has_spare_) values[places.size()] = factor;
    return guarded([&] {
      const std::span<const double> multipliers(lambda, static_cast<std::size_t>(m));
      return search_.hessian(unknowns(x), factor, multipliers, {values, places.size()});
    });
  }

  // Called in each iteration of the restoration phase too. Ipopt's own violation is of another
  // kind: of rows between bounds it says how far they are from their slack variables.
  bool intermediate_callback(Ipopt::AlgorithmMode, Index iteration, Number, Number, Number, Number,
                             Number, Number, Number, Number, Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    return guarded([&] {
      end_.iterations = iteration;
      interruption_ = search_.interruption();
      if (interruption_) return false;
      NonlinearIterate iterate = search_.last_finite();
      iterate.iteration = iteration;
      if (search_.options().on_iterate) search_.options().on_iterate(iterate);
      return true;
    });
  }

  void finalize_solution(Ipopt::SolverReturn, Index, const Number* x, const Number*, const Number*,
                         Index m, const Number*, const Number* lambda, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    end_.scaled.assign(x, x + unknown_count());
    end_.multipliers.assign(lambda, lambda + m);
  }

 private:
  /// Without the spare one.
  std::size_t unknown_count() const { return program_.starts().size(); }
  std::span<const double> unknowns(const Number* x) const { return {x, unknown_count()}; }

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
  bool has_spare_;
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
  // By approximate minimum degree: left to itself MUMPS asks Scotch, whose order is another one in
  // each run, and with it the last digits of every answer.
  set_count("mumps_pivot_order", kMinimumDegree);
  set_name("mu_strategy", "monotone");
  set_number("mu_init", options.first_barrier);
  // Near a solution multipliers of bounds that agree with the barrier lead on from there; 1 for
  // all, as usual, leads away first.
  const bool is_near = options.first_barrier < NonlinearOptions().first_barrier;
  set_name("bound_mult_init_method", is_near ? "mu-based" : "constant");
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
    case Ipopt::Feasible_Point_Found:  // of square problems, which it is not given
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
