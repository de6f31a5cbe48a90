"""evbal's own controllers beside a day."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from evbal import _evbal


class Controller:
    """One of evbal's controllers, with the scenario's parameters. Called with a day's newest observation it gives the plan
    that it would make now: an action that `Day.step` takes, and whose `action()` is an array. It need not be asked
    always: it hears what was reported and planned meanwhile.

    name: one of controller_names(). day: a Day, or a wrapper of one, that need not have been reset yet.
    """

    def __init__(self, name: str, day: Any) -> None:
        _evbal.check_controller(name)
        self.name = name
        self._environment = day.unwrapped._environment
        self._controller: Optional[_evbal.Controller] = None

    def __call__(self, observation: dict[str, np.ndarray]) -> _evbal.Plan:
        """The plan of the moment of this observation, which must be the day's newest."""
        newest = self._environment.minute
        if int(observation["minute"][0]) != newest:
            raise _evbal.Error(
                f"controller: the observation is of minute {int(observation['minute'][0])}, the day is at minute {newest}; "
                "give the newest one"
            )
        if self._controller is None or not self._controller.hears(self._environment):
            self._controller = _evbal.Controller(self._environment, self.name)
        return self._controller.plan()
