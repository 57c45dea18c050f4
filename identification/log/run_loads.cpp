// SPDX-License-Identifier: Apache-2.0
#include "identification/log/run_loads.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/faults/json_text.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/nearest.hpp"

namespace torquewright::identification {

const Load& load_of(const Rig& rig, std::string_view run) {
  for (const std::string_view part : {kFirstPart, kLastPart, kFittedStates, kHeldOutStates}) {
    if (!rig.loads.contains(run) && run.ends_with(part)) run.remove_suffix(part.size());
  }
  const auto own = rig.loads.find(run);
  return own == rig.loads.end() ? rig.load : own->second;
}

void check_run_loads(const std::vector<std::string>& runs, const Rig& rig) {
  std::vector<io::Fault> faults;
  for (const auto& [run, load] : rig.loads) {
    if (std::find(runs.begin(), runs.end(), run) != runs.end()) continue;
    const auto near = io::nearest(run, runs);
    faults.push_back({rig.file, io::child_path("/loads", run),
                      fmt::format("no run \"{}\"{}", run,
                                  near ? fmt::format("; did you mean \"{}\"?", *near) : "")});
  }
  for (const std::string& run : runs) {
    if (rig.states_load || rig.loads.contains(run)) continue;
    faults.push_back({rig.file, io::child_path("/loads", run),
                      "missing; what does the actuator move in this run? (or \"load\", for all "
                      "runs that \"loads\" does not name)"});
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
}

}  // namespace torquewright::identification
