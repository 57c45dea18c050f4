// SPDX-License-Identifier: Apache-2.0
#include "hopper/policy/onnx_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>

#include "hopper/policy/layer_chain.hpp"

namespace torquewright::hopper {
namespace {

using learning::ActivationKind;

constexpr std::int64_t kMostInputs = 4096;  ///< An activation of them alone is a layer of squares.
constexpr std::array<std::string_view, 4> kArithmetic{"Add", "Sub", "Mul", "Div"};
constexpr std::array<std::string_view, 4> kNoChange{"Identity", "Dropout", "Flatten", "Cast"};

template <std::size_t kCount>
bool is_one_of(const std::array<std::string_view, kCount>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

double computed(const std::string& type, double a, double b) {
  if (type == "Add") return a + b;
  if (type == "Sub") return a - b;
  return type == "Mul" ? a * b : a / b;
}

class GraphReader {
 public:
  explicit GraphReader(const OnnxGraph& graph) : graph_(graph) {
    for (const OnnxTensor& constant : graph.constants) constants_[constant.name] = constant;
  }

  learning::Policy read(const std::string& output) {
    if (graph_.outputs.empty()) throw std::invalid_argument("it has no output");
    const std::string wanted = output.empty() ? graph_.outputs.front().name : output;
    add_input(wanted);
    for (const OnnxNode& node : graph_.nodes) {
      for (const std::string& input : node.inputs) ++uses_[input];
    }
    for (const OnnxValue& value : graph_.outputs) ++uses_[value.name];
    ++uses_[wanted];
    for (const OnnxNode& node : graph_.nodes) {
      read_node(node);
      for (const std::string& input : node.inputs) forget_one_use(input);
    }
    const auto found = chains_.find(wanted);
    if (found != chains_.end()) return found->second.policy();
    const auto refused = refused_.find(wanted);
    if (refused != refused_.end()) throw std::invalid_argument(refused->second);
    throw std::invalid_argument(
        fmt::format("it has no output \"{}\" that depends on its input", wanted));
  }

 private:
  /// What nothing takes any more is dropped: each step of a chain is as large as its weights.
  void forget_one_use(const std::string& name) {
    if (--uses_[name] == 0) chains_.erase(name);
  }

  /// All that a value is computed from, itself too. Nodes stand in the order of their computation.
  std::set<std::string> behind(const std::string& value) const {
    std::set<std::string> needed{value};
    for (auto node = graph_.nodes.rbegin(); node != graph_.nodes.rend(); ++node) {
      if (std::any_of(node->outputs.begin(), node->outputs.end(),
                      [&](const std::string& one) { return needed.contains(one); })) {
        needed.insert(node->inputs.begin(), node->inputs.end());
      }
    }
    return needed;
  }

  /// The one input that the wanted value depends on; others are passed over. Old files name
  /// constants among the inputs too.
  void add_input(const std::string& wanted) {
    const std::set<std::string> needed = behind(wanted);
    std::vector<OnnxValue> inputs;
    for (const OnnxValue& input : graph_.inputs) {
      if (needed.contains(input.name) && !constants_.contains(input.name)) inputs.push_back(input);
    }
    if (inputs.empty()) {
      throw std::invalid_argument(
          fmt::format("it has no output \"{}\" that depends on its input", wanted));
    }
    if (inputs.size() > 1) {
      std::string names;
      for (const OnnxValue& input : inputs) names += (names.empty() ? "" : ", ") + input.name;
      throw std::invalid_argument(fmt::format(
          "its output \"{}\" depends on {} inputs ({}), and a policy here sees one: one "
          "with a memory is not understood",
          wanted, inputs.size(), names));
    }
    const auto& dimensions = inputs.front().dimensions;
    if (dimensions.empty() || dimensions.back() < 1 || dimensions.back() > kMostInputs) {
      throw std::invalid_argument(
          fmt::format("its input \"{}\" does not say that it is from 1 to {} numbers",
                      inputs.front().name, kMostInputs));
    }
    chains_.emplace(inputs.front().name, LayerChain(dimensions.back()));
  }

  /// A node that is not understood matters only where the output depends on it.
  void read_node(const OnnxNode& node) {
    if (node.outputs.empty()) return;
    for (const std::string& input : node.inputs) {
      const auto refused = refused_.find(input);
      if (refused == refused_.end()) continue;
      refused_[node.outputs.front()] = refused->second;
      return;
    }
    try {
      read_understood(node);
    } catch (const std::invalid_argument& error) {
      refused_[node.outputs.front()] =
          fmt::format("node \"{}\" ({}): {}", node.name.empty() ? node.outputs.front() : node.name,
                      node.type, error.what());
    }
  }

  void read_understood(const OnnxNode& node) {
    const std::string& output = node.outputs.front();
    if (node.type == "Constant") {
      const auto value = node.attributes.find("value");
      if (value == node.attributes.end()) throw std::invalid_argument("it is no tensor");
      constants_[output] = value->second.tensor;
    } else if (is_one_of(kNoChange, node.type)) {
      pass_on(node);
    } else if (is_one_of(kArithmetic, node.type)) {
      read_arithmetic(node);
    } else if (node.type == "Sqrt") {
      OnnxTensor root = constant(node, 0);
      for (double& value : root.values) value = std::sqrt(value);
      constants_[output] = root;
    } else if (node.type == "Gemm") {
      read_gemm(node);
    } else if (node.type == "MatMul") {
      LayerChain chain = chain_of(node, 0);
      const Eigen::MatrixXd weights = matrix(node, 1).transpose();
      multiply(chain, weights, Eigen::VectorXd::Zero(weights.rows()));
      chains_.insert_or_assign(output, std::move(chain));
    } else if (node.type == "Concat") {
      read_concat(node);
    } else {
      read_activation(node);
    }
  }

  void pass_on(const OnnxNode& node) {
    const std::string& input = input_of(node, 0);
    if (chains_.contains(input)) {
      chains_.insert_or_assign(node.outputs.front(), chains_.at(input));
    } else {
      constants_[node.outputs.front()] = constant(node, 0);
    }
  }

  void read_arithmetic(const OnnxNode& node) {
    const bool is_first = chains_.contains(input_of(node, 0));
    const bool is_second = chains_.contains(input_of(node, 1));
    if (is_first && is_second) {
      throw std::invalid_argument("both sides depend on the input; one is to be a constant");
    }
    if (!is_first && !is_second) {
      constants_[node.outputs.front()] = folded(node);
      return;
    }
    LayerChain chain = chain_of(node, is_first ? 0 : 1);
    const Eigen::VectorXd other = vector(node, is_first ? 1 : 0, chain.outputs());
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(chain.outputs());
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(chain.outputs());
    if (node.type == "Add") {
      chain.scale(one, other);
    } else if (node.type == "Sub") {
      is_first ? chain.scale(one, -other) : chain.scale(-one, other);
    } else if (node.type == "Mul") {
      chain.scale(other, zero);
    } else if (is_first && (other.array() != 0.0).all()) {
      chain.scale(other.cwiseInverse(), zero);
    } else {
      throw std::invalid_argument("it divides by what is 0 or depends on the input");
    }
    chains_.insert_or_assign(node.outputs.front(), std::move(chain));
  }

  OnnxTensor folded(const OnnxNode& node) const {
    OnnxTensor a = constant(node, 0);
    OnnxTensor b = constant(node, 1);
    if (a.values.size() == 1 && b.values.size() > 1) {
      a.dimensions = b.dimensions;
      a.values.resize(b.values.size(), a.values.front());
    }
    if (b.values.size() == 1) b.values.resize(a.values.size(), b.values.front());
    if (a.values.size() != b.values.size()) {
      throw std::invalid_argument("constants of two shapes");
    }
    for (std::size_t i = 0; i < a.values.size(); ++i) {
      a.values[i] = computed(node.type, a.values[i], b.values[i]);
    }
    return a;
  }

  void read_gemm(const OnnxNode& node) {
    const auto whole = [&](const char* name) {
      const auto found = node.attributes.find(name);
      return found == node.attributes.end() ? 0 : found->second.integer;
    };
    const auto factor = [&](const char* name) {
      const auto found = node.attributes.find(name);
      return found == node.attributes.end() ? 1.0 : found->second.number;
    };
    if (whole("transA") != 0) throw std::invalid_argument("its input is transposed");
    LayerChain chain = chain_of(node, 0);
    Eigen::MatrixXd weights = matrix(node, 1);
    if (whole("transB") == 0) weights.transposeInPlace();
    Eigen::VectorXd bias = Eigen::VectorXd::Zero(weights.rows());
    if (node.inputs.size() > 2 && !node.inputs[2].empty()) bias = vector(node, 2, weights.rows());
    multiply(chain, factor("alpha") * weights, factor("beta") * bias);
    chains_.insert_or_assign(node.outputs.front(), std::move(chain));
  }

  static void multiply(LayerChain& chain, const Eigen::MatrixXd& weights,
                       const Eigen::VectorXd& bias) {
    if (weights.cols() != chain.outputs()) {
      throw std::invalid_argument(fmt::format("weights for {} numbers, where there are {}",
                                              weights.cols(), chain.outputs()));
    }
    chain.multiply(weights, bias);
  }

  void read_concat(const OnnxNode& node) {
    if (node.inputs.size() != 2) throw std::invalid_argument("it joins more than two");
    LayerChain shown = chain_of(node, 0);
    const LayerChain guess = chain_of(node, 1);
    if (!shown.can_be_guessed_by(guess)) {
      throw std::invalid_argument("it does not join the normalised input and a network's guess");
    }
    shown.put_guess(guess);
    chains_.insert_or_assign(node.outputs.front(), std::move(shown));
  }

  void read_activation(const OnnxNode& node) {
    static const std::map<std::string, ActivationKind, std::less<>> kActivations{
        {"Relu", ActivationKind::kRelu},
        {"LeakyRelu", ActivationKind::kLeakyRelu},
        {"Elu", ActivationKind::kElu},
        {"Tanh", ActivationKind::kTanh}};
    const auto kind = kActivations.find(node.type);
    if (kind == kActivations.end()) {
      throw std::invalid_argument(
          "not understood; understood are Gemm, MatMul, Add, Sub, Mul, Div, Relu, LeakyRelu, Elu, "
          "Tanh, Identity, Flatten, Concat of an estimator");
    }
    learning::Activation activation = learning::activation_of(kind->second);
    const auto alpha = node.attributes.find("alpha");
    if (alpha != node.attributes.end()) activation.alpha = alpha->second.number;
    if (activation.alpha < 0.0) throw std::invalid_argument("its alpha is below 0");
    LayerChain chain = chain_of(node, 0);
    chain.activate(activation);
    chains_.insert_or_assign(node.outputs.front(), std::move(chain));
  }

  static const std::string& input_of(const OnnxNode& node, std::size_t at) {
    if (at >= node.inputs.size()) throw std::invalid_argument("an input is missing");
    return node.inputs[at];
  }

  LayerChain chain_of(const OnnxNode& node, std::size_t at) const {
    const auto found = chains_.find(input_of(node, at));
    if (found != chains_.end()) return found->second;
    throw std::invalid_argument(
        fmt::format("\"{}\" does not depend on the input", input_of(node, at)));
  }

  const OnnxTensor& constant(const OnnxNode& node, std::size_t at) const {
    const auto found = constants_.find(input_of(node, at));
    if (found == constants_.end()) {
      throw std::invalid_argument(fmt::format("\"{}\" is no constant", input_of(node, at)));
    }
    if (!found->second.objection.empty()) {
      throw std::invalid_argument(
          fmt::format("constant \"{}\": {}", input_of(node, at), found->second.objection));
    }
    return found->second;
  }

  /// A constant as so many numbers: one counts for all.
  Eigen::VectorXd vector(const OnnxNode& node, std::size_t at, Eigen::Index size) const {
    const OnnxTensor& tensor = constant(node, at);
    if (tensor.values.size() == 1) return Eigen::VectorXd::Constant(size, tensor.values.front());
    if (tensor.values.size() != static_cast<std::size_t>(size) ||
        tensor.dimensions.back() != size) {
      throw std::invalid_argument(
          fmt::format("constant \"{}\" is not a row of {} numbers", input_of(node, at), size));
    }
    return Eigen::Map<const Eigen::VectorXd>(tensor.values.data(), size);
  }

  Eigen::MatrixXd matrix(const OnnxNode& node, std::size_t at) const {
    const OnnxTensor& tensor = constant(node, at);
    if (tensor.dimensions.size() != 2 || tensor.values.empty()) {
      throw std::invalid_argument(fmt::format("constant \"{}\" is no matrix", input_of(node, at)));
    }
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    return Eigen::Map<const Rows>(tensor.values.data(), tensor.dimensions[0], tensor.dimensions[1]);
  }

  const OnnxGraph& graph_;
  std::map<std::string, OnnxTensor> constants_;
  std::map<std::string, LayerChain> chains_;
  std::map<std::string, int> uses_;
  std::map<std::string, std::string> refused_;  // outputs of nodes not understood, and why
};

}  // namespace

learning::Policy policy_of_graph(const OnnxGraph& graph, const std::string& output) {
  learning::Policy policy = GraphReader(graph).read(output);
  const std::string objection = learning::objection_to(policy);
  if (!objection.empty()) throw std::invalid_argument(objection);
  return policy;
}

}  // namespace torquewright::hopper
