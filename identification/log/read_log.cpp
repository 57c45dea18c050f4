// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "identification/log.hpp"
#include "identification/log/contents.hpp"
#include "identification/log/holdout.hpp"
#include "identification/log/log_reader.hpp"
#include "identification/log/motion.hpp"
#include "identification/log/repair.hpp"
#include "io/spec_error.hpp"
#include "io/wording.hpp"

namespace torquewright::identification {
namespace {

/// One sentence per run that has any. Stretches of a run follow one another.
void report_gaps(const std::vector<Stretch>& stretches, std::vector<DataFinding>& findings) {
  for (std::size_t i = 0; i < stretches.size();) {
    const std::string& name = stretches[i].run.name;
    std::size_t count = 0;
    Gap longest;
    for (; i < stretches.size() && stretches[i].run.name == name; ++i) {
      if (!stretches[i].gap) continue;
      ++count;
      if (stretches[i].gap->length_s > longest.length_s) longest = *stretches[i].gap;
    }
    if (count == 0) continue;
    findings.push_back(
        {Weight::kWarning,
         fmt::format("run \"{}\" has {} gap{} in time, the longest {:.4g} s after t = {:.6g} s, "
                     "where the median step is {:.4g} s; it is cut there",
                     name, count, count == 1 ? "" : "s", longest.length_s, longest.at_s,
                     longest.median_s)});
  }
}

/// What the load does not state cannot be corrected.
bool has_value(const Load& load, const std::string& pointer) {
  if (pointer.starts_with("/load/links/")) return true;  // checked when the rig was read
  const bool is_pendulum = load.type == LoadType::kPendulum;
  if (pointer == "/load/mass_kg") return is_pendulum || load.type == LoadType::kLinearAxis;
  if (pointer == "/load/length_m") return is_pendulum;
  if (pointer == "/load/inertia_kg_m2") return is_pendulum || load.type == LoadType::kFree;
  return true;
}

void report_rig(const Rig& rig, std::vector<DataFinding>& findings) {
  if (rig.joints_by_columns) {
    findings.push_back({Weight::kNote,
                        "the arm's joints, from the base on, are taken in the order "
                        "of the rig's columns: " +
                            io::listed(rig.joints)});
  }
  for (const std::string& pointer : rig.uncertain) {
    if (has_value(rig.load, pointer)) continue;
    findings.push_back({Weight::kNote, fmt::format("the rig calls {} uncertain, but a load of type "
                                                   "\"{}\" has no such value",
                                                   pointer, name_of(rig.load.type))});
  }
}

}  // namespace

Log read_log(const std::vector<std::filesystem::path>& files, const Rig& rig) {
  if (files.empty()) throw io::SpecError({{"", "", "no log is named"}});
  LogReader reader(files, rig);
  std::vector<Stretch> stretches;
  for (Stretch stretch; reader.next_stretch(stretch);) stretches.push_back(std::move(stretch));
  give_names(stretches, files);

  Log log;
  report_gaps(stretches, log.findings);
  for (Stretch& stretch : stretches) log.runs.push_back(std::move(stretch.run));
  log.files = reader.files_read();
  report_rig(rig, log.findings);
  Repairs repairs;
  for (Run& run : log.runs) repair(run, rig, repairs);
  report(repairs, rig, log.findings);
  check_motion(log, rig);
  choose_holdout(log, rig);
  check_contents(log, rig);
  return log;
}

}  // namespace torquewright::identification
