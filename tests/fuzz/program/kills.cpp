// SPDX-License-Identifier: Apache-2.0
// Kills every command that writes files at random moments of its run, and looks at what is left:
// each file as it was or finished, those that belong together alike, and nothing else.
#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/files/file_bytes.hpp"
#include "src/command_line/command_line.hpp"
#include "src/command_line/exit_status.hpp"
#include "tests/fuzz/program/chance.hpp"
#include "tests/fuzz/program/command_files.hpp"
#include "tests/fuzz/program/example_commands.hpp"
#include "tests/fuzz/program/runner.hpp"
#include "tests/fuzz/program/scene.hpp"

namespace torquewright::bench {
namespace {

using namespace fuzz;
using std::chrono::microseconds;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPatience{120};
const std::string kOld = "old";

struct Options {
  std::string program = TORQUEWRIGHT_PROGRAM;
  int count = 1000;
  double seconds = 0.0;  ///< Of each command, then it ends with what it has; 0: until the count.
  std::string only;      ///< Command lines that begin so; empty: all.
  std::uint64_t seed = 1;
};

/// A command that writes files, and what a whole run of it leaves.
struct Victim {
  Words command;
  std::map<std::string, std::string> finished;  ///< Bytes by path in the scene.
  microseconds lasts{};
};

/// Of one command.
struct Counts {
  int kills = 0;
  int as_before = 0, done = 0;  ///< All files.
  int cut_short = 0;            ///< By Ctrl-C: whole files of a search that says so.
  int torn_by_kill = 0;         ///< KILL within the exchange (docs/decisions/0016).
  int left_by_kill = 0;         ///< Its temporary files, no more than one for each file.
  int wrong = 0;
};

class Bench {
 public:
  explicit Bench(const Options& options) : options_(options), random_(options.seed) {
    circumstances_ = {
        fs::absolute(options.program), scene_.folder(), scene_.temporary(), kPatience, {}};
  }

  int run() {
    int wrong = 0;
    fmt::print(
        "| command | lasts (s) | kills | as before | finished | cut short by Ctrl-C | KILL in the "
        "exchange | its temporary files | wrong "
        "|\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    for (const Words& command : example_commands()) {
      const bool is_asked = fmt::format("{}", fmt::join(command, " ")).starts_with(options_.only);
      if (!is_asked || outputs_of(command).empty()) continue;
      const Victim victim = whole_run(command);
      if (victim.finished.empty()) continue;  // it found nothing to be written
      const Counts counts = kill_many(victim);
      wrong += counts.wrong;
      const double lasts_s = 1e-6 * static_cast<double>(victim.lasts.count());
      fmt::print("| {} | {:.3f} | {} | {} | {} | {} | {} | {} | {} |\n", fmt::join(command, " "),
                 lasts_s, counts.kills, counts.as_before, counts.done, counts.cut_short,
                 counts.torn_by_kill, counts.left_by_kill, counts.wrong);
      std::fflush(stdout);
    }
    return wrong;
  }

 private:
  Victim whole_run(const Words& command) {
    scene_.lay_out({command, {}});
    const Look before = scene_.look();
    const Outcome outcome = fuzz::run(command, circumstances_);
    Victim victim{command, {}, microseconds(static_cast<long>(1e6 * outcome.clock_s))};
    for (const std::string& path : changed(before, scene_.look())) {
      const std::string name = path.substr(path.find('/') + 1);
      if (is_journal(command, name)) continue;  // written as points are done
      victim.finished[name] = io::read_file_bytes(scene_.folder() / ".." / path);
    }
    return victim;
  }

  Counts kill_many(Victim victim) {
    Counts counts;
    const auto start = Clock::now();
    while (counts.kills < options_.count) {
      const std::chrono::duration<double> over = Clock::now() - start;
      if (options_.seconds > 0.0 && over.count() > options_.seconds) break;
      kill_once(victim, counts);
    }
    return counts;
  }

  /// Half of the moments lie where files are written.
  microseconds moment(const Victim& victim) {
    const auto thousandth = static_cast<long>(one_below(1000, random_));
    const bool is_late = once_in(2, random_);
    return victim.lasts * (is_late ? 800 + thousandth * 3 / 10 : thousandth) / 1000;
  }

  /// The machine is not always as busy as it was in the whole run: moments follow it.
  static void learn_how_long(Victim& victim, microseconds killed_after, double clock_s) {
    const microseconds took(static_cast<long>(1e6 * clock_s));
    if (took < killed_after) victim.lasts = (victim.lasts + took) / 2;
    if (took >= killed_after && killed_after > victim.lasts) victim.lasts = killed_after;
  }

