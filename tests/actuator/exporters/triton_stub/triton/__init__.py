# SPDX-License-Identifier: Apache-2.0
"""As much of Triton's language as the exported module speaks, on the processor: a block of threads
is an array of PyTorch, a pointer a flat array with an offset. It says nothing of Triton's compiler;
the kernels' arithmetic is the same."""

import inspect

import torch

from . import language

__version__ = "3.3.0"

CALLED = {}  # of the kernel that runs, by name: Triton knows functions by it


class _Kernel:
    def __init__(self, function):
        self.function = function
        self.names = inspect.signature(function).parameters

    def __call__(self, *given):
        name = self.function.__qualname__
        assert CALLED.setdefault(name, self) is self, f"two functions of a kernel are called {name}"
        return self.function(*given)

    def __getitem__(self, grid):
        def launch(*given):
            arguments = [
                language.Pointer(of.view(-1), 0) if isinstance(of, torch.Tensor) else of for of in given
            ]
            CALLED.clear()
            for language.PROGRAM in range(grid[0]):
                self.function(*arguments)

        return launch


def jit(function):
    return _Kernel(function)
