"""Names of types, for annotations."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
WholeArray: TypeAlias = NDArray[np.int64]
AnyPath: TypeAlias = str | os.PathLike[str]
Overrides: TypeAlias = Mapping[str, Any]  # {key of the deck: value}
Names: TypeAlias = str | Iterable[str]
