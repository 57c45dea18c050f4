// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "hopper/policy/onnx_import.hpp"
#include "hopper/policy/policy_spec.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/file_bytes.hpp"
#include "src/commands/policy/policy_commands.hpp"
#include "src/options/output_files.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct PolicyImportOptions {
  std::string onnx_file;
  std::string node;  ///< Name of the graph's output.
  std::string like_file;
  std::vector<std::string> observations;
  std::vector<std::string> actions;
  std::vector<double> offsets;
  std::vector<double> scales;
  std::vector<std::string> stiffness;
  std::vector<std::string> damping;
  std::optional<double> control_period_s;
  std::string output_file;
};

learning::Policy network_in(const PolicyImportOptions& options) {
  try {
    return hopper::policy_of_graph(hopper::onnx_graph_in(io::read_file_bytes(options.onnx_file)),
                                   options.node);
  } catch (const std::invalid_argument& error) {
    io::refuse(options.onnx_file, fmt::format("no ONNX model of a policy: {}", error.what()));
  }
}

/// NAME, or NAME@STEPS for what is seen so many control periods late.
hopper::PolicyInput input_called(const std::string& word) {
  const std::size_t at = word.rfind('@');
  hopper::PolicyInput input{word.substr(0, at), "", 0};
  if (at != std::string::npos) {
    const char* end = word.data() + word.size();
    const auto read = std::from_chars(word.data() + at + 1, end, input.delay_steps);
    constexpr int kMostSteps = 100000;
    if (read.ec != std::errc() || read.ptr != end || input.delay_steps < 0 ||
        input.delay_steps > kMostSteps) {
      io::refuse("--observations " + word,
                 fmt::format("behind @ stands a whole number of steps, from 0 to {}", kMostSteps));
    }
  }
  if (input.name.find_first_not_of(" \t") == std::string::npos) {
    io::refuse("--observations " + word, "a name is missing");
  }
  input.unit = hopper::unit_in_name(input.name);
  return input;
}

double one_of(const std::vector<double>& values, std::size_t at, double otherwise,
              const char* option, std::size_t count) {
  if (values.empty()) return otherwise;
  if (values.size() == 1) return values.front();
  if (values.size() != count) {
    io::refuse(option, fmt::format("{} numbers, where there are {} actions: one for each, or one "
                                   "for all",
                                   values.size(), count));
  }
  return values[at];
}

/// DRIVE=VALUE, each drive once.
std::map<std::string, double> by_drive(const std::vector<std::string>& words, const char* option) {
  std::map<std::string, double> values;
  for (const std::string& word : words) {
    const std::size_t at = word.rfind('=');
    double value = -1.0;
    const char* end = word.data() + word.size();
    const bool is_pair = at != std::string::npos && at > 0;
    constexpr double kMost = 1e6;
    if (!is_pair || std::from_chars(word.data() + at + 1, end, value).ptr != end ||
        !(value >= 0.0 && value <= kMost)) {
      io::refuse(fmt::format("{} {}", option, word),
                 fmt::format("DRIVE=VALUE, a number from 0 to {:g}", kMost));
    }
    if (!values.emplace(word.substr(0, at), value).second) {
      io::refuse(fmt::format("{} {}", option, word), "the drive stands there twice");
    }
  }
  return values;
}

void set_gains(const PolicyImportOptions& options, hopper::PolicyDocument& document) {
  if (options.stiffness.empty() && options.damping.empty()) return;
  const std::map<std::string, double> stiffness = by_drive(options.stiffness, "--stiffness");
  std::map<std::string, double> damping = by_drive(options.damping, "--damping");
  document.gains.clear();
  for (const auto& [drive, value] : stiffness) {
    const auto found = damping.extract(drive);
    if (!found) io::refuse("--damping", fmt::format("\"{}\" has a stiffness only", drive));
    document.gains.push_back({drive, value, found.mapped()});
  }
  if (damping.empty()) return;
  io::refuse("--stiffness", fmt::format("\"{}\" has a damping only", damping.begin()->first));
}

