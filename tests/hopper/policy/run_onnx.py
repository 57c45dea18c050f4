# SPDX-License-Identifier: Apache-2.0
"""run_onnx.py FOLDER COUNT: the same as run_onnx.mjs by OpenCV's networks. Exit code 77: there is
no OpenCV."""
import sys

try:
    import cv2
    import numpy
except ImportError:
    sys.exit(77)
folder, count = sys.argv[1:]
for model in range(int(count)):
    network = cv2.dnn.readNetFromONNX(f"{folder}/{model}.onnx")
    def table(ending):
        return numpy.loadtxt(f"{folder}/{model}.{ending}", dtype=numpy.float32, ndmin=2)

    with open(f"{folder}/{model}.onnx", "rb") as file:
        goes_by_time = b"course" in file.read()
    for row, course in zip(table("in"), table("course")):
        network.setInput(row.reshape(1, -1), "observation")
        if goes_by_time:
            network.setInput(course.reshape(1, -1), "course")
        action, target = network.forward(["action", "target"])
        print(*(f"{value:.9g}" for value in numpy.concatenate([action, target], axis=1)[0]))
