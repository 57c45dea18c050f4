// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/read_log.hpp"

#include <fmt/format.h>

#include "identification/log/log.hpp"
#include "identification/log/run_groups.hpp"
#include "identification/log/spread_runs.hpp"
#include "identification/reading/commanded_torques.hpp"
#include "identification/reading/contents.hpp"
#include "identification/reading/feedforward.hpp"
#include "identification/reading/given_signs.hpp"
#include "identification/reading/holdout.hpp"
#include "identification/reading/log_reader.hpp"
#include "identification/reading/motion.hpp"
#include "identification/reading/repair.hpp"
#include "identification/reading/robot_commands.hpp"
#include "identification/reading/stale_rows.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/time_text.hpp"
#include "io/text/wording.hpp"

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
         fmt::format("run \"{}\" has {} gap{} in time, the longest {:.4g} s after t = {} s, "
                     "where the median step is {:.4g} s; it is cut there",
                     name, count, count == 1 ? "" : "s", longest.length_s,
                     io::time_text(longest.at_s), longest.median_s)});
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

/// What a long log changes: docs/logs.md.
void report_length(Log& log) {
  if (log.runs.is_in_memory()) return;
  std::size_t rows = 0, runs = 0;
  for (const std::size_t index : spread_runs(log.runs)) {
    rows += log.runs.head(index).samples;
    ++runs;
  }
  const std::string groups =
      runs_per_group(log) > 1.0
          ? fmt::format("; neighbouring runs are weighed together, {} groups in place of {} runs",
                        kMostGroups, log.train_runs.size() + log.holdout_runs.size())
          : "";
  log.findings.push_back(
      {Weight::kNote,
       fmt::format("the log holds {} rows; more than {} are not kept in memory: longer stretches "
                   "are cut in pieces, {} in all. Every row is checked; what is missing is sought "
                   "and judged in {} of them, evenly spread ({} rows){}",
                   log.runs.rows(), log.runs.most_rows_in_memory(), log.runs.size(), runs, rows,
                   groups)});
}

/// Runs as they were read, and the stretches without what they hold: name, file and gap.
std::vector<Stretch> read_runs(LogReader& reader, Runs& runs) {
  std::vector<Stretch> stretches;
  for (Stretch stretch; reader.next_stretch(stretch);) {
    if (!stretch.run.continues) {
      stretches.push_back({{}, stretch.file, stretch.gap});
      stretches.back().run.name = stretch.run.name;
    }
    runs.push_back(std::move(stretch.run));
  }
  if (runs.is_in_memory()) runs.join_pieces();
  return stretches;
}

/// What a recorder asked for before there was something new, and where it paused.
void mend_times(Runs& runs, std::vector<DataFinding>& findings) {
  std::size_t dropped = 0;
  std::vector<std::string> names;
  Pauses pauses;
  for (std::size_t i = 0; i < runs.size() && !runs.head(i).is_map; ++i) {
    Run run = runs[i];
    const std::size_t rows = drop_polled(run);
    pauses.add(run);
    if (rows == 0) continue;
    dropped += rows;
    if (names.empty() || names.back() != run.name) names.push_back(run.name);
    runs.change(i, [&run](Run& old) { old = std::move(run); });
  }
  if (dropped > 0) {
    findings.push_back(
        {Weight::kWarning, fmt::format("{} rows that repeat the row before between new ones that "
                                       "come at an even pace, asked for too soon: left out in {}",
                                       dropped, describe_runs(names))});
  }
  for (const std::string& each : pauses.sentences()) findings.push_back({Weight::kWarning, each});
}

void rename_runs(const std::vector<Stretch>& stretches, Runs& runs) {
  std::size_t stretch = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i > 0 && !runs.head(i).continues) ++stretch;
    runs.rename(i, stretches[stretch].run.name);
  }
}

/// What a sensor did from one sample to the next: of steady states none has a next.
void mend_and_check_motion(const Rig& rig, Log& log) {
  Repairs repairs;
  repair(log.runs, rig, repairs);
  report(repairs, rig, log.findings);
  check_motion(log, rig);
}

}  // namespace

Log read_log(const std::vector<std::filesystem::path>& files, const Rig& rig,
             std::size_t most_rows_in_memory) {
  if (files.empty()) throw io::SpecError({{"", "", "no log is named"}});
  LogReader reader(files, rig);
  Log log;
  log.runs = Runs(most_rows_in_memory);
  std::vector<Stretch> stretches = read_runs(reader, log.runs);
  give_names(stretches, files);
  rename_runs(stretches, log.runs);
  log.files = reader.files_read();
  log.findings = reader.findings();
  mend_times(log.runs, log.findings);
  report_gaps(stretches, log.findings);
  log.printed = reader.printed_steps();
  report_rig(rig, log.findings);
  if (!rig.load.is_steady) mend_and_check_motion(rig, log);
  check_robot_motion(rig, log);
  add_feedforward(rig, log);
  add_commanded_torques(rig, log);
  give_signs(rig, log);
  choose_holdout(log, rig);
  report_length(log);
  check_contents(log, rig);
  return log;
}

}  // namespace torquewright::identification
