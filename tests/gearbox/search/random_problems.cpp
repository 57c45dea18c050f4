// SPDX-License-Identifier: Apache-2.0
// Our search against exhaustive enumeration on random problems. Prints a Markdown table and every
// disagreement with the problem's document. Exit status: 0 if there was none.
#include "tests/oracles/random_problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "src/command_line/command_line.hpp"
#include "src/command_line/exit_status.hpp"
#include "tests/gearbox/search/search_comparison.hpp"
#include "tests/oracles/problem_document.hpp"

namespace torquewright::bench {
namespace {

using gearbox::Problem;
using optimization::RelaxationUse;

const std::map<std::string, std::vector<RelaxationUse>> kRelaxations{
    {"auto", {RelaxationUse::kAuto}},
    {"always", {RelaxationUse::kAlways}},
    {"never", {RelaxationUse::kNever}},
    {"all", {RelaxationUse::kAuto, RelaxationUse::kAlways, RelaxationUse::kNever}}};

struct Options {
  std::uint64_t seed = 1;
  std::size_t count = 1000;
  bool addenda = false;
  std::string relaxation = "all";
  double slow_s = 5;
};

std::string name_of(RelaxationUse use) {
  return use == RelaxationUse::kAuto ? "auto" : use == RelaxationUse::kAlways ? "always" : "never";
}

/// Lines of the table, in the order in which they first appear.
class Tally {
 public:
  void add(const std::string& what, double amount = 1) {
    const auto known = std::find_if(lines_.begin(), lines_.end(),
                                    [&](const auto& line) { return line.first == what; });
    if (known == lines_.end()) {
      lines_.emplace_back(what, amount);
    } else {
      known->second += amount;
    }
  }

  void print() const {
    fmt::print("| | |\n|---|---:|\n");
    for (const auto& [what, amount] : lines_) fmt::print("| {} | {:.6g} |\n", what, amount);
  }

 private:
  std::vector<std::pair<std::string, double>> lines_;
};

void describe(const Problem& problem, const search_test::Truth& truth, Tally& tally) {
  tally.add("problems");
  tally.add("feasible", !truth.ranked.empty());
  tally.add("infeasible", truth.ranked.empty());
  tally.add("undecided by the enumeration", truth.is_doubtful);
  tally.add("ratio exact", problem.ratio_tolerance == 0);
  tally.add("ratio toleranced", problem.ratio_tolerance != 0);
  tally.add("one planet count", problem.planet_count.size() == 1);
  tally.add("several planet counts", problem.planet_count.size() > 1);
  tally.add("one module", problem.module_mm.size() == 1);
  tally.add("several modules", problem.module_mm.size() > 1);
  tally.add("3k, paper", problem.constraints == gearbox::ConstraintSet::kPaper);
  tally.add("3k, buildable",
            problem.topology == "3k" && problem.constraints == gearbox::ConstraintSet::kBuildable);
  tally.add("planetary, buildable", problem.topology == "planetary");
  for (const char* objective : {"paper_cost", "hollow_shaft", "mass", "forward_efficiency",
                                "backward_efficiency", "reflected_inertia"}) {
    tally.add(fmt::format("objective {}", objective),
              oracles::problem_document(problem).at("objective") == objective);
  }
  tally.add("enumeration, s", truth.seconds);
}

bool compare(const Problem& problem, std::size_t top, const Options& options, Tally& tally) {
  const search_test::Truth truth = search_test::enumerated(problem);
  describe(problem, truth, tally);
  if (truth.is_doubtful) return true;
  bool agrees = true;
  for (const RelaxationUse use : kRelaxations.at(options.relaxation)) {
    const search_test::Comparison found = search_test::compare(problem, truth, use, top);
    const std::string name = name_of(use);
    tally.add(name + ": disagreements", !found.disagreements.empty());
    tally.add(name + ": nodes", static_cast<double>(found.counts.nodes));
    tally.add(name + ": Ipopt solves", static_cast<double>(found.counts.relaxations));
    tally.add(name + ": search, s", found.search_s);
    tally.add(name + ": checker, s", found.check_s);
    agrees = agrees && found.disagreements.empty();
    for (const std::string& disagreement : found.disagreements) {
      fmt::print("{}, --relaxation {} --top {}: {}\n", problem.name, name, top, disagreement);
    }
    if (found.search_s + found.check_s > options.slow_s) {
      fmt::print("{}, --relaxation {} --top {}: slow, search {:.3g} s, checker {:.3g} s\n{}\n",
                 problem.name, name, top, found.search_s, found.check_s,
                 oracles::problem_document(problem).dump());
    }
  }
  if (!agrees) fmt::print("{}\n", oracles::problem_document(problem).dump());
  std::fflush(stdout);
  return agrees;
}

cli::ExitCode run(const Options& options) {
  Tally tally;
  bool agrees = true;
  std::size_t index = 0;
  for (const Problem& problem : oracles::random_problems(
           options.seed, options.count,
           options.addenda ? oracles::Addenda::kSomeStated : oracles::Addenda::kStandard)) {
    agrees = compare(problem, 1 + index++ % 5, options, tally) && agrees;
  }
  fmt::print("\n");
  tally.print();
  return agrees ? cli::ExitCode::kPasses : cli::ExitCode::kFails;
}

}  // namespace
}  // namespace torquewright::bench

int main(int argc, char** argv) {
  using namespace torquewright;
  bench::Options options;
  command_line::Program program(
      "random_problems", "Our search against exhaustive enumeration on random gearbox problems");
  command_line::Command& top = program.top();
  top.add_option("--seed", options.seed, "Of the problems (default 1)");
  top.add_option("--count", options.count, "How many problems (default 1000)");
  top.add_flag("--addenda", options.addenda, "State addenda of hob and shaper in some of them");
  top.add_option("--relaxation", options.relaxation, "auto, always, never or all (default)")
      .one_of({"auto", "always", "never", "all"});
  top.add_option("--slow", options.slow_s, "Also print what takes longer than this, s (default 5)");
  top.works([&] { return bench::run(options); });
  return command_line::exit_status([&] { return program.run(argc, argv); });
}
