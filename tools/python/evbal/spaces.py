"""Spaces of observations and actions: Gymnasium's where it can be imported, else two classes that declare as much."""

from __future__ import annotations

from typing import Any, Mapping, Optional

import numpy as np

try:
    from gymnasium import Env
    from gymnasium.spaces import Box, Dict
except ImportError:

    class Env:  # type: ignore[no-redef]
        """What Gymnasium's Env gives to an environment without wrappers."""

        @property
        def unwrapped(self) -> "Env":
            """The environment itself."""
            return self

        def reset(self, *, seed: Optional[int] = None, options: Optional[Mapping[str, Any]] = None) -> Any:
            """There is nothing to begin anew."""

        def close(self) -> None:
            """There is nothing to close."""

    class Box:  # type: ignore[no-redef]
        """Arrays of one shape and type, each number from `low` to `high`."""

        def __init__(self, low: int, high: int, shape: tuple[int, ...], dtype: Any = np.int32) -> None:
            self.low = np.full(shape, low, dtype)
            self.high = np.full(shape, high, dtype)
            self.shape = shape
            self.dtype = np.dtype(dtype)
            self._random = np.random.default_rng()

        def seed(self, seed: Optional[int] = None) -> None:
            """Begins the random numbers of sample() anew."""
            self._random = np.random.default_rng(seed)

        def __contains__(self, x: Any) -> bool:
            return self.contains(x)

        def sample(self) -> np.ndarray:
            """Any array of the space, all equally likely."""
            return self._random.integers(self.low, self.high, dtype=self.dtype, endpoint=True)

        def contains(self, x: Any) -> bool:
            """Whether `x` is an array of the space."""
            return (
                isinstance(x, np.ndarray)
                and x.shape == self.shape
                and np.can_cast(x.dtype, self.dtype)
                and bool(np.all(x >= self.low) and np.all(x <= self.high))
            )

    class Dict:  # type: ignore[no-redef]
        """Dictionaries with an entry of each of some spaces."""

        def __init__(self, spaces: Mapping[str, Box]) -> None:
            self.spaces = dict(spaces)

        def __getitem__(self, name: str) -> Box:
            return self.spaces[name]

        def __contains__(self, x: Any) -> bool:
            return self.contains(x)

        def contains(self, x: Any) -> bool:
            """Whether `x` has an array of each space, and nothing else."""
            return x.keys() == self.spaces.keys() and all(self.spaces[name].contains(x[name]) for name in x)
