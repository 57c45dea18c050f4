# SPDX-License-Identifier: Apache-2.0
"""See triton: semantics by the language's public reference (triton.language)."""

import torch

PROGRAM = 0
int32 = torch.int32


class constexpr:
    """Annotation, and a number known when a kernel is compiled: here the number itself."""

    def __new__(cls, value):
        return value


class Pointer:
    def __init__(self, array, offset):
        self.array, self.offset = array, offset

    def __add__(self, more):
        return Pointer(self.array, self.offset + more)


def load(pointer, mask=None, other=None):
    at = torch.as_tensor(pointer.offset)
    if mask is None:
        return pointer.array[at.long()]  # out of bounds is an error here
    found = pointer.array[torch.where(mask, at, torch.zeros_like(at)).long()]
    return torch.where(mask, found, torch.full_like(found, other))


def store(pointer, value, mask):
    pointer.array[pointer.offset[mask].long()] = value[mask]


def program_id(axis):
    assert axis == 0
    return PROGRAM


def arange(first, end):
    return torch.arange(first, end, dtype=torch.int32)


def static_range(*ends):
    return range(*ends)


def _both(one, other):
    like = one if isinstance(one, torch.Tensor) else other
    return [of if isinstance(of, torch.Tensor) else torch.full_like(like, of) for of in (one, other)]


def minimum(one, other):
    """Of a number and none the number, as the hardware's fmin."""
    return torch.fmin(*_both(one, other))


def maximum(one, other):
    return torch.fmax(*_both(one, other))


def where(condition, one, other):
    if not isinstance(one, torch.Tensor) and not isinstance(other, torch.Tensor):
        one = torch.full(condition.shape, one)
    return torch.where(condition, *_both(one, other))


sqrt, exp, abs, zeros_like = torch.sqrt, torch.exp, torch.abs, torch.zeros_like
