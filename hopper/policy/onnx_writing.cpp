// SPDX-License-Identifier: Apache-2.0
// Numbers of fields are those of onnx.proto (ONNX 1.12).
#include <cstring>

#include "hopper/policy/onnx_graph.hpp"
#include "hopper/policy/protobuf.hpp"
#include "io/documents/provenance.hpp"

namespace torquewright::hopper {
namespace {

constexpr std::int64_t kFormat = 7;       ///< Of the file; read by every runtime since 2019.
constexpr std::int64_t kOperators = 11;   ///< Version of the operators' set.
constexpr std::int64_t kWrittenType = 1;  ///< TensorProto.DataType: float
constexpr std::int64_t kNumberAttribute = 1;
constexpr std::int64_t kIntegerAttribute = 2;

std::string tensor_bytes(const OnnxTensor& tensor) {
  ProtobufWriter writer;
  for (const std::int64_t dimension : tensor.dimensions) writer.integer(1, dimension);
  writer.integer(2, kWrittenType);
  writer.bytes(8, tensor.name);
  std::string raw;
  for (const double value : tensor.values) {
    const auto number = static_cast<float>(value);
    char bytes[sizeof number];
    std::memcpy(bytes, &number, sizeof number);
    raw.append(bytes, sizeof number);
  }
  writer.bytes(9, raw);
  return writer.text();
}

/// Whole numbers where the number is 0: no attribute that is written here may be both.
std::string attribute_bytes(const std::string& name, const OnnxAttribute& attribute) {
  ProtobufWriter writer;
  writer.bytes(1, name);
  if (attribute.number != 0.0) {
    writer.number(2, static_cast<float>(attribute.number));
    writer.integer(20, kNumberAttribute);
  } else {
    writer.integer(3, attribute.integer);
    writer.integer(20, kIntegerAttribute);
  }
  return writer.text();
}

std::string node_bytes(const OnnxNode& node) {
  ProtobufWriter writer;
  for (const std::string& input : node.inputs) writer.bytes(1, input);
  for (const std::string& output : node.outputs) writer.bytes(2, output);
  writer.bytes(3, node.name);
  writer.bytes(4, node.type);
  for (const auto& [name, attribute] : node.attributes) {
    writer.bytes(5, attribute_bytes(name, attribute));
  }
  return writer.text();
}

std::string value_bytes(const OnnxValue& value) {
  ProtobufWriter shape;
  for (const std::int64_t size : value.dimensions) {
    ProtobufWriter dimension;
    if (size > 0) {
      dimension.integer(1, size);
    } else {
      dimension.bytes(2, "batch");
    }
    shape.bytes(1, dimension.text());
  }
  ProtobufWriter tensor;
  tensor.integer(1, kWrittenType);
  tensor.bytes(2, shape.text());
  ProtobufWriter type;
  type.bytes(1, tensor.text());
  ProtobufWriter writer;
  writer.bytes(1, value.name);
  writer.bytes(2, type.text());
  return writer.text();
}

std::string graph_bytes(const OnnxGraph& graph) {
  ProtobufWriter writer;
  for (const OnnxNode& node : graph.nodes) writer.bytes(1, node_bytes(node));
  writer.bytes(2, "policy");
  for (const OnnxTensor& constant : graph.constants) writer.bytes(5, tensor_bytes(constant));
  for (const OnnxValue& input : graph.inputs) writer.bytes(11, value_bytes(input));
  for (const OnnxValue& output : graph.outputs) writer.bytes(12, value_bytes(output));
  return writer.text();
}

}  // namespace

std::string onnx_bytes(const OnnxGraph& graph) {
  ProtobufWriter operators;
  operators.bytes(1, "");
  operators.integer(2, kOperators);
  ProtobufWriter writer;
  writer.integer(1, kFormat);
  writer.bytes(2, "torquewright");
  writer.bytes(3, io::tool_version());
  writer.bytes(7, graph_bytes(graph));
  writer.bytes(8, operators.text());
  for (const auto& [key, value] : graph.metadata) {
    ProtobufWriter entry;
    entry.bytes(1, key);
    entry.bytes(2, value);
    writer.bytes(14, entry.text());
  }
  return writer.text();
}

}  // namespace torquewright::hopper
