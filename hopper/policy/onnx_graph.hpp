// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::hopper {

/// A constant of an ONNX graph.
struct OnnxTensor {
  std::string name;
  std::vector<std::int64_t> dimensions;  ///< None: a single number.
  std::vector<double> values;            ///< The last dimension runs first.
  std::string objection;  ///< Not empty: why its numbers cannot be used, where they matter.
};

/// An attribute of a node: whole numbers and others, whichever it has.
struct OnnxAttribute {
  std::int64_t integer = 0;
  double number = 0.0;
  OnnxTensor tensor;
};

struct OnnxNode {
  std::string name;  ///< May be empty.
  std::string type;  ///< Gemm, Elu.
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;
  std::map<std::string, OnnxAttribute> attributes;
};

/// What goes in or comes out: a matrix of any number of rows.
struct OnnxValue {
  std::string name;
  std::vector<std::int64_t> dimensions;  ///< 0: any.
};

/// An ONNX model (onnx.ai, "Open Neural Network Exchange Intermediate Representation") as far as
/// policies use it.
struct OnnxGraph {
  std::vector<OnnxNode> nodes;  ///< None before those whose outputs it takes.
  std::vector<OnnxTensor> constants;
  std::vector<OnnxValue> inputs;
  std::vector<OnnxValue> outputs;
  std::vector<std::pair<std::string, std::string>> metadata;
};

/// The graph as the bytes of a file; numbers become floats.
std::string onnx_bytes(const OnnxGraph& graph);

/// The graph that such bytes hold. Throws std::invalid_argument with a sentence where they hold
/// none.
OnnxGraph onnx_graph_in(std::string_view bytes);

}  // namespace torquewright::hopper
