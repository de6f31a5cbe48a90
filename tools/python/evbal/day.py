"""A day as an environment to learn in."""

from __future__ import annotations

import json
from typing import Any, Mapping, Optional, Union

import numpy as np

from evbal import _evbal
from evbal.spaces import Box, Dict, Env

Observation = dict[str, np.ndarray]
Info = dict[str, Any]


def _checked_seed(seed: int) -> int:
    if not 0 <= int(seed) < 2**64:
        raise _evbal.Error(f"seed: a number from 0 to 2^64 - 1 is expected, not {seed}")
    return int(seed)


class Day(Env):
    """Days of a scenario in this process, one after the other, stepped from plan to plan.

    Keeps to the interface of Gymnasium's Env, and is one if Gymnasium can be imported. An observation is what the
    coordinator hears before it plans: arrays of one whole number a region, by name. An action says how many cars to send:
    an array of shape (2, N, N), vacant cars first, then low-battery ones; rows are origins. Cars beyond those that a
    region reports are left out. A Plan of a Controller is an action too. The day's end is `terminated`, since the time of
    day is part of the observation; no episode is `truncated`.

    scenario: a file, or the name of one that is shipped. seed: of the first day, else the scenario's. day: date, else
    the scenario's. faults: a schedule's file or the name of a shipped one, in place of the scenario's. settings: keys of
    the scenario and values in their place, such as {"balancing.tau": 3}. reward: weights of the metrics of
    reward_metrics(), which are counted from step to step and added up.

    Raises Error with the text that `evbal run` would end with.
    """

    metadata: dict[str, Any] = {"render_modes": []}
    render_mode = None

    def __init__(
        self,
        scenario: str,
        seed: Optional[int] = None,
        *,
        day: Optional[str] = None,
        faults: Optional[str] = None,
        settings: Optional[Mapping[str, Any]] = None,
        reward: Optional[Mapping[str, float]] = None,
    ) -> None:
        words = [f"{key}={json.dumps(value)}" for key, value in (settings or {}).items()]
        weights = {"lost": -1.0} if reward is None else dict(reward)
        self._environment = _evbal.Environment(str(scenario), weights, day, faults, words)
        self._seed = self._environment.seed if seed is None else _checked_seed(seed)
        self._episode = 0
        regions = self._environment.regions
        numbers = np.iinfo(np.int32)
        spaces = {name: Box(numbers.min, numbers.max, (regions,), np.int32) for name in _evbal.observation_names()}
        spaces["minute"] = Box(0, self._environment.minutes, (1,), np.int32)
        self.observation_space = Dict(spaces)
        self.action_space = Box(0, self._environment.vehicles, (2, regions, regions), np.int32)

    @property
    def regions(self) -> int:
        """Regions of the city."""
        return self._environment.regions

    @property
    def km(self) -> np.ndarray:
        """Distances, N x N, rows are origins."""
        return self._environment.km

    @property
    def travel_minutes(self) -> np.ndarray:
        """Travel times, N x N, rows are origins."""
        return self._environment.travel_minutes

    @property
    def points(self) -> np.ndarray:
        """Charging points of each region."""
        return self._environment.points

    @property
    def days(self) -> list[str]:
        """Dates that the city has records of."""
        return self._environment.days

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[Mapping[str, Any]] = None
    ) -> tuple[Observation, Info]:
        """Begins a day: with a seed the day of that seed, without one first the day of the constructor's seed, then other
        ones that follow from it. options: {"day": date}."""
        unknown = set(options or {}) - {"day"}
        if unknown:
            raise _evbal.Error(f"reset: there is no option {sorted(unknown)[0]!r}; there is `day`")
        super().reset(seed=seed)
        if seed is not None:
            self._seed, self._episode = _checked_seed(seed), 0
        if self._episode == 0:
            episode_seed = self._seed
        else:
            episode_seed = int(np.random.SeedSequence((self._seed, self._episode)).generate_state(1)[0])
        self._environment.begin(episode_seed, (options or {}).get("day", ""))
        self._episode += 1
        return self._environment.observation(), self._environment.info()

    def step(self, action: Union[np.ndarray, _evbal.Plan]) -> tuple[Observation, float, bool, bool, Info]:
        """Makes the action the plan of this moment and goes on to the next one that is due, or to the day's end. Gives
        observation, reward, terminated, truncated, info."""
        self._environment.step(action)
        return (
            self._environment.observation(),
            self._environment.reward,
            self._environment.over,
            False,
            self._environment.info(),
        )
