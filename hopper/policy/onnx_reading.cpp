// SPDX-License-Identifier: Apache-2.0
// Numbers of fields are those of onnx.proto (ONNX 1.12); what policies do not use is passed over.
#include <cmath>
#include <stdexcept>

#include "hopper/policy/onnx_graph.hpp"
#include "hopper/policy/protobuf.hpp"

namespace torquewright::hopper {
namespace {

constexpr std::int64_t kFloat = 1;
constexpr std::int64_t kDouble = 11;

std::string text_of(const ProtobufField& field) { return std::string(field.bytes); }

/// The fields of a tensor that matter, before its type says how its numbers stand.
struct TensorFields {
  std::int64_t type = 0;
  std::string_view raw;
  std::vector<double> numbers;
  bool is_elsewhere = false;
};

void add_numbers(const ProtobufField& field, bool is_double, std::vector<double>& numbers) {
  if (!field.is_bytes) {
    numbers.push_back(field.real);
    return;
  }
  const std::size_t size = is_double ? sizeof(double) : sizeof(float);
  for (std::size_t i = 0; i < field.bytes.size() / size; ++i) {
    numbers.push_back(is_double ? number_in<double>(field.bytes, i)
                                : number_in<float>(field.bytes, i));
  }
}

void add_dimensions(const ProtobufField& field, std::vector<std::int64_t>& dimensions) {
  if (!field.is_bytes) {
    dimensions.push_back(field.integer);
    return;
  }
  ProtobufReader packed(field.bytes);
  for (std::int64_t dimension = 0; packed.next_packed(dimension);) dimensions.push_back(dimension);
}

void finish(const TensorFields& fields, OnnxTensor& tensor) {
  if (fields.is_elsewhere) {
    tensor.objection = "its numbers lie in another file";
    return;
  }
  if (fields.type != kFloat && fields.type != kDouble) {
    tensor.objection = "its numbers are neither float nor double";
    return;
  }
  tensor.values = fields.numbers;
  ProtobufField raw;
  raw.is_bytes = true;
  raw.bytes = fields.raw;
  add_numbers(raw, fields.type == kDouble, tensor.values);
  double count = 1.0;
  bool is_shape = true;
  for (const std::int64_t dimension : tensor.dimensions) {
    count *= static_cast<double>(dimension);
    is_shape = is_shape && dimension >= 0;
  }
  if (!is_shape || count != static_cast<double>(tensor.values.size())) {
    tensor.objection = "it has not as many numbers as its shape says";
  }
  for (const double value : tensor.values) {
    if (!std::isfinite(value)) tensor.objection = "it has a number that is not finite";
  }
}

OnnxTensor tensor_in(std::string_view bytes) {
  OnnxTensor tensor;
  TensorFields fields;
  ProtobufReader reader(bytes);
  for (ProtobufField field; reader.next(field);) {
    if (field.number == 1) add_dimensions(field, tensor.dimensions);
    if (field.number == 2) fields.type = field.integer;
    if (field.number == 4) add_numbers(field, false, fields.numbers);
    if (field.number == 8) tensor.name = text_of(field);
    if (field.number == 9) fields.raw = field.bytes;
    if (field.number == 10) add_numbers(field, true, fields.numbers);
    if (field.number == 14) fields.is_elsewhere = field.integer != 0;
  }
  finish(fields, tensor);
  return tensor;
}

void read_attribute(std::string_view bytes, OnnxNode& node) {
  std::string name;
  OnnxAttribute attribute;
  ProtobufReader reader(bytes);
  for (ProtobufField field; reader.next(field);) {
    if (field.number == 1) name = text_of(field);
    if (field.number == 2) attribute.number = field.real;
    if (field.number == 3) attribute.integer = field.integer;
    if (field.number == 5) attribute.tensor = tensor_in(field.bytes);
  }
  node.attributes[name] = attribute;
}

OnnxNode node_in(std::string_view bytes) {
  OnnxNode node;
  ProtobufReader reader(bytes);
  for (ProtobufField field; reader.next(field);) {
    if (field.number == 1) node.inputs.push_back(text_of(field));
    if (field.number == 2) node.outputs.push_back(text_of(field));
    if (field.number == 3) node.name = text_of(field);
    if (field.number == 4) node.type = text_of(field);
    if (field.number == 5) read_attribute(field.bytes, node);
  }
  return node;
}

/// The bytes of a field of a message; empty where it has none.
std::string_view bytes_in(std::string_view bytes, int number) {
  ProtobufReader reader(bytes);
  std::string_view found;
  for (ProtobufField field; reader.next(field);) {
    if (field.number == number && field.is_bytes) found = field.bytes;
  }
  return found;
}

OnnxValue value_in(std::string_view bytes) {
  OnnxValue value;
  value.name = std::string(bytes_in(bytes, 1));
  // ValueInfoProto.type.tensor_type.shape
  ProtobufReader shape(bytes_in(bytes_in(bytes_in(bytes, 2), 1), 2));
  for (ProtobufField field; shape.next(field);) {
    if (field.number != 1) continue;
    ProtobufReader dimension(field.bytes);
    std::int64_t size = 0;
    for (ProtobufField part; dimension.next(part);) {
      if (part.number == 1) size = part.integer;
    }
    value.dimensions.push_back(size);
  }
  return value;
}

}  // namespace

OnnxGraph onnx_graph_in(std::string_view bytes) {
  OnnxGraph graph;
  std::string_view inside;
  ProtobufReader model(bytes);
  for (ProtobufField field; model.next(field);) {
    if (field.number == 7) inside = field.bytes;
    if (field.number == 14) {
      graph.metadata.emplace_back(bytes_in(field.bytes, 1), bytes_in(field.bytes, 2));
    }
  }
  ProtobufReader reader(inside);
  for (ProtobufField field; reader.next(field);) {
    if (!field.is_bytes) continue;
    if (field.number == 1) graph.nodes.push_back(node_in(field.bytes));
    if (field.number == 5) graph.constants.push_back(tensor_in(field.bytes));
    if (field.number == 11) graph.inputs.push_back(value_in(field.bytes));
    if (field.number == 12) graph.outputs.push_back(value_in(field.bytes));
  }
  if (graph.nodes.empty()) throw std::invalid_argument("it holds no graph");
  return graph;
}

}  // namespace torquewright::hopper
