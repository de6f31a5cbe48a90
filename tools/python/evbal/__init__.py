"""Days of an electric taxi fleet, stepped from plan to plan, with faults injected on purpose (docs/python.md).

    import evbal

    day = evbal.Day("toy.yaml", seed=3, reward={"lost": -1.0, "idle_km": -0.05})
    flow = evbal.Controller("flow", day)
    observation, info = day.reset()
    done = False
    while not done:
        observation, reward, done, _, info = day.step(flow(observation))
    print(info["totals"]["lost"])
"""

from evbal._evbal import Error, Plan, controller_names, pinned_environment, reward_metrics
from evbal.controller import Controller
from evbal.day import Day
from evbal.records import Run, read_run, read_sweep

__all__ = [
    "Controller",
    "Day",
    "Error",
    "Plan",
    "Run",
    "controller_names",
    "pinned_environment",
    "read_run",
    "read_sweep",
    "reward_metrics",
]
