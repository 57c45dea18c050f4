// SPDX-License-Identifier: Apache-2.0
// identification_peers CLASS FIRST_SEED COUNT: beside our names those of what people do with the
// same regressors of the torque equation. One line for each log, then the counts.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "actuator/motor/actuator_spec.hpp"
#include "bench/peers/torque_regressions.hpp"
#include "identification/confusions.hpp"
#include "identification/orders.hpp"
#include "tests/identification/rates/trial.hpp"

namespace {

using namespace torquewright;
using oracles::LogClass;
using oracles::Truth;

constexpr std::array<const char*, 4> kWho = {"torquewright", "fixed Coulomb + viscous",
                                             "least squares of everything, |t| > 3",
                                             "greedy by BIC"};

LogClass class_of(const std::string& name) {
  for (const LogClass each : {LogClass::kNone, LogClass::kOne, LogClass::kTwo,
                              LogClass::kCannotTell, LogClass::kOutside, LogClass::kShort}) {
    if (name == oracles::name_of(each)) return each;
  }
  fmt::print(stderr, "classes: none, one, two, cannot_tell, outside, short\n");
  std::exit(2);
}

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// The truth's effects that a list of names holds, alone or by an exact identity.
struct Judged {
  bool any_wrong = false, all_found = true;
};
Judged judge(const std::vector<std::string>& names, const Truth& truth,
             const identification::Bench& bench) {
  Judged judged;
  std::vector<bool> found(truth.effects.size(), false);
  for (const std::string& name : names) {
    bool is_right = false;
    for (const std::string& same : identification::exact_identities(bench, name)) {
      for (std::size_t e = 0; e < truth.effects.size(); ++e) {
        if (same != truth.effects[e].effect && !contains(truth.effects[e].same_as, same)) continue;
        is_right = true;
        found[e] = true;
      }
      is_right = is_right || contains(truth.acceptable, same);
    }
    // Certain of one where the log cannot tell.
    if (!is_right || truth.log_class == LogClass::kCannotTell) judged.any_wrong = true;
  }
  for (const bool each : found) judged.all_found = judged.all_found && each;
  return judged;
}

struct Count {
  int named = 0, wrong = 0, all_and_nothing_wrong = 0;
  std::string names;
  void add(bool is_named, bool is_wrong, bool is_all) {
    named += is_named;
    wrong += is_wrong;
    all_and_nothing_wrong += is_all && !is_wrong;
  }
};

void add_peers(const oracles::Scenario& scenario, const std::filesystem::path& folder,
               std::array<Count, 4>& counts) {
  using namespace identification;
  const oracles::ScenarioFiles files = oracles::write_scenario(folder, scenario);
  const Rig rig = read_rig(io::read_document(files.rig, "rig"));
  const Log log = read_log(files.logs, rig);
  const actuator::ReadActuator nominal = actuator::read_actuator(files.actuator);
  const Bench bench = make_bench(rig, log, 0, {&nominal.actuator});
  const std::vector<Signals> signals = prepare(log, bench, noise_levels(log, 0), {});
  if (!bench.has_torque_balance() || signals.empty()) {
    for (std::size_t who = 1; who < kWho.size(); ++who) {
      counts[who].add(false, false, scenario.truth.effects.empty());
    }
    return;
  }
  const Extent extent = extent_of(signals);
  const Orders orders = promising_orders(bench, signals, run_folds(log), extent);
  const SignalSource source(signals, {});
  const EquationFit fit(log, torque_equation(bench, extent, orders), source);
  const std::array<std::vector<std::string>, 4> names = {
      std::vector<std::string>{}, torquewright::bench::fixed_friction(fit),
      torquewright::bench::everything(fit), torquewright::bench::greedy_by_bic(fit)};
  for (std::size_t who = 1; who < kWho.size(); ++who) {
    const Judged judged = judge(names[who], scenario.truth, bench);
    counts[who].add(!names[who].empty(), judged.any_wrong, judged.all_found);
    counts[who].names.clear();
    for (const std::string& name : names[who]) counts[who].names += " " + name;
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    fmt::print(stderr, "usage: identification_peers CLASS FIRST_SEED COUNT\n");
    return 2;
  }
  const LogClass log_class = class_of(arguments[1]);
  const auto first = std::strtoull(arguments[2], nullptr, 10);
  const auto many = std::strtoull(arguments[3], nullptr, 10);
  const auto folder = std::filesystem::temp_directory_path() /
                      fmt::format("identification_peers_{}_{}", arguments[1], first);
  std::array<Count, 4> counts;
  for (unsigned long long seed = first; seed < first + many; ++seed) {
    const oracles::Scenario scenario = oracles::draw(log_class, seed);
    const rates::Outcome ours = rates::try_out(scenario, folder);
    counts[0].add(!ours.names.empty(), ours.any_wrong, ours.all_found);
    add_peers(scenario, folder, counts);
    fmt::print("{} {} |", seed, ours.truth);
    for (const std::string& name : ours.names) fmt::print(" {}", name);
    for (std::size_t who = 1; who < kWho.size(); ++who) fmt::print(" |{}", counts[who].names);
    fmt::print("\n");
    std::fflush(stdout);
  }
  for (std::size_t who = 0; who < kWho.size(); ++who) {
    fmt::print("{} | {} | {} logs | named {} | wrong {} | all and nothing wrong {}\n", arguments[1],
               kWho[who], many, counts[who].named, counts[who].wrong,
               counts[who].all_and_nothing_wrong);
  }
  std::filesystem::remove_all(folder);
  return 0;
}
