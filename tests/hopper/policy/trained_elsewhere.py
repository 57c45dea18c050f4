# SPDX-License-Identifier: Apache-2.0
"""Writes specs/policy/trained_elsewhere.onnx (Debian's python3-onnx 1.12) in the form that rsl_rl's
exporter gives to policies of Isaac Lab and mjlab, with drawn weights, and prints what it says of an
observation, by numpy: the numbers of onnx_test.cpp."""
import numpy
import onnx
from onnx import TensorProto, helper, numpy_helper

random = numpy.random.default_rng(46)
widths = [7, 16, 8, 2]
constants = []
nodes = []


def constant(name, values):
    constants.append(numpy_helper.from_array(numpy.asarray(values, dtype=numpy.float32), name))
    return name


def add(kind, inputs, name, output=None, **attributes):
    output = output or f"{name}_output_0"
    nodes.append(helper.make_node(kind, inputs, [output], name=name, **attributes))
    return output


mean = constant("normalizer._mean", random.normal(size=(1, 7)))
centred = add("Sub", ["obs", mean], "/normalizer/Sub")
deviation = constant("normalizer._std", random.uniform(0.3, 2, size=(1, 7)))
divisor = add("Add", [deviation, constant("eps", numpy.float32(1e-2))], "/normalizer/Add")
value = add("Div", [centred, divisor], "/normalizer/Div")
for i in range(3):
    weights = constant(f"actor.{2 * i}.weight", random.normal(size=(widths[i + 1], widths[i])) * 0.4)
    bias = constant(f"actor.{2 * i}.bias", random.normal(size=widths[i + 1]) * 0.1)
    value = add("Gemm", [value, weights, bias], f"/actor/{2 * i}/Gemm",
                "actions" if i == 2 else None, alpha=1.0, beta=1.0, transB=1)
    if i < 2:
        value = add("Elu", [value], f"/actor/{2 * i + 1}/Elu", alpha=1.0)

graph = helper.make_graph(
    nodes, "main_graph", [helper.make_tensor_value_info("obs", TensorProto.FLOAT, [1, 7])],
    [helper.make_tensor_value_info("actions", TensorProto.FLOAT, [1, 2])], constants)
model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 11)])
model.ir_version = 7
onnx.checker.check_model(model)
onnx.save(model, "specs/policy/trained_elsewhere.onnx")

numbers = {tensor.name: numpy_helper.to_array(tensor).astype(float) for tensor in constants}
observation = numpy.array([0.1, -0.2, 0.3, 0.4, -0.5, 0.6, -0.7])
shown = observation - numbers["normalizer._mean"][0]
shown /= numbers["normalizer._std"][0] + numbers["eps"]
for i in range(3):
    shown = numbers[f"actor.{2 * i}.weight"] @ shown + numbers[f"actor.{2 * i}.bias"]
    if i < 2:
        shown = numpy.where(shown > 0, shown, numpy.expm1(shown))
print([float(f"{number:.15g}") for number in shown])
