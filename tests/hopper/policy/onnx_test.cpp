// SPDX-License-Identifier: Apache-2.0
// Oracles: the policy itself, which a graph is to compute; arithmetic by hand of small graphs of
// other programs' forms. That the files are ONNX is for other programs to say: onnx_runtime_test.
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "hopper/policy/onnx_export.hpp"
#include "hopper/policy/onnx_import.hpp"
#include "io/files/file_bytes.hpp"
#include "tests/hopper/policy/sample_policies.hpp"

namespace torquewright::hopper {
namespace {

using learning::PolicyEvaluation;

TEST(Onnx, ComesBackAsThePolicyThatItWas) {
  for (const PolicyDocument& document : test::sample_policies()) {
    const OnnxGraph graph = onnx_graph_in(onnx_bytes(onnx_graph_of(document)));
    PolicyEvaluation was(document.policy);
    PolicyEvaluation is(policy_of_graph(graph, ""));
    PolicyEvaluation target(policy_of_graph(graph, "target"));
    const Eigen::MatrixXd views = test::sample_observations(document, 20);
    for (const auto& view : views.colwise()) {
      const Eigen::VectorXd action = was.action(view);
      // Constants are floats in the file: 6e-8 of numbers of the order of 10.
      EXPECT_LT((is.action(view) - action).norm(), 5e-6);
      EXPECT_LT((target.action(view) - test::target_of(document, action)).norm(), 5e-6);
    }
    // Layers without an activation between them become one.
    if (document.policy.layers.front().activation.kind != learning::ActivationKind::kIdentity) {
      EXPECT_EQ(is.policy().estimator.size(), document.policy.estimator.size());
      EXPECT_EQ(is.policy().layers.front().weights, document.policy.layers.front().weights);
    }
    EXPECT_EQ(graph.metadata.front().second,
              "base_pitch_rad,base_pitch_rate_rad_s,knee_rad,knee_rad,phase_sin");
  }
}

/// A graph of two inputs with constants of common shapes, to which nodes are added.
struct ForeignGraph {
  OnnxGraph graph;