  void kill_once(Victim& victim, Counts& counts) {
    const std::vector<int> signals{SIGINT, SIGTERM, SIGHUP, SIGKILL};
    const int signal = one_of(signals, random_);
    Case one{victim.command, {}};
    const bool has_old = once_in(2, random_);
    for (const auto& [path, bytes] : victim.finished) {
      if (has_old) one.things[path] = {Thing::Kind::kFile, kOld};
    }
    scene_.lay_out(one);
    const Look before = scene_.look();
    const microseconds after = moment(victim);
    const Outcome outcome = fuzz::run(victim.command, circumstances_, Kill{signal, after});
    learn_how_long(victim, after, outcome.clock_s);
    judge(victim, before, has_old, signal, outcome, counts);
  }

  void judge(const Victim& victim, const Look& before, bool has_old, int signal,
             const Outcome& outcome, Counts& counts) {
    ++counts.kills;
    std::size_t untouched = 0, finished = 0, whole = 0;
    for (const auto& [path, bytes] : victim.finished) {
      const bool is_there = fs::exists(scene_.path(path));
      const std::string now = is_there ? io::read_file_bytes(scene_.path(path)) : "";
      const bool is_old = is_there == has_old && (!is_there || now == kOld);
      untouched += is_old ? 1 : 0;
      finished += now == bytes ? 1 : 0;
      // A search that was cut short before its first design says that it draws none.
      const bool is_left_out =
          is_old && (outcome.err.find(path + ": not written") != std::string::npos ||
                     outcome.err.find(path + ": not drawn") != std::string::npos);
      whole += is_left_out || (!is_old && is_there && ends_alike(now, bytes)) ? 1 : 0;
    }
    const std::size_t all = victim.finished.size();
    const std::size_t left = strangers(victim, before);
    const bool is_kill = signal == SIGKILL;
    // Ctrl-C ends a search, a count or a proof, and the files say so; what a time limit ends is
    // never twice the same.
    const bool is_cut_short = signal == SIGINT && outcome.exit_code >= 0 && whole == all;
    const bool is_timed = std::find(victim.command.begin(), victim.command.end(), "--time-limit") !=
                          victim.command.end();
    if (untouched == all && left == 0) {
      ++counts.as_before;
    } else if ((finished == all || (is_timed && whole == all)) && left == 0) {
      ++counts.done;
    } else if (is_cut_short && left == 0) {
      ++counts.cut_short;
    } else if (is_kill && untouched + (is_timed ? whole : finished) == all && left <= all) {
      counts.torn_by_kill += untouched < all && finished < all ? 1 : 0;
      counts.left_by_kill += left > 0 ? 1 : 0;
    } else {
      ++counts.wrong;
      fmt::print(stderr, "{}: signal {}: {} of {} files as before, {} finished, {} more left\n",
                 fmt::join(victim.command, " "), signal, untouched, all, finished, left);
    }
    if (!outcome.has_ended) ++counts.wrong;
  }

  /// Of a table's last row.
  static long columns(const std::string& table) {
    const std::size_t begin = table.rfind('\n', table.size() - 2);
    return std::count(table.begin() + static_cast<long>(begin + 1), table.end(), ',');
  }

  /// Whether a file of another content is whole too.
  static bool ends_alike(const std::string& one, const std::string& other) {
    if (other.starts_with('{')) return nlohmann::json::accept(one);
    if (other.starts_with("time_s,")) return one.ends_with('\n') && columns(one) == columns(other);
    const auto end = [](const std::string& text) {
      return text.substr(text.size() - std::min<std::size_t>(6, text.size()));
    };
    return end(one) == end(other);
  }

  std::size_t strangers(const Victim& victim, const Look& before) const {
    std::size_t count = 0;
    for (const std::string& path : changed(before, scene_.look())) {
      const std::string name = path.substr(path.find('/') + 1);
      count += victim.finished.contains(name) || is_journal(victim.command, name) ? 0 : 1;
    }
    return count;
  }

  Options options_;
  Random random_;
  Scene scene_;
  Circumstances circumstances_;
};

}  // namespace
}  // namespace torquewright::bench

int main(int argc, char** argv) {
  using namespace torquewright;
  bench::Options options;
  command_line::Program line("kills", "Kills commands that write files, and looks at what is left");
  command_line::Command& top = line.top();
  top.add_option("--program", options.program, "Another build of it").existing_file();
  top.add_option("--count", options.count, "Kills of each command");
  top.add_option("--seconds", options.seconds, "Of each command at most");
  top.add_option("--only", options.only, "Only command lines that begin so");
  top.add_option("--seed", options.seed, "Of signals and moments");
  top.works([&] {
    return bench::Bench(options).run() == 0 ? cli::ExitCode::kPasses : cli::ExitCode::kFails;
  });
  return command_line::exit_status([&] { return line.run(argc, argv); });
}
