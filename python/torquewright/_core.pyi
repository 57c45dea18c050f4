# SPDX-License-Identifier: Apache-2.0
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

version: str

def run(
    words: list[bytes], progress: Callable[[str], object] | None = None
) -> tuple[int, str]: ...
def read(file: bytes) -> str: ...

class RegionClip:
    def __init__(
        self,
        speed_rad_s: NDArray[np.float64],
        least_Nm: NDArray[np.float64],
        greatest_Nm: NDArray[np.float64],
        error_Nm: float,
    ) -> None: ...
    def clip(
        self, torque_Nm: NDArray[np.float64], speed_rad_s: NDArray[np.float64]
    ) -> NDArray[np.float64]: ...
