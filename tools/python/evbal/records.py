"""Recorded runs and sweeps as arrays."""

from __future__ import annotations

import dataclasses
import os
from typing import Any, Union

import numpy as np

from evbal import _evbal


@dataclasses.dataclass(frozen=True)
class Run:
    """A finished run. `pandas.DataFrame(run.steps)` makes a table of its steps."""

    scenario: str
    day: str
    """Date that was played."""
    seed: int
    controller: str
    digest: str
    fallbacks: int
    """Plans that were not the controller's own."""
    step_minutes: int
    totals: dict[str, float]
    """Metrics of the day, by name."""
    steps: dict[str, np.ndarray]
    """Columns of steps.csv, each with a number a step."""
    regions: dict[str, np.ndarray]
    """Columns of regions.csv, each steps x regions."""


def read_run(folder: Union[str, os.PathLike[str]]) -> Run:
    """Reads the directory of a finished run. Raises Error if it holds none."""
    return Run(**_evbal.read_run(os.fspath(folder)))


def read_sweep(folder: Union[str, os.PathLike[str]]) -> dict[str, np.ndarray]:
    """Reads the days of a finished sweep: an array for each column, with an entry a day. `pandas.DataFrame` makes a table
    of them. Raises Error if the directory holds no sweep, or one that is not finished."""
    columns: dict[str, Any] = _evbal.read_sweep(os.fspath(folder))
    return {name: np.asarray(values) for name, values in columns.items()}
