// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/campaign.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <map>
#include <stdexcept>

#include "tests/fuzz/program/case_json.hpp"
#include "tests/fuzz/program/draw.hpp"
#include "tests/fuzz/program/example_commands.hpp"
#include "tests/fuzz/program/experiment.hpp"
#include "tests/fuzz/program/minimise.hpp"

namespace torquewright::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

const fs::path kKept = fs::path(TORQUEWRIGHT_SOURCE_DIR) / "tests/fuzz/corpus/program";
constexpr int kMostTrials = 300;
constexpr double kMostSeconds = 120.0;  ///< Of making one finding smaller.
constexpr double kProgressSeconds = 60.0;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// As a shell takes it.
std::string quoted(const Words& words) {
  std::string line;
  for (const std::string& word : words) {
    line += line.empty() ? "" : " ";
    const bool is_plain =
        !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
          return std::isalnum(c) != 0 ||
                 std::string("-_./=,:@+").find(static_cast<char>(c)) != std::string::npos;
        });
    if (is_plain) {
      line += word;
      continue;
    }
    line += "$'";
    for (const char c : word.substr(0, 500)) {
      const auto byte = static_cast<unsigned char>(c);
      const bool is_harmless = byte >= 0x20 && byte < 0x7F && c != '\'' && c != '\\';
      line += is_harmless ? std::string(1, c) : fmt::format("\\x{:02x}", byte);
    }
    line += "'";
  }
  return line;
}

void require_examples(const std::vector<DeclaredCommand>& vocabulary) {
  for (const DeclaredCommand& command : vocabulary) {
    const bool is_group =
        std::any_of(vocabulary.begin(), vocabulary.end(), [&](const DeclaredCommand& other) {
          return other.name.size() > command.name.size() && command.options.empty() &&
                 std::equal(command.name.begin(), command.name.end(), other.name.begin());
        });
    if (is_group || command.name.empty()) continue;
    const bool is_there =
        std::any_of(example_commands().begin(), example_commands().end(), [&](const Words& words) {
          return words.size() >= command.name.size() &&
                 std::equal(command.name.begin(), command.name.end(), words.begin());
        });
    if (!is_there) {
      throw std::runtime_error("tests/fuzz/program/example_commands.cpp has no line of " +
                               quoted(command.name));
    }
  }
}

class Campaign {
 public:
  explicit Campaign(const Plan& plan)
      : plan_(plan), experiment_(plan.program, Limits{}.times(plan.patience), plan.copies) {}

  int run() {
    const std::vector<DeclaredCommand> vocabulary = read_vocabulary(plan_.program);
    require_examples(vocabulary);
    for (const Words& words : example_commands()) {
      judge({words, {}}, "an example");
      if (by_code_.contains(2)) throw std::runtime_error("is refused: " + quoted(words));
    }
    run_kept();
    const auto start = Clock::now();
    auto told = start;
    for (std::uint64_t number = plan_.first; goes_on(number - plan_.first, start); ++number) {
      const Case one = draw_case(plan_.seed, number, vocabulary, experiment_.scene());
      if (is_left_out(one)) continue;
      judge(one, fmt::format("--seed {} --first {} --runs 1", plan_.seed, number));
      if (since(told) > kProgressSeconds) {
        told = Clock::now();
        fmt::print("{} runs, {} findings\n", runs_, findings_);
        std::fflush(stdout);
      }
    }
    print_counts(since(start));
    return findings_;
  }

  int repeat(const fs::path& file) {
    judge(read_case(file), file.string());
    return findings_;
  }

 private:
  bool goes_on(std::uint64_t done, Clock::time_point start) const {
    if (findings_ >= plan_.most_findings) return false;
    if (plan_.runs > 0 && done >= plan_.runs) return false;
    return plan_.seconds <= 0.0 || since(start) < plan_.seconds;
  }

  bool is_left_out(const Case& one) const {
    const std::string line = fmt::format("{}", fmt::join(one.arguments, " "));
    return std::any_of(plan_.without.begin(), plan_.without.end(),
                       [&](const std::string& start) { return line.starts_with(start); });
  }

  void run_kept() {
    std::vector<fs::path> files;
    if (fs::exists(kKept)) {
      for (const auto& entry : fs::directory_iterator(kKept)) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) judge(read_case(file), file.filename().string());
  }

  void judge(const Case& one, const std::string& origin) {
    const Run run = experiment_.perform(one);
    ++runs_;
    count(one, run.outcome, origin);
    const Breach breach = breach_in(run, Limits{}.times(plan_.patience));
    if (!breach.rule.empty()) report(one, origin, breach);
  }

  void count(const Case& one, const Outcome& outcome, const std::string& origin) {
    ++by_code_[outcome.exit_code];
    if (outcome.processor_s > slowest_s_) {
      slowest_s_ = outcome.processor_s;
      slowest_ = origin;
    }
    const auto end = one.arguments.begin() + std::min<long>(2, std::ssize(one.arguments));
    Words name(one.arguments.begin(), end);
    if (name.size() == 2 && name[1].find_first_of("./-") != std::string::npos) name.pop_back();
    Share& share = by_command_[quoted(name)];
    ++share.runs;
    share.processor_s += outcome.processor_s;
  }

  void report(const Case& one, const std::string& origin, const Breach& breach) {
    ++findings_;
    fmt::print("finding {} by {}\n  rule {}: {}\n  {}\n", findings_, origin, breach.rule,
               breach.sentence, quoted(one.arguments));
    std::fflush(stdout);
    const auto start = Clock::now();
    const Case small = minimised(
        one,
        [&](const Case& smaller) {
          if (since(start) > kMostSeconds) return false;
          return experiment_.breach_of(smaller).rule == breach.rule;
        },
        kMostTrials);
    fmt::print("  smaller: {}\n", quoted(small.arguments));
    for (const auto& [name, thing] : small.things) {
      fmt::print("  with {} ({} bytes) changed\n", name, thing.content.size());
    }
    keep(small, breach);
    std::fflush(stdout);
  }

  void keep(const Case& small, const Breach& breach) const {
    if (plan_.findings.empty()) return;
    fs::create_directories(plan_.findings);
    const fs::path file = plan_.findings / fmt::format("{}_{}_{}_{}.case", breach.rule, plan_.seed,
                                                       plan_.first, findings_);
    std::ofstream(file) << text_of(small);
    fmt::print("  repeat it: --case {}\n", file.string());
  }

  void print_counts(double seconds) const {
    fmt::print("{} runs in {:.1f} s, {} findings; slowest {:.2f} s of processors ({}); exit codes:",
               runs_, seconds, findings_, slowest_s_, slowest_);
    for (const auto& [code, count] : by_code_) fmt::print(" {}: {}", code, count);
    fmt::print("\n");
    for (const auto& [name, share] : by_command_) {
      if (share.runs < 10) continue;  // names that are none
      fmt::print("  {:<20} {:>8} runs, {:.3f} s each\n", name, share.runs,
                 share.processor_s / static_cast<double>(share.runs));
    }
  }

  struct Share {
    long runs = 0;
    double processor_s = 0.0;
  };

  Plan plan_;
  Experiment experiment_;
  int findings_ = 0;
  long runs_ = 0;
  double slowest_s_ = 0.0;
  std::string slowest_;  ///< Where it came from.
  std::map<int, long> by_code_;
  std::map<std::string, Share> by_command_;
};

}  // namespace

int run_campaign(const Plan& plan) { return Campaign(plan).run(); }

int repeat_case(const Plan& plan, const fs::path& file) { return Campaign(plan).repeat(file); }

}  // namespace torquewright::fuzz
