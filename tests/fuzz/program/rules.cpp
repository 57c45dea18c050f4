// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/documents/schema.hpp"
#include "tests/cli/no_number.hpp"
#include "tests/fuzz/program/command_files.hpp"

namespace torquewright::fuzz {
namespace {

using nlohmann::json;

constexpr std::size_t kMostComplaint = 5'000'000;
constexpr int kGreatestExitCode = 3;
constexpr int kBadInput = 2;
/// Who has used no more, and has not ended, waits for something.
constexpr double kAsleep_s = 1.0;

std::string ending(const std::string& name) { return fs::path(name).extension().string(); }

/// How long a plan is searched for where nobody says it (docs/flip.md).
constexpr double kUsualSearch_s = 600.0;

/// What a search was given by its command line. Plans are what is long by their nature.
double granted_s(const Words& words) {
  const auto asked = std::find(words.begin(), words.end(), "--time-limit");
  if (asked != words.end() && asked + 1 != words.end()) {
    const double stated_s = std::strtod((asked + 1)->c_str(), nullptr);
    return stated_s > 0.0 ? stated_s : 0.0;
  }
  if (works_until_told(words)) return std::numeric_limits<double>::infinity();
  const bool plans = words.size() > 1 && words[0] == "hopper" && words[1] == "flip";
  return plans ? kUsualSearch_s : 0.0;
}

double most_processor_s(const Run& run, const Limits& limits) {
  return limits.processor_s + granted_s(run.one.arguments);
}

std::string comes_to_an_end(const Run& run, const Limits& limits) {
  if (run.outcome.has_ended || works_until_told(run.one.arguments)) return "";
  const double used_s = run.outcome.processor_s;
  // Between the two it was the machine that had no time for it.
  if (used_s > kAsleep_s && used_s < most_processor_s(run, limits)) return "";
  return fmt::format("is still at it after {} s, {:.1f} of them of processors", limits.clock_s,
                     used_s);
}

std::string is_sound(const Run& run, const Limits&) {
  for (const char* word : {"Sanitizer", "runtime error: ", "Assertion"}) {
    if (run.outcome.err.find(word) != std::string::npos) return run.outcome.err.substr(0, 2000);
  }
  return "";
}

std::string ends_with_a_code(const Run& run, const Limits&) {
  const Outcome& outcome = run.outcome;
  if (!outcome.has_ended) return "";  // killed for that
  if (outcome.signal != 0) return fmt::format("signal {}", outcome.signal);
  if (outcome.exit_code >= 0 && outcome.exit_code <= kGreatestExitCode) return "";
  return fmt::format("exit code {}: {}", outcome.exit_code, outcome.err.substr(0, 500));
}

std::string says_why(const Run& run, const Limits&) {
  if (run.outcome.exit_code == kBadInput && run.outcome.err.empty()) return "2 without a sentence";
  if (run.outcome.err.size() > kMostComplaint) return "stderr without end";
  return "";
}

/// Answers repeat the names of files that they write, and words of the command line.
std::string has_numbers(const Run& run, const Limits&) {
  for (const std::string& word : run.one.arguments) {
    if (test::says_no_number(word)) return "";
  }
  for (const std::string& output : run.outputs) {
    if (test::says_no_number(output)) return "";
  }
  if (test::says_no_number(run.outcome.out)) return "nan or inf on stdout";
  for (const auto& [name, bytes] : run.written) {
    if (ending(name) != ".png" && test::says_no_number(bytes)) return "nan or inf in " + name;
  }
  return "";
}

bool asks_for_json(const Words& words) {
  return std::find(words.begin(), words.end(), "--json") != words.end();
}

std::string is_json(const Run& run, const Limits&) {
  const std::string& out = run.outcome.out;
  const bool prints_it = asks_for_json(run.one.arguments) && !out.empty() && out.front() == '{';
  if (prints_it && !json::accept(out)) return "stdout is no JSON";
  for (const auto& [path, bytes] : run.written) {
    // A journal is a line of JSON after another, whatever its file is called.
    const std::string name = path.substr(path.find('/') + 1);
    const bool is_meant_so =
        ending(name) == ".json" && bytes.starts_with('{') && !is_journal(run.one.arguments, name);
    if (is_meant_so && !json::accept(bytes)) return name + " is no JSON";
  }
  return "";
}

/// What is wrong with a document of ours: null where a number is to stand, above all.
std::string fault_of_document(const std::string& text, const std::string& place) {
  const json root = json::parse(text, nullptr, false);
  if (!root.is_object() || !root.contains("kind") || !root["kind"].is_string()) return "";
  const std::vector<std::string> kinds = io::document_kinds();
  const auto kind = root["kind"].get<std::string>();
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) return "";
  return io::conforms(root, kind) ? "" : place + " is no " + kind;
}

std::string conforms_to_schemas(const Run& run, const Limits&) {
  std::string fault = fault_of_document(run.outcome.out, "stdout");
  for (const auto& [name, bytes] : run.written) {
    const bool is_meant_so = ending(name) == ".json";
    if (fault.empty() && is_meant_so) fault = fault_of_document(bytes, name);
  }
  return fault;
}

/// Whether a changed file was asked for. It may lie in a folder that was named.
bool is_output(const Run& run, const std::string& name) {
  return std::any_of(run.outputs.begin(), run.outputs.end(), [&](const std::string& output) {
    return name == output || name.starts_with(output.ends_with('/') ? output : output + "/");
  });
}

std::string keeps_files(const Run& run, const Limits&) {
  for (const std::string& path : run.changed) {
    if (run.outputs.contains("..")) continue;  // the folder around all of them
    if (!path.starts_with("work/")) return path + " is left behind";
    const std::string name = path.substr(5);
    if (run.inputs.contains(name)) return name + " is an input and has changed";
    if (!is_output(run, name)) return name + " is no output and has changed";
    // A journal keeps what was done before something was refused.
    if (run.outcome.exit_code == kBadInput && !is_journal(run.one.arguments, name)) {
      return path + " has changed, although the exit code is 2";
    }
  }
  return "";
}

std::string is_small(const Run& run, const Limits& limits) {
  const Outcome& outcome = run.outcome;
  if (run.input_bytes > limits.input_bytes || !outcome.has_ended) return "";
  if (outcome.processor_s > most_processor_s(run, limits)) {
    return fmt::format("{:.1f} s of processors", outcome.processor_s);
  }
  if (outcome.resident_MB > limits.resident_MB)
    return fmt::format("{:.0f} MB", outcome.resident_MB);
  return "";
}

}  // namespace

bool works_until_told(const std::vector<std::string>& arguments) {
  return arguments.size() > 1 && arguments[0] == "hopper" && arguments[1] == "train";
}

Limits Limits::times(double factor) const {
  return {processor_s * factor, clock_s * factor, resident_MB * factor, input_bytes};
}

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all{
      {"sound", is_sound},
      {"end", comes_to_an_end},
      {"exit_code", ends_with_a_code},
      {"sentence", says_why},
      {"numbers", has_numbers},
      {"json", is_json},
      {"schema", conforms_to_schemas},
      {"files", keeps_files},
      {"small", is_small},
  };
  return all;
}

Breach breach_in(const Run& run, const Limits& limits) {
  for (const Rule& rule : rules()) {
    const std::string sentence = rule.breach(run, limits);
    if (!sentence.empty()) return {rule.name, sentence};
  }
  return {};
}

}  // namespace torquewright::fuzz
