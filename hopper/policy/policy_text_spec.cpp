// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "hopper/policy/policy_spec.hpp"
#include "io/documents/provenance.hpp"

namespace torquewright::hopper {
namespace {

using learning::Activation;
using learning::ActivationKind;
using learning::Layer;

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

/// The shortest decimals that are read as the same number; -0 is 0.
std::string decimal(double number) { return fmt::format("{}", number == 0.0 ? 0.0 : number); }

template <typename Numbers>
std::string list_of(const Numbers& numbers) {
  std::string text = "[";
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    text += (i > 0 ? ", " : "") + decimal(numbers(i));
  }
  return text + "]";
}

bool has_alpha(const Activation& activation) {
  return activation.kind == ActivationKind::kLeakyRelu || activation.kind == ActivationKind::kElu;
}

std::string activation_keys(const Activation& activation) {
  const std::string alpha =
      has_alpha(activation) ? fmt::format(", \"alpha\": {}", decimal(activation.alpha)) : "";
  return fmt::format("\"activation\": \"{}\"{}", name_of(activation.kind), alpha);
}

/// A line for each row of weights.
std::string layers_text(const std::vector<Layer>& layers, const Activation& common,
                        const std::string& indent) {
  std::string text = "[";
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const Layer& layer = layers[i];
    text += fmt::format("{}\n{}  {{\"weights\": [", i > 0 ? "," : "", indent);
    for (Eigen::Index row = 0; row < layer.weights.rows(); ++row) {
      text +=
          fmt::format("{}\n{}    {}", row > 0 ? "," : "", indent, list_of(layer.weights.row(row)));
    }
    text += fmt::format("],\n{}   \"bias\": {}", indent, list_of(layer.bias));
    const bool is_last = i + 1 == layers.size();
    const Activation usual = is_last ? learning::activation_of(ActivationKind::kIdentity) : common;
    if (layer.activation != usual) text += ", " + activation_keys(layer.activation);
    text += "}";
  }
  return text + "]";
}

std::string inputs_text(const std::vector<PolicyInput>& inputs) {
  std::vector<std::string> lines;
  for (const PolicyInput& input : inputs) {
    const std::string delay =
        input.delay_steps > 0 ? fmt::format(", \"delay_steps\": {}", input.delay_steps) : "";
    lines.push_back(fmt::format("    {{\"name\": {}, \"unit\": {}{}}}", quoted(input.name),
                                quoted(input.unit), delay));
  }
  return fmt::format("[\n{}]", fmt::join(lines, ",\n"));
}

std::string outputs_text(const std::vector<PolicyOutput>& outputs) {
  std::vector<std::string> lines;
  for (const PolicyOutput& output : outputs) {
    const Eigen::Map<const Eigen::VectorXd> course(output.course.data(),
                                                   static_cast<Eigen::Index>(output.course.size()));
    const std::string by_time =
        output.course.empty() ? "" : fmt::format(",\n     \"course\": {}", list_of(course));
    lines.push_back(fmt::format(
        "    {{\"name\": {}, \"unit\": {}, \"offset\": {}, \"scale\": {}{}}}", quoted(output.name),
        quoted(output.unit), decimal(output.offset), decimal(output.scale), by_time));
  }
  return fmt::format("[\n{}]", fmt::join(lines, ",\n"));
}

std::string gains_text(const std::vector<PolicyGain>& gains) {
  std::vector<std::string> stiffness;
  std::vector<std::string> damping;
  for (const PolicyGain& gain : gains) {
    stiffness.push_back(fmt::format("{}: {}", quoted(gain.drive), decimal(gain.stiffness_Nm_rad)));
    damping.push_back(fmt::format("{}: {}", quoted(gain.drive), decimal(gain.damping_Nm_s_rad)));
  }
  return fmt::format("{{\n    \"stiffness_Nm_rad\": {{{}}},\n    \"damping_Nm_s_rad\": {{{}}}}}",
                     fmt::join(stiffness, ", "), fmt::join(damping, ", "));
}

std::string trained_with_text(const std::vector<TrainedWith>& files) {
  std::vector<std::string> lines;
  for (const TrainedWith& file : files) {
    lines.push_back(fmt::format("    {{\"path\": {}, \"sha256\": {}}}", quoted(file.path),
                                quoted(file.sha256)));
  }
  return fmt::format("[\n{}]", fmt::join(lines, ",\n"));
}

}  // namespace

std::string policy_text(const PolicyDocument& document) {
  const learning::Policy& policy = document.policy;
  const Activation common = policy.layers.front().activation;
  std::vector<std::string> keys{"\"kind\": \"policy\"", "\"version\": 1"};
  const auto add_word = [&](const char* key, const std::string& word) {
    if (!word.empty()) keys.push_back(fmt::format("\"{}\": {}", key, quoted(word)));
  };
  add_word("name", document.name);
  add_word("task", document.task);
  if (!document.training_task.empty()) {
    keys.push_back("\"training_task\": " + document.training_task);
  }
  keys.push_back("\"inputs\": " + inputs_text(document.inputs));
  keys.push_back("\"outputs\": " + outputs_text(document.outputs));
  keys.push_back(activation_keys(common));
  keys.push_back("\"normalisation\": {\n    \"mean\": " + list_of(policy.normalisation.mean) +
                 ",\n    \"deviation\": " + list_of(policy.normalisation.deviation) + "}");
  if (!document.gains.empty()) keys.push_back("\"gains\": " + gains_text(document.gains));
  keys.push_back("\"control_period_s\": " + decimal(document.control_period_s));
  add_word("limits", document.limits);
  if (!document.trained_with.empty()) {
    keys.push_back("\"trained_with\": " + trained_with_text(document.trained_with));
  }
  keys.push_back("\"tool\": " + io::tool_provenance().dump());
  if (!policy.estimator.empty()) {
    keys.push_back(
        "\"estimator\": {\n    \"layers\": " + layers_text(policy.estimator, common, "    ") + "}");
  }
  keys.push_back("\"layers\": " + layers_text(policy.layers, common, "  "));
  return fmt::format("{{\n  {}\n}}\n", fmt::join(keys, ",\n  "));
}

}  // namespace torquewright::hopper
