// SPDX-License-Identifier: Apache-2.0
#include "hopper/policy/onnx_export.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace torquewright::hopper {
namespace {

using learning::ActivationKind;

/// Adds nodes one behind the other; each gives its output's name.
class GraphBuilder {
 public:
  std::string constant(const std::string& name, const Eigen::VectorXd& values) {
    graph_.constants.push_back({name, {values.size()}, {values.begin(), values.end()}, ""});
    return name;
  }

  std::string add(const std::string& type, std::vector<std::string> inputs, std::string output,
                  std::map<std::string, OnnxAttribute> attributes = {}) {
    graph_.nodes.push_back({output, type, std::move(inputs), {output}, std::move(attributes)});
    return output;
  }

  std::string layers(const std::vector<learning::Layer>& layers, std::string shown,
                     const std::string& prefix, const std::string& last) {
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const std::string name = fmt::format("{}{}", prefix, i + 1);
      const bool is_last = i + 1 == layers.size();
      const bool has_activation = layers[i].activation.kind != ActivationKind::kIdentity;
      const std::string linear = is_last && !has_activation ? last : name + "_linear";
      shown = gemm(layers[i], shown, name, linear);
      if (has_activation) shown = activation(layers[i].activation, shown, is_last ? last : name);
    }
    return shown;
  }

  OnnxGraph& graph() { return graph_; }

 private:
  std::string gemm(const learning::Layer& layer, const std::string& shown, const std::string& name,
                   const std::string& output) {
    OnnxTensor weights{name + "_weights", {layer.weights.rows(), layer.weights.cols()}, {}, ""};
    for (Eigen::Index i = 0; i < layer.weights.rows(); ++i) {
      for (Eigen::Index j = 0; j < layer.weights.cols(); ++j) {
        weights.values.push_back(layer.weights(i, j));
      }
    }
    graph_.constants.push_back(std::move(weights));
    const std::string bias = constant(name + "_bias", layer.bias);
    OnnxAttribute is_transposed;
    is_transposed.integer = 1;
    return add("Gemm", {shown, name + "_weights", bias}, output, {{"transB", is_transposed}});
  }

  std::string activation(const learning::Activation& activation, const std::string& shown,
                         const std::string& output) {
    OnnxAttribute alpha;
    alpha.number = activation.alpha;
    switch (activation.kind) {
      case ActivationKind::kRelu:
        return add("Relu", {shown}, output);
      case ActivationKind::kTanh:
        return add("Tanh", {shown}, output);
      case ActivationKind::kElu:
        return activation.alpha == 0.0 ? add("Relu", {shown}, output)
                                       : add("Elu", {shown}, output, {{"alpha", alpha}});
      default:
        return activation.alpha == 0.0 ? add("Relu", {shown}, output)
                                       : add("LeakyRelu", {shown}, output, {{"alpha", alpha}});
    }
  }

  OnnxGraph graph_;
};

template <typename Named>
std::string names_of(const std::vector<Named>& all) {
  std::string text;
  for (const Named& named : all) text += (text.empty() ? "" : ",") + named.name;
  return text;
}

void add_metadata(const PolicyDocument& document, OnnxGraph& graph) {
  graph.metadata.emplace_back("inputs", names_of(document.inputs));
  graph.metadata.emplace_back("outputs", names_of(document.outputs));
  graph.metadata.emplace_back("control_period_s", fmt::format("{}", document.control_period_s));
  for (const PolicyGain& gain : document.gains) {
    graph.metadata.emplace_back("stiffness_Nm_rad of " + gain.drive,
                                fmt::format("{}", gain.stiffness_Nm_rad));
    graph.metadata.emplace_back("damping_Nm_s_rad of " + gain.drive,
                                fmt::format("{}", gain.damping_Nm_s_rad));
  }
  for (const PolicyOutput& output : document.outputs) {
    if (output.course.empty()) continue;
    graph.metadata.emplace_back("course of " + output.name,
                                fmt::format("{}", fmt::join(output.course, ",")));
  }
  if (!document.limits.empty()) graph.metadata.emplace_back("limits", document.limits);
  if (document.filters_sensors) graph.metadata.emplace_back("sensors", "filtered");
}

}  // namespace

OnnxGraph onnx_graph_of(const PolicyDocument& document) {
  const learning::Policy& policy = document.policy;
  const auto outputs = static_cast<Eigen::Index>(document.outputs.size());
  Eigen::VectorXd offset(outputs);
  Eigen::VectorXd scale(outputs);
  for (Eigen::Index i = 0; i < outputs; ++i) {
    offset(i) = document.outputs[static_cast<std::size_t>(i)].offset;
    scale(i) = document.outputs[static_cast<std::size_t>(i)].scale;
  }
  GraphBuilder builder;
  const std::string mean = builder.constant("mean", policy.normalisation.mean);
  const std::string inverse =
      builder.constant("inverse_deviation", policy.normalisation.deviation.cwiseInverse());
  const std::string centred = builder.add("Sub", {"observation", mean}, "centred");
  std::string shown = builder.add("Mul", {centred, inverse}, "normalised");
  if (!policy.estimator.empty()) {
    const std::string guess = builder.layers(policy.estimator, shown, "estimator_", "guess");
    OnnxAttribute axis;
    axis.integer = 1;
    shown = builder.add("Concat", {shown, guess}, "shown", {{"axis", axis}});
  }
  const std::string action = builder.layers(policy.layers, shown, "layer_", "action");
  const std::string scaled =
      builder.add("Mul", {action, builder.constant("scale", scale)}, "scaled");
  const bool goes_by_time =
      std::any_of(document.outputs.begin(), document.outputs.end(),
                  [](const PolicyOutput& output) { return !output.course.empty(); });
  const std::string offsets = builder.constant("offset", offset);
  if (goes_by_time) {
    builder.add("Add", {builder.add("Add", {scaled, offsets}, "corrected"), "course"}, "target");
  } else {
    builder.add("Add", {scaled, offsets}, "target");
  }
  OnnxGraph& graph = builder.graph();
  graph.inputs = {{"observation", {0, policy.inputs()}}};
  if (goes_by_time) graph.inputs.push_back({"course", {0, policy.outputs()}});
  graph.outputs = {{"action", {0, policy.outputs()}}, {"target", {0, policy.outputs()}}};
  add_metadata(document, graph);
  return graph;
}

}  // namespace torquewright::hopper
