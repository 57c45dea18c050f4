// SPDX-License-Identifier: Apache-2.0
#include "hopper/policy/c_source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/text/one_line.hpp"

namespace torquewright::hopper {
namespace {

using learning::Activation;
using learning::ActivationKind;
using learning::Layer;

constexpr int kPerLine = 8;

/// Decimals of a float, as C reads them.
std::string literal(double number) {
  std::string text = fmt::format("{}", static_cast<float>(number));
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + "f";
}

/// A comment's line. At its end neither a backslash nor what C99 takes for one, or it would go on.
std::string comment_line(const std::string& text) {
  std::string line = io::one_line(text);
  if (line.ends_with('\\') || line.ends_with("?"
                                             "?/"))
    line += '.';
  return "// " + line + "\n";
}

template <typename Numbers>
std::string array_of(const std::string& name, const Numbers& numbers) {
  std::string text = fmt::format("static const float policy_{}[{}] = {{", name, numbers.size());
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    text += (i % kPerLine == 0 ? "\n    " : " ") + literal(numbers(i)) + ",";
  }
  return text + "};\n";
}

std::string activation_of(const Activation& activation) {
  const std::string alpha = literal(activation.alpha);
  switch (activation.kind) {
    case ActivationKind::kRelu:
      return "sum > 0.0f ? sum : 0.0f";
    case ActivationKind::kLeakyRelu:
      return fmt::format("sum > 0.0f ? sum : {} * sum", alpha);
    case ActivationKind::kElu:
      return fmt::format("sum > 0.0f ? sum : {} * expm1f(sum)", alpha);
    case ActivationKind::kTanh:
      return "tanhf(sum)";
    default:
      return "sum";
  }
}

/// A function of a layer, and its numbers row by row.
std::string layer_text(const Layer& layer, const std::string& name) {
  const Eigen::MatrixXd by_rows = layer.weights.transpose();
  return array_of(name + "_weights", by_rows.reshaped()) + array_of(name + "_bias", layer.bias) +
         fmt::format(R"(
static inline void policy_{0}(const float* in, float* out) {{
  int i, j;
  for (i = 0; i < {1}; ++i) {{
    const float* row = policy_{0}_weights + i * {2};
    float sum = policy_{0}_bias[i];
    for (j = 0; j < {2}; ++j) sum += row[j] * in[j];
    out[i] = {3};
  }}
}}

)",
                     name, layer.bias.size(), layer.weights.cols(),
                     activation_of(layer.activation));
}

std::string layers_text(const std::vector<Layer>& layers, const std::string& prefix) {
  std::string text;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    text += layer_text(layers[i], fmt::format("{}{}", prefix, i + 1));
  }
  return text;
}

/// Calls of the layers from `in` to `out`, by arrays of their own between.
std::string calls_text(const std::vector<Layer>& layers, const std::string& prefix,
                       const std::string& in, const std::string& out) {
  std::string arrays;
  std::string calls;
  std::string from = in;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string name = fmt::format("{}{}", prefix, i + 1);
    const bool is_last = i + 1 == layers.size();
    const std::string to = is_last ? out : name + "_out";
    if (!is_last) arrays += fmt::format("  float {}[{}];\n", to, layers[i].bias.size());
    calls += fmt::format("  policy_{}({}, {});\n", name, from, to);
    from = to;
  }
  return arrays + calls;
}

bool needs_math(const learning::Policy& policy) {
  const auto needs = [](const std::vector<Layer>& layers) {
    for (const Layer& layer : layers) {
      const ActivationKind kind = layer.activation.kind;
      if (kind == ActivationKind::kElu || kind == ActivationKind::kTanh) return true;
    }
    return false;
  };
  return needs(policy.layers) || needs(policy.estimator);
}

/// NAME@STEPS: as it was so many control periods ago.
std::string meaning_text(const PolicyDocument& document) {
  std::string text;
  for (std::size_t i = 0; i < document.inputs.size(); ++i) {
    const PolicyInput& input = document.inputs[i];
    const std::string late = input.delay_steps > 0 ? fmt::format("@{}", input.delay_steps) : "";
    text +=
        comment_line(fmt::format("observation[{}]: {}{} [{}]", i, input.name, late, input.unit));
  }
  if (document.filters_sensors) {
    text += comment_line("positions and gravity: a filter's estimates (docs/randomisation.md)");
  }
  for (std::size_t i = 0; i < document.outputs.size(); ++i) {
    const PolicyOutput& output = document.outputs[i];
    text += comment_line(fmt::format("target[{}]: {} [{}]", i, output.name, output.unit));
  }
  for (const PolicyGain& gain : document.gains) {
    text += comment_line(fmt::format("{}: stiffness {} Nm/rad, damping {} Nm s/rad", gain.drive,
                                     gain.stiffness_Nm_rad, gain.damping_Nm_s_rad));
  }
  return text;
}

