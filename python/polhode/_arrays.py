# SPDX-License-Identifier: MIT
"""Conversion of arguments to arrays of real numbers."""

import numpy as np

from .errors import Error


def reals(values, name):
    """An array of doubles.

    Raises:
        Error: if the values are not real numbers.
    """
    if hasattr(values, "detach"):  # a tensor of PyTorch
        values = values.detach().cpu().numpy()
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "fiu":
            raise TypeError(f"its type is {array.dtype}")
        return array.astype(np.float64, copy=False)
    except (TypeError, ValueError) as e:
        raise Error(f"{name} is not an array of real numbers: {e}") from None
