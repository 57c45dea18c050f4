// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/policy/onnx_graph.hpp"
#include "learning/network/policy.hpp"

namespace torquewright::hopper {

/// The policy that a graph computes to one of its outputs (empty name: the first) from the one
/// input that this depends on. Understood are Gemm, MatMul, Add, Sub, Mul and Div with constants,
/// activations (Relu, LeakyRelu, Elu, Tanh), what changes nothing (Identity, Dropout, Flatten,
/// Cast), arithmetic among constants, and Concat of the normalised input and a network's guess.
/// What stands before the first layer becomes the normalisation.
///
/// Throws std::invalid_argument with a sentence that names the node where there is anything else.
learning::Policy policy_of_graph(const OnnxGraph& graph, const std::string& output);

}  // namespace torquewright::hopper
