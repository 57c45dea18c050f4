// SPDX-License-Identifier: Apache-2.0
// The same gearbox problems, in one run, for our search, Bonmin, MiniZinc with Gecode and the
// enumeration, every answer checked against the enumeration. Prints a Markdown table.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>

#include "bench/timed_answer.hpp"
#include "src/command_line/command_line.hpp"
#include "src/command_line/exit_status.hpp"
#include "tests/oracles/named_problems.hpp"

namespace torquewright::bench {
namespace {

using gearbox::Problem;
using io::Rational;

struct Options {
  std::string ours;
  double timeout_s = 60;
  int repeats = 3;
  std::int64_t largest_bore = 3000;
};

struct Solver {
  std::string name;
  std::function<std::optional<TimedAnswer>(const Problem&)> run;
};

// What the others' times are divided by.
constexpr const char* kReference = "torquewright, auto";

Problem wide_problem(std::int64_t bore, const Rational& tolerance) {
  Problem problem = oracles::paper_problem({12, 12, 12}, 0);
  if (bore > 0) {
    problem.rotor_inner_diameter_mm = bore;
    problem.module_mm = {1};
  }
  problem.ratio_tolerance = tolerance;
  problem.name = fmt::format("D/M {}, {}", bore > 0 ? std::to_string(bore) : "132.33",
                             tolerance == 0 ? "exact" : "1 %");
  return problem;
}

std::vector<Problem> problems(std::int64_t largest_bore) {
  std::vector<Problem> list{oracles::d151_problem()};
  for (const oracles::HardProblem& hard : oracles::hard_problems()) list.push_back(hard.problem);
  for (const std::int64_t bore : {0, 300, 1000, 3000}) {  // 0: the D151's own 79.4 mm / 0.6 mm.
    if (bore > largest_bore) continue;
    list.push_back(wide_problem(bore, 0));
    list.push_back(wide_problem(bore, Rational(1, 100)));
  }
  return list;
}

std::vector<Solver> solvers(const Options& options) {
  const double timeout_s = options.timeout_s;
  const auto bonmin = [timeout_s](BonminSettings settings) {
    return [=](const Problem& problem) {
      return run_bonmin(problem, BONMIN_DRIVER, settings, timeout_s);
    };
  };
  const auto ours = [options](const std::string& relaxation) {
    return [=](const Problem& problem) -> std::optional<TimedAnswer> {
      if (options.ours.empty()) return std::nullopt;
      return run_ours(problem, options.ours, relaxation, options.timeout_s);
    };
  };
  return {{kReference, ours("auto")},
          {"torquewright, always", ours("always")},
          {"torquewright, never", ours("never")},
          {"Bonmin, rings kept", bonmin({false, 0})},
          {"Bonmin, rings eliminated", bonmin({true, 0})},
          {"Bonmin, rings kept, 3 re-solves", bonmin({false, 3})},
          {"Bonmin, rings eliminated, 3 re-solves", bonmin({true, 3})},
          {"MiniZinc + Gecode",
           [timeout_s](const Problem& problem) { return run_minizinc(problem, timeout_s); }}};
}

// The run of median time. One run is enough for whoever was stopped.
std::optional<TimedAnswer> median(const Solver& solver, const Problem& problem, int repeats) {
  std::vector<TimedAnswer> runs;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const std::optional<TimedAnswer> run = solver.run(problem);
    if (!run || run->timed_out) return run;
    runs.push_back(*run);
  }
  const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
  std::nth_element(runs.begin(), middle, runs.end(),
                   [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
  return *middle;
}

std::string teeth(const Answer& answer) {
  if (answer.teeth.size() < 3) return "-";
  return fmt::format("{}/{}/{}", answer.teeth[0], answer.teeth[1], answer.teeth[2]);
}

// In CPU seconds: on a busy model they vary least.
std::string times(double cpu_s, double ours_cpu_s) {
  return ours_cpu_s > 0 ? fmt::format("{:.3g}", cpu_s / ours_cpu_s) : "-";
}

void print_row(const std::string& problem, const std::string& solver, const std::string& seconds,
               const std::string& cpu_seconds, const std::string& ratio, const std::string& answer,
               const std::string& judgement, const std::string& effort) {
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} |\n", problem, solver, seconds, cpu_seconds,
             ratio, answer, judgement, effort);
  std::fflush(stdout);
}

void print_answer(const Problem& problem, const Solver& solver,
                  const std::optional<TimedAnswer>& run, const oracles::Enumeration& truth,
                  double ours_cpu_s) {
  if (!run) {
    print_row(problem.name, solver.name, "-", "-", "-", "-", "not run", "");
  } else if (run->timed_out) {
    print_row(problem.name, solver.name, fmt::format("> {:.3g}", run->seconds),
              fmt::format("> {:.3g}", run->cpu_seconds),
              ours_cpu_s > 0 ? "> " + times(run->cpu_seconds, ours_cpu_s) : "-", "-", "time-out",
              "");
  } else {
    print_row(problem.name, solver.name, fmt::format("{:.3g}", run->seconds),
              fmt::format("{:.3g}", run->cpu_seconds), times(run->cpu_seconds, ours_cpu_s),
              teeth(run->answer), verdict(run->answer, truth), run->effort);
  }
}

void compare(const Problem& problem, const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t start_cpu = std::clock();
  const oracles::Enumeration truth = oracles::enumerate(problem);
  const double enumeration_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double enumeration_cpu_s = static_cast<double>(std::clock() - start_cpu) / CLOCKS_PER_SEC;
  double ours_cpu_s = 0;
  for (const Solver& solver : solvers(options)) {
    const std::optional<TimedAnswer> run = median(solver, problem, options.repeats);
    if (ours_cpu_s == 0 && run && !run->timed_out && solver.name == kReference) {
      ours_cpu_s = run->cpu_seconds;
    }
    print_answer(problem, solver, run, truth, ours_cpu_s);
  }
  print_row(problem.name, "enumeration (in process)", fmt::format("{:.3g}", enumeration_s),
            fmt::format("{:.3g}", enumeration_cpu_s), times(enumeration_cpu_s, ours_cpu_s),
            fmt::format("{} feasible", truth.feasible.size()), "reference", "");
}

cli::ExitCode compare_all(const Options& options) {
  print_row("problem", "solver", "seconds", "CPU seconds", "times ours", "answer", "verdict",
            "effort");
  print_row("---", "---", "---", "---", "---", "---", "---", "---");
  for (const Problem& problem : problems(options.largest_bore)) compare(problem, options);
  return cli::ExitCode::kPasses;
}

}  // namespace
}  // namespace torquewright::bench

int main(int argc, char** argv) {
  using namespace torquewright;
  bench::Options options;
  command_line::Program program("gearbox_side_by_side", "Gearbox synthesis side by side");
  command_line::Command& top = program.top();
  top.add_option("--ours", options.ours, "The torquewright program").existing_file();
  top.add_option("--timeout", options.timeout_s, "s, for each solver and problem");
  top.add_option("--repeats", options.repeats, "Runs of which the median is shown")
      .integer_between(1, 99);
  top.add_option("--largest-bore", options.largest_bore, "Leave out problems with a larger D/M");
  top.works([&] { return bench::compare_all(options); });
  return command_line::exit_status([&] { return program.run(argc, argv); });
}
