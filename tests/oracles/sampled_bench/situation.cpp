// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/situation.hpp"

#include <algorithm>

namespace torquewright::oracles::sampled {
namespace {

bool has_faults(const Situation& situation) {
  return std::any_of(situation.hidden.begin(), situation.hidden.end(),
                     [](const Effect& effect) { return is_log_fault(effect.name); });
}

Record record_with(const Situation& situation, bool with_faults) {
  Record all;
  all.laws = stated_laws(situation);
  all.chain = situation.chain;
  SamplingChain faultless = situation.chain;
  for (const Effect& effect : situation.hidden) {
    const bool fault = is_log_fault(effect.name);
    apply(effect, situation.plant, all.laws, fault && !with_faults ? faultless : all.chain);
  }
  all.laws.odd = situation.odd;
  if (with_faults) all.chain.odd = situation.sensor_odd;
  all.period_s = all.chain.sample_steps * kStep_s;
  double begins_s = 0.0;
  for (std::size_t k = 0; k < situation.runs.size(); ++k) {
    Draw draw(situation.seed * 1000 + k + 17);  // each run its own: the same noise with any fault
    all.runs.push_back(
        run_bench(situation.plant, all.laws, all.chain, situation.runs[k], begins_s, draw));
    begins_s += situation.runs[k].duration_s;
  }
  return all;
}

}  // namespace

Laws stated_laws(const Situation& situation) {
  Laws laws;
  SamplingChain chain;
  for (const Effect& effect : situation.declared) apply(effect, situation.plant, laws, chain);
  return laws;
}

Record record(const Situation& situation) { return record_with(situation, true); }

Record record_without_faults(const Situation& situation, const Record& recorded) {
  const bool same = !has_faults(situation) && situation.odd_kind.empty();
  return same ? recorded : record_with(situation, false);
}

}  // namespace torquewright::oracles::sampled
