// SPDX-License-Identifier: Apache-2.0
// The paper's gearbox problem for Bonmin's B-BB. Prints one JSON object.
#include <BonBonminSetup.hpp>
#include <BonCbc.hpp>
#include <BonTMINLP.hpp>
#include <chrono>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "bench/peers/bonmin_model.hpp"
#include "bench/peers/problem_options.hpp"
#include "bench/verdict.hpp"
#include "src/command_line/exit_status.hpp"

namespace torquewright::bench {
namespace {

using Ipopt::Index;
using Ipopt::Number;

// Everything dense: there are at most six variables.
class GearboxProgram : public Bonmin::TMINLP {
 public:
  GearboxProgram(IntegerProgram program, double start)
      : program_(std::move(program)), start_(start) {}

  bool get_nlp_info(Index& n, Index& m, Index& jacobian, Index& hessian,
                    Ipopt::TNLP::IndexStyleEnum& style) override {
    n = variables();
    m = static_cast<Index>(program_.rows.size());
    jacobian = n * m;
    hessian = n * (n + 1) / 2;
    style = Ipopt::TNLP::C_STYLE;
    return true;
  }

  bool get_variables_types(Index n, VariableType* types) override {
    std::fill(types, types + n, INTEGER);
    return true;
  }

  bool get_variables_linearity(Index n, Ipopt::TNLP::LinearityType* types) override {
    std::fill(types, types + n, Ipopt::TNLP::NON_LINEAR);
    types[n - 1] = Ipopt::TNLP::LINEAR;  // The multiple k.
    return true;
  }

  bool get_constraints_linearity(Index m, Ipopt::TNLP::LinearityType* types) override {
    for (Index i = 0; i < m; ++i) {
      types[i] = row(i).body.terms.empty() ? Ipopt::TNLP::LINEAR : Ipopt::TNLP::NON_LINEAR;
    }
    return true;
  }

  bool get_bounds_info(Index n, Number* x_l, Number* x_u, Index m, Number* g_l,
                       Number* g_u) override {
    std::copy_n(program_.least.begin(), n, x_l);
    std::copy_n(program_.greatest.begin(), n, x_u);
    for (Index i = 0; i < m; ++i) {
      g_l[i] = row(i).least;
      g_u[i] = row(i).greatest;
    }
    return true;
  }

  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool,
                          Number*) override {
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
      x[i] = std::lerp(program_.least[i], program_.greatest[i], start_);
    }
    return true;
  }

  bool eval_f(Index, const Number* x, bool, Number& result) override {
    result = 1 / (x[0] * x[0]) + value(program_.objective, x);
    return true;
  }

  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    std::fill(gradient, gradient + n, 0.0);
    add_gradient(program_.objective, x, gradient);
    gradient[0] -= 2 / (x[0] * x[0] * x[0]);
    return true;
  }

  bool eval_g(Index, const Number* x, bool, Index m, Number* g) override {
    for (Index i = 0; i < m; ++i) g[i] = value(row(i).body, x);
    return true;
  }

  bool eval_jac_g(Index n, const Number* x, bool, Index m, Index count, Index* rows, Index* columns,
                  Number* values) override {
    if (values == nullptr) {
      for (Index k = 0; k < count; ++k) {
        rows[k] = k / n;
        columns[k] = k % n;
      }
      return true;
    }
    std::fill(values, values + count, 0.0);
    for (Index i = 0; i < m; ++i) add_gradient(row(i).body, x, values + i * n);
    return true;
  }

  bool eval_h(Index n, const Number* x, bool, Number factor, Index m, const Number* lambda, bool,
              Index count, Index* rows, Index* columns, Number* values) override {
    if (values == nullptr) {
      for (Index i = 0, k = 0; i < n; ++i) {
        for (Index j = 0; j <= i; ++j, ++k) {
          rows[k] = i;
          columns[k] = j;
        }
      }
      return true;
    }
    std::fill(values, values + count, 0.0);
    values[0] = factor * 6 / (x[0] * x[0] * x[0] * x[0]);
    add_hessian(program_.objective, factor, values);
    for (Index i = 0; i < m; ++i) add_hessian(row(i).body, lambda[i], values);
    return true;
  }

  void finalize_solution(SolverReturn, Index, const Number*, Number) override {}
  const BranchingInfo* branchingInfo() const override { return nullptr; }
  const SosInfo* sosConstraints() const override { return nullptr; }

 private:
  Index variables() const { return static_cast<Index>(program_.least.size()); }
  const BoundedRow& row(Index i) const { return program_.rows[static_cast<std::size_t>(i)]; }

  IntegerProgram program_;
  double start_;
};

std::string status_name(Bonmin::Bab::MipStatuses status) {
  switch (status) {
    case Bonmin::Bab::FeasibleOptimal:
      return "optimal";
    case Bonmin::Bab::ProvenInfeasible:
      return "infeasible";
    case Bonmin::Bab::Feasible:
      return "limit";
    default:
      return "none";
  }
}

std::string solver_options(const ProblemOptions& options) {
  const std::string again = std::to_string(options.resolves);
  return "bonmin.algorithm B-BB\nbonmin.bb_log_level 0\nbonmin.nlp_log_level 0\nprint_level 0\n"
         "sb yes\nbonmin.time_limit " +
         std::to_string(options.time_limit_s) + "\nbonmin.num_resolve_at_root " + again +
         "\nbonmin.num_resolve_at_node " + again + "\nbonmin.num_resolve_at_infeasibles " + again +
         "\n";
}

nlohmann::json solve(const ProblemOptions& options) {
  const Formulation formulation =
      options.rings_eliminated ? Formulation::kRingsEliminated : Formulation::kRingsKept;
  Bonmin::BonminSetup setup;
  setup.initializeOptionsAndJournalist();
  setup.readOptionsString(solver_options(options));
  setup.initialize(new GearboxProgram(formulate(options.problem(), formulation), options.start));
  Bonmin::Bab search;
  search(setup);
  nlohmann::json answer{{"status", status_name(search.mipStatus())}, {"nodes", search.numNodes()}};
  if (const double* x = search.bestSolution()) {
    answer["teeth"] = {std::lround(x[0]), std::lround(x[1]), std::lround(x[2])};
    answer["objective"] = search.bestObj();
  }
  return answer;
}

cli::ExitCode print_answer(const ProblemOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  nlohmann::json answer;
  try {
    answer = solve(options);
  } catch (...) {  // Bonmin throws objects of several unrelated types.
    answer = {{"status", "failed"}};
  }
  answer["seconds"] =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (options.check) answer["verdict"] = verdict(options.problem(), read_answer(answer));
  std::cout << answer.dump() << '\n';
  return cli::ExitCode::kPasses;
}

}  // namespace
}  // namespace torquewright::bench

int main(int argc, char** argv) {
  using namespace torquewright;
  bench::ProblemOptions options;
  command_line::Program program("bonmin_gearbox",
                                "The paper's gearbox problem, solved by Bonmin's B-BB");
  bench::add_problem_options(program.top(), options);
  program.top().works([&] { return bench::print_answer(options); });
  return command_line::exit_status([&] { return program.run(argc, argv); });
}
