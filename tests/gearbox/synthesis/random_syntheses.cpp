// SPDX-License-Identifier: Apache-2.0
// Random problems with `synthesis` of every topology, wide ranges of ratio, torque and bore. Each
// is searched and proved anew without the search, both with a limit of time; where it has few
// choices of whole numbers, an enumeration that shares no formula (tests/oracles/loaded_three_k)
// has its say. Prints a table, and the document of each problem that was not ended or answered
// falsely. Exit status: 0 if there was none.
#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <random>

#include "gearbox/sized_proof/sized_proof.hpp"
#include "gearbox/synthesis/synthesis.hpp"
#include "src/command_line/command_line.hpp"
#include "src/command_line/exit_status.hpp"
#include "tests/gearbox/synthesis/synthesis_example.hpp"
#include "tests/oracles/loaded_three_k.hpp"

namespace torquewright::bench {
namespace {

using nlohmann::json;

struct Options {
  int seed = 1;
  int first = 0;
  int count = 32;
  double limit_s = 60;
  std::int64_t oracle_choices = 12;
};

/// Of the process, so that other work on the machine does not count.
double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class Dice {
 public:
  explicit Dice(unsigned seed) : generator_(seed) {}
  int among(int low, int high) {
    return low + static_cast<int>(generator_() % static_cast<unsigned>(high - low + 1));
  }
  bool is_one_in(int count) { return among(1, count) == 1; }

 private:
  std::mt19937 generator_;
};

json random_problem(Dice& dice, const std::string& topology) {
  const bool is_single = topology == "planetary", is_compound = topology == "compound";
  json problem{{"kind", "gearbox_problem"}, {"version", 1}, {"topology", topology}};
  problem["target_ratio"] = is_single     ? dice.among(30, 100) / 10.0
                            : is_compound ? dice.among(50, 200) / 10.0
                                          : dice.among(8, 50) * 1.0;
  problem["ratio_tolerance"] = dice.among(0, 2) / 100.0;
  problem["rotor_inner_diameter_mm"] = dice.among(400, 1200) / 10.0;
  problem["load"] = {{"output_torque_Nm", std::round(std::pow(10.0, dice.among(7, 25) / 10.0))},
                     {"cycles", std::llround(std::pow(10.0, dice.among(3, 8)))}};
  if (!dice.is_one_in(4)) problem["module_mm"] = dice.among(4, 12) / 10.0;
  if (!dice.is_one_in(4)) problem["planet_count"] = dice.among(3, 6);
  if (dice.is_one_in(2)) problem["min_teeth"] = {{"sun", dice.among(12, 40)}};
  if (problem.contains("min_teeth")) {
    if (is_single) {
      problem["min_teeth"]["planet"] = dice.among(12, 30);
    } else {
      problem["min_teeth"]["planet_1"] = dice.among(12, 30);
      problem["min_teeth"]["planet_2"] = dice.among(12, 20);
    }
  }
  if (dice.is_one_in(3)) problem["min_hollow_shaft_diameter_mm"] = dice.among(5, 20);
  if (dice.is_one_in(4)) problem["max_axial_length_mm"] = dice.among(8, 30);
  if (dice.is_one_in(4)) problem["min_backward_efficiency"] = dice.among(85, 97) / 100.0;
  problem["synthesis"] = json::object();
  if (dice.is_one_in(4)) problem["synthesis"]["max_profile_shift"] = dice.among(2, 8) / 10.0;
  if (dice.is_one_in(4)) problem["synthesis"]["min_profile_shift"] = -dice.among(0, 9) / 10.0;
  gearbox::assume_for_synthesis(problem);
  return problem;
}

/// One problem, and what is wrong with its answer; empty: nothing.
class Trial {
 public:
  Trial(const Options& options, json root)
      : options_(options), root_(std::move(root)), problem_(gearbox::test::problem_from(root_)) {}

  std::string run() {
    search();
    if (!fault_.empty()) return fault_;
    prove();
    ask_oracle();
    return fault_;
  }