  ForeignGraph() {
    graph.inputs = {{"obs", {0, 2}}};
    graph.outputs = {{"out", {0, 2}}};
    constant("two", {}, {2.0});
    constant("row", {1, 2}, {0.5, -1.5});
    constant("square", {2, 2}, {1.0, 2.0, 3.0, 4.0});
    constant("epsilon", {1}, {1e-2});
  }
  void constant(const std::string& name, std::vector<std::int64_t> dimensions,
                std::vector<double> values) {
    graph.constants.push_back({name, std::move(dimensions), std::move(values), ""});
  }
  ForeignGraph& node(const std::string& type, std::vector<std::string> inputs, std::string output,
                     std::map<std::string, OnnxAttribute> attributes = {}) {
    graph.nodes.push_back({"n_" + output, type, std::move(inputs), {output}, attributes});
    return *this;
  }
  Eigen::Vector2d at(double x, double y) const {
    PolicyEvaluation policy(policy_of_graph(onnx_graph_in(onnx_bytes(graph)), ""));
    return policy.action(Eigen::Vector2d(x, y));
  }
  std::string refusal() const {
    try {
      policy_of_graph(onnx_graph_in(onnx_bytes(graph)), "");
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  }
};

OnnxAttribute whole(std::int64_t integer) { return {integer, 0.0, {}}; }
OnnxAttribute real(double number) { return {0, number, {}}; }

constexpr double kFloatError = 1e-6;

TEST(OnnxImport, NormalisesAsRslRlDoes) {
  // (obs - mean) / (deviation + epsilon), where the sum is a node of its own; then a layer.
  ForeignGraph foreign;
  foreign.constant("deviation", {1, 2}, {0.49, 0.99});
  foreign.constant("bias", {2}, {0.25, -0.25});
  foreign.node("Sub", {"obs", "row"}, "centred");
  foreign.node("Add", {"deviation", "epsilon"}, "divisor");
  foreign.node("Div", {"centred", "divisor"}, "normal");
  foreign.node("Gemm", {"normal", "square", "bias"}, "linear", {{"transB", whole(1)}});
  foreign.node("Elu", {"linear"}, "out");
  const double z1 = (1.0 - 0.5) / 0.5;
  const double z2 = (-2.0 + 1.5) / 1.0;
  const double a = z1 + 2.0 * z2 + 0.25;
  const double b = 3.0 * z1 + 4.0 * z2 - 0.25;
  const Eigen::Vector2d found = foreign.at(1.0, -2.0);
  EXPECT_NEAR(found(0), a > 0 ? a : std::expm1(a), kFloatError);
  EXPECT_NEAR(found(1), b > 0 ? b : std::expm1(b), kFloatError);
  const learning::Policy policy = policy_of_graph(onnx_graph_in(onnx_bytes(foreign.graph)), "");
  EXPECT_NEAR(policy.normalisation.mean(1), -1.5, 1e-7);
  EXPECT_NEAR(policy.normalisation.deviation(0), 0.5, 1e-7);
  EXPECT_EQ(policy.layers.size(), 1U);
}

// Oracle: numpy, in trained_elsewhere.py, which wrote the file with another program's library.
TEST(OnnxImport, ReadsAFileThatAnotherProgramWrote) {
  const OnnxGraph graph = onnx_graph_in(
      io::read_file_bytes(TORQUEWRIGHT_SOURCE_DIR "/specs/policy/trained_elsewhere.onnx"));
  PolicyEvaluation policy(policy_of_graph(graph, ""));
  Eigen::VectorXd observation(7);
  observation << 0.1, -0.2, 0.3, 0.4, -0.5, 0.6, -0.7;
  const Eigen::VectorXd action = policy.action(observation);
  EXPECT_NEAR(action(0), -1.88260811956579, 1e-13);
  EXPECT_NEAR(action(1), 1.87270412953284, 1e-13);
}

TEST(OnnxImport, UnderstandsMatMulThenAddAndFactorsOfGemm) {
  ForeignGraph foreign;
  foreign.node("Flatten", {"obs"}, "flat", {{"axis", whole(1)}});
  foreign.node("MatMul", {"flat", "square"}, "product");
  foreign.node("Add", {"row", "product"}, "sum");
  foreign.node("Tanh", {"sum"}, "bent");
  foreign.node("Gemm", {"bent", "square", "row"}, "linear",
               {{"alpha", real(0.5)}, {"beta", real(2.0)}});
  foreign.node("LeakyRelu", {"linear"}, "out", {{"alpha", real(0.2)}});
  const double a = std::tanh(0.3 * 1.0 + 0.1 * 3.0 + 0.5);
  const double b = std::tanh(0.3 * 2.0 + 0.1 * 4.0 - 1.5);
  const double c = 0.5 * (a * 1.0 + b * 3.0) + 2.0 * 0.5;
  const double d = 0.5 * (a * 2.0 + b * 4.0) - 2.0 * 1.5;
  const Eigen::Vector2d found = foreign.at(0.3, 0.1);
  EXPECT_NEAR(found(0), c > 0 ? c : 0.2 * c, kFloatError);
  EXPECT_NEAR(found(1), d > 0 ? d : 0.2 * d, kFloatError);
}

TEST(OnnxImport, UnderstandsArithmeticOnEitherSideAndBehindActivations) {
  ForeignGraph foreign;
  foreign.node("Sub", {"two", "obs"}, "turned");  // a factor that is no deviation
  foreign.node("Relu", {"turned"}, "bent");
  foreign.node("Mul", {"row", "bent"}, "scaled");
  foreign.node("Identity", {"scaled"}, "same");
  foreign.node("Add", {"same", "two"}, "out");
  const Eigen::Vector2d found = foreign.at(1.5, 5.0);
  EXPECT_NEAR(found(0), 0.5 * 0.5 + 2.0, kFloatError);
  EXPECT_NEAR(found(1), -1.5 * 0.0 + 2.0, kFloatError);
}

TEST(OnnxImport, RefusesByNameWhatItDoesNotUnderstand) {
  ForeignGraph clipped;
  clipped.node("Clip", {"obs"}, "held").node("Gemm", {"held", "square"}, "out");
  EXPECT_EQ(clipped.refusal().substr(0, 36), "node \"n_held\" (Clip): not understood");
  ForeignGraph recurrent;
  recurrent.graph.inputs.push_back({"h_in", {1, 64}});
  EXPECT_EQ(recurrent.node("Tanh", {"h_in"}, "held").node("Add", {"obs", "held"}, "out").refusal(),
            "its output \"out\" depends on 2 inputs (obs, h_in), and a policy here sees one: one "
            "with a memory is not understood");
  ForeignGraph squared;
  EXPECT_EQ(squared.node("Mul", {"obs", "obs"}, "out").refusal(),
            "node \"n_out\" (Mul): both sides depend on the input; one is to be a constant");
  ForeignGraph wide;
  wide.constant("wide", {3, 3}, std::vector<double>(9, 1.0));
  EXPECT_EQ(wide.node("MatMul", {"obs", "wide"}, "out").refusal(),
            "node \"n_out\" (MatMul): weights for 3 numbers, where there are 2");
  ForeignGraph unknown;
  unknown.graph.inputs = {{"obs", {0, 0}}};
  EXPECT_EQ(unknown.node("Tanh", {"obs"}, "out").refusal(),
            "its input \"obs\" does not say that it is from 1 to 4096 numbers");
  ForeignGraph divides;
  EXPECT_EQ(divides.node("Div", {"two", "obs"}, "out").refusal(),
            "node \"n_out\" (Div): it divides by what is 0 or depends on the input");
}

TEST(OnnxImport, PassesOverWhatTheOutputDoesNotDependOn) {
  ForeignGraph foreign;
  foreign.graph.inputs.push_back({"time", {1, 1}});
  foreign.node("Softmax", {"obs"}, "beside").node("Tanh", {"obs"}, "out");
  foreign.node("Add", {"out", "time"}, "later");
  EXPECT_NEAR(foreign.at(0.4, 0.0)(0), std::tanh(0.4), kFloatError);
}

// What goes by the time stands in the document; the network is the same without it.
TEST(OnnxImport, ReadsTheNetworkOfAPolicyThatCorrectsACourse) {
  const PolicyDocument document = test::policy_along_a_course();
  const OnnxGraph graph = onnx_graph_in(onnx_bytes(onnx_graph_of(document)));
  PolicyEvaluation was(document.policy);
  PolicyEvaluation is(policy_of_graph(graph, ""));
  const Eigen::MatrixXd views = test::sample_observations(document, 20);
  for (const auto& view : views.colwise()) {
    EXPECT_LT((is.action(view) - was.action(view)).norm(), 5e-6);  // floats, as above
  }
  EXPECT_THROW(policy_of_graph(graph, "target"), std::invalid_argument);
}

TEST(OnnxImport, RefusesEveryShortenedFileWithASentence) {
  const std::string bytes = onnx_bytes(onnx_graph_of(test::sample_policies()[5]));
  std::size_t refused = 0;
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    try {
      policy_of_graph(onnx_graph_in(bytes.substr(0, size)), "");
    } catch (const std::invalid_argument& error) {
      EXPECT_STRNE(error.what(), "");
      ++refused;
    }
  }
  EXPECT_GT(refused, bytes.size() / 7 - 100);
}

}  // namespace
}  // namespace torquewright::hopper