std::string action_text(const learning::Policy& policy) {
  const auto inputs = policy.inputs();
  std::string guess;
  if (!policy.estimator.empty()) {
    // The guess stands behind the inputs.
    guess = "  {\n" +
            calls_text(policy.estimator, "estimator_", "shown", fmt::format("shown + {}", inputs)) +
            "  }\n";
  }
  return fmt::format(R"(/* What the last layer says of an observation. */
static inline void policy_action(const float* observation, float* action) {{
  float shown[{0}];
  int k;
  for (k = 0; k < {1}; ++k) {{
    shown[k] = (observation[k] - policy_mean[k]) * policy_inverse_deviation[k];
  }}
{2}  {{
{3}  }}
}}
)",
                     policy.layers.front().weights.cols(), inputs, guess,
                     calls_text(policy.layers, "layer_", "shown", "action"));
}

bool has_course(const PolicyDocument& document) {
  return std::any_of(document.outputs.begin(), document.outputs.end(),
                     [](const PolicyOutput& output) { return !output.course.empty(); });
}

/// The courses, and the targets of a control period.
std::string courses_text(const PolicyDocument& document) {
  std::size_t periods = 1;
  for (const PolicyOutput& output : document.outputs) {
    periods = std::max(periods, output.course.size());
  }
  const auto outputs = static_cast<Eigen::Index>(document.outputs.size());
  Eigen::VectorXd course(outputs * static_cast<Eigen::Index>(periods));
  for (std::size_t period = 0; period < periods; ++period) {
    for (Eigen::Index i = 0; i < outputs; ++i) {
      course(static_cast<Eigen::Index>(period) * outputs + i) =
          course_at(document.outputs[static_cast<std::size_t>(i)], static_cast<long>(period));
    }
  }
  return array_of("course", course) + fmt::format(R"(
/* What an action asks for in a control period, counted from 0. */
static inline void policy_target(const float* action, long period, float* target) {{
  int k;
  if (period > {1}) period = {1};
  for (k = 0; k < {0}; ++k) {{
    target[k] = policy_offset[k] + policy_course[period * {0} + k] + policy_scale[k] * action[k];
  }}
}}
)",
                                                  outputs, periods - 1);
}

std::string target_text(const PolicyDocument& document) {
  const auto outputs = static_cast<Eigen::Index>(document.outputs.size());
  Eigen::VectorXd offset(outputs);
  Eigen::VectorXd scale(outputs);
  for (Eigen::Index i = 0; i < outputs; ++i) {
    offset(i) = document.outputs[static_cast<std::size_t>(i)].offset;
    scale(i) = document.outputs[static_cast<std::size_t>(i)].scale;
  }
  if (has_course(document)) {
    return array_of("offset", offset) + array_of("scale", scale) + courses_text(document);
  }
  return array_of("offset", offset) + array_of("scale", scale) +
         fmt::format(R"(
/* What an action asks for. */
static inline void policy_target(const float* action, float* target) {{
  int k;
  for (k = 0; k < {}; ++k) target[k] = policy_offset[k] + policy_scale[k] * action[k];
}}
)",
                     outputs);
}

}  // namespace

std::string c_source_of(const PolicyDocument& document, const std::vector<std::string>& origin) {
  const learning::Policy& policy = document.policy;
  std::string text;
  for (const std::string& line : origin) text += comment_line(line);
  text += meaning_text(document);
  text += "#ifndef TORQUEWRIGHT_POLICY\n#define TORQUEWRIGHT_POLICY\n\n";
  if (needs_math(policy)) text += "#include <math.h>\n\n";
  text += fmt::format("#define POLICY_INPUTS {}\n#define POLICY_OUTPUTS {}\n", policy.inputs(),
                      policy.outputs());
  text += fmt::format("#define POLICY_CONTROL_PERIOD_S {}\n\n", document.control_period_s);
  text += array_of("mean", policy.normalisation.mean);
  text += array_of("inverse_deviation", policy.normalisation.deviation.cwiseInverse());
  text += "\n" + layers_text(policy.estimator, "estimator_") + layers_text(policy.layers, "layer_");
  return text + action_text(policy) + "\n" + target_text(document) + "\n#endif\n";
}

}  // namespace torquewright::hopper