void set_names(const PolicyImportOptions& options, hopper::PolicyDocument& document) {
  if (!options.observations.empty()) {
    document.inputs.clear();
    for (const std::string& word : options.observations) {
      document.inputs.push_back(input_called(word));
    }
  }
  if (!options.actions.empty()) {
    document.outputs.clear();
    for (const std::string& name : options.actions) {
      document.outputs.push_back({name, hopper::unit_in_name(name)});
    }
  }
  const auto inputs = static_cast<std::size_t>(document.policy.inputs());
  const auto outputs = static_cast<std::size_t>(document.policy.outputs());
  const auto require_count = [&](const char* option, std::size_t named, std::size_t are,
                                 const char* what) {
    if (named == are) return;
    io::refuse(option, fmt::format("has {} names, where {} has {} {}: name each, in its order",
                                   named, options.onnx_file, are, what));
  };
  require_count("--observations", document.inputs.size(), inputs, "inputs");
  require_count("--actions", document.outputs.size(), outputs, "outputs");
  for (std::size_t i = 0; i < outputs; ++i) {
    hopper::PolicyOutput& output = document.outputs[i];
    output.offset = one_of(options.offsets, i, output.offset, "--offset", outputs);
    output.scale = one_of(options.scales, i, output.scale, "--scale", outputs);
  }
}

/// What is said of training in a document like it is not said of this one.
hopper::PolicyDocument begun(const PolicyImportOptions& options) {
  if (options.like_file.empty()) return {};
  hopper::PolicyDocument like = hopper::read_policy(options.like_file).policy;
  like.limits.clear();
  like.trained_with.clear();
  return like;
}

ExitCode run_policy_import(const PolicyImportOptions& options) {
  hopper::PolicyDocument document = begun(options);
  document.policy = network_in(options);
  set_names(options, document);
  set_gains(options, document);
  if (options.control_period_s) document.control_period_s = *options.control_period_s;
  if (document.control_period_s == 0.0) {
    io::refuse("--control-period", "missing: the file does not say how often it acts");
  }
  check_written(named({options.output_file}), {options.onnx_file});
  const std::string text = hopper::policy_text(document);
  hopper::require_readable(text, options.onnx_file);
  deliver_result(text, options.output_file);
  return ExitCode::kPasses;
}

void add_names(command_line::Command& command, PolicyImportOptions& options) {
  command
      .add_option("--observations", options.observations,
                  "What the policy sees, in its order: NAME,NAME,..., each with @STEPS where it is "
                  "so many control periods late; units are those that names end in")
      .separated_by_commas()
      .otherwise("those of --like");
  command
      .add_option("--actions", options.actions,
                  "What the policy asks for, in its order: knee_target_rad,...")
      .separated_by_commas()
      .otherwise("those of --like");
  command
      .add_option("--offset", options.offsets,
                  "What is asked for where the network says 0, one for each action or one for all")
      .separated_by_commas()
      .otherwise("those of --like, else 0");
  command
      .add_option("--scale", options.scales,
                  "Factors on what the network says, one for each action or one for all")
      .separated_by_commas()
      .otherwise("those of --like, else 1");
}

void add_gains(command_line::Command& command, PolicyImportOptions& options) {
  command
      .add_option("--stiffness", options.stiffness,
                  "Stiffness of the PD law that follows the targets, in Nm/rad: DRIVE=VALUE,...")
      .separated_by_commas()
      .otherwise("those of --like, else none");
  command
      .add_option("--damping", options.damping,
                  "Damping of that law, in Nm s/rad, for the same drives: DRIVE=VALUE,...")
      .separated_by_commas()
      .otherwise("those of --like, else none");
}

}  // namespace

void add_policy_import_command(command_line::Command& policy) {
  auto options = std::make_shared<PolicyImportOptions>();
  command_line::Command command = policy.add_command(
      "import", "Read a policy that was trained elsewhere from an ONNX file, to judge it here");
  command.add_option("file", options->onnx_file, "ONNX model of a fully connected network")
      .required();
  command.add_option("--node", options->node, "Name of the model's output").otherwise("its first");
  command
      .add_option("--like", options->like_file,
                  "Document of kind policy whose names, gains and control period hold where none "
                  "are given here")
      .otherwise("none, and all is given here");
  add_names(command, *options);
  add_gains(command, *options);
  command
      .add_option("--control-period", options->control_period_s,
                  "Time from one action to the next, in s")
      .between(1e-5, 10.0)
      .otherwise("that of --like");
  command.add_option("-o,--output", options->output_file, "Write the document to this file")
      .otherwise("-, standard output")
      .names_a_file();
  command.example(
      "torquewright policy import specs/policy/trained_elsewhere.onnx --observations "
      "gravity_x,gravity_z,base_pitch_rate_rad_s,knee_rad,ankle_rad,knee_rad@1,ankle_rad@1 "
      "--actions knee_target_rad,ankle_target_rad --control-period 0.02");
  command.works([options] { return run_policy_import(*options); });
}

}  // namespace torquewright::cli