  std::string row() const {
    const auto grams = [](double kg) {
      return std::isfinite(kg) ? fmt::format("{:.3f}", 1e3 * kg) : "none";
    };
    return fmt::format("| {} {} in {}, {} Nm | {} | {} | {} | {} | {:.2f} | {:.2f} | {} | {} |",
                       root_["topology"].get<std::string>(), root_["target_ratio"].dump(),
                       root_["rotor_inner_diameter_mm"].dump(),
                       root_["load"]["output_torque_Nm"].dump(), found_.choices, found_.boxes,
                       grams(best_kg()), grams(found_.bound_kg), search_s_, proof_s_, oracle_,
                       fault_);
  }

 private:
  double best_kg() const { return found_.best ? found_.best->mass_kg : INFINITY; }

  void search() {
    gearbox::SynthesisOptions options;
    const double start_s = cpu_s();
    options.should_stop = [&] { return cpu_s() - start_s > options_.limit_s; };
    found_ = gearbox::synthesise(problem_, options);
    search_s_ = cpu_s() - start_s;
    if (found_.status == gearbox::SynthesisStatus::kLimit) fault_ = "not ended";
  }

  void prove() {
    gearbox::sized::ProofEffort effort;
    const double start_s = cpu_s();
    effort.should_stop = [&] { return cpu_s() - start_s > options_.limit_s; };
    if (!gearbox::sized::prove_lightest(problem_, found_.bound_kg, effort).holds) {
      fault_ = effort.is_ended ? "proof not ended" : "not proved";
    }
    proof_s_ = cpu_s() - start_s;
  }

  /// Up to the gap and to what the ring's section is known to (as in random_synthesis_test).
  void ask_oracle() {
    if (found_.choices > options_.oracle_choices) return;
    const auto other = oracles::enumerate_loaded_trains(root_, 14);
    const double other_kg = other.lightest ? other.lightest->mass_kg : INFINITY;
    oracle_ = other.lightest ? fmt::format("{:.3f}", 1e3 * other_kg) : "none";
    if (other.choices != found_.choices) fault_ = "other choices";
    if (found_.bound_kg > other_kg * 1.0002) fault_ = "false bound";
    if (best_kg() > other_kg * 1.0012) fault_ = "too heavy";
  }

  const Options& options_;
  json root_;
  gearbox::Problem problem_;
  gearbox::SynthesisResult found_;
  double search_s_ = 0.0, proof_s_ = 0.0;
  std::string oracle_, fault_;
};

cli::ExitCode run(const Options& options) {
  fmt::print("| problem | choices | boxes | g | bound g | CPU s | proof s | oracle g | fault |\n");
  fmt::print("|---|---|---|---|---|---|---|---|---|\n");
  std::string faults;
  for (int i = options.first; i < options.first + options.count; ++i) {
    const auto parts = gearbox::all_train_parts();
    Dice dice(static_cast<unsigned>(1000 * options.seed + i));
    const std::string topology(parts[static_cast<std::size_t>(i) % parts.size()].name);
    json root = random_problem(dice, topology);
    Trial trial(options, root);
    const std::string fault = trial.run();
    fmt::print("{}\n", trial.row());
    std::fflush(stdout);
    if (fault.empty()) continue;
    root.erase("assumed");
    faults += fmt::format("{}, problem {}: {}\n", fault, i, root.dump());
    std::fputs(fmt::format("problem {}: {}\n", i, root.dump()).c_str(), stderr);
  }
  fmt::print("{}", faults);
  return faults.empty() ? cli::ExitCode::kPasses : cli::ExitCode::kFails;
}

}  // namespace
}  // namespace torquewright::bench

int main(int argc, char** argv) {
  using namespace torquewright;
  bench::Options options;
  command_line::Program program("random_syntheses",
                                "Random problems with synthesis, searched, proved, enumerated");
  command_line::Command& top = program.top();
  top.add_option("--seed", options.seed, "Of the problems (default 1)");
  top.add_option("--first", options.first, "Which of the problems is the first (default 0)");
  top.add_option("--count", options.count, "How many problems (default 32)");
  top.add_option("--limit", options.limit_s, "CPU seconds of each search and proof (default 60)");
  top.add_option("--oracle", options.oracle_choices,
                 "Enumerate problems of at most so many choices (default 12)");
  top.works([&] { return bench::run(options); });
  return command_line::exit_status([&] { return program.run(argc, argv); });
}
