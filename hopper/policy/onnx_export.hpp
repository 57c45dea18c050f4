// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/policy/onnx_graph.hpp"
#include "hopper/policy/policy_document.hpp"

namespace torquewright::hopper {

/// The policy as a graph of Sub, Mul, Gemm, activations and, with an estimator, Concat: from
/// "observation" (rows x inputs) to "action", what the last layer says, and "target", which is
/// offset + scale times that. What the numbers are called and gains stand in its metadata.
OnnxGraph onnx_graph_of(const PolicyDocument& document);

}  // namespace torquewright::hopper
