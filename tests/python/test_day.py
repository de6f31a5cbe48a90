"""Days stepped from Python. Run by `python3 -m unittest` with the package in PYTHONPATH and EVBAL, the path of the
program evbal."""

import json
import multiprocessing
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import textwrap
import unittest

import numpy as np

import evbal

PROGRAM = os.environ["EVBAL"]


ROBUST_DAY = """
import json, evbal
day = evbal.Day("toy.yaml", seed=3)
robust = evbal.Controller("robust", day)
observation, info = day.reset()
done = False
while not done:
    observation, _, done, _, info = day.step(robust(observation))
print(json.dumps({"digest": info["digest"], "totals": {"lost": int(info["totals"]["lost"])}}))
"""


def run_evbal(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=120)


def play(day, plan):
    """The reward of a whole day, and the last step's info."""
    observation, _ = day.reset()
    total, done = 0.0, False
    while not done:
        observation, reward, done, _, info = day.step(plan(observation))
        total += reward
    return total, info


def play_by_greedy(seed):
    """A day for a process of its own."""
    day = evbal.Day("toy.yaml", seed=seed)
    total, info = play(day, evbal.Controller("greedy", day))
    return total, info["digest"]


class Days(unittest.TestCase):
    def test_keep_to_the_conventions_of_an_environment(self):
        day = evbal.Day("toy.yaml")
        observation, info = day.reset(seed=5)
        self.assertEqual(info["seed"], 5)
        self.assertTrue(day.observation_space.contains(observation))
        self.assertIs(day.unwrapped, day)
        steps, terminated = 0, False
        while not terminated:
            observation, reward, terminated, truncated, info = day.step(np.zeros((2, 5, 5), np.int32))
            self.assertTrue(day.observation_space.contains(observation))
            self.assertIsInstance(reward, float)
            self.assertIs(truncated, False)
            steps += 1
        self.assertEqual(steps, 19 * 6)
        self.assertEqual(observation["minute"][0], 19 * 60)
        with self.assertRaisesRegex(evbal.Error, r"the day is over; begin another one by reset\(\)"):
            day.step(np.zeros((2, 5, 5), np.int32))
        day.close()

    def test_are_the_same_for_the_same_seed_and_others_for_others(self):
        day = evbal.Day("toy.yaml", seed=3)
        seeds = [day.reset()[1]["seed"] for _ in range(3)]
        self.assertEqual(seeds[0], 3)
        self.assertEqual(len(set(seeds)), 3)
        again = evbal.Day("toy.yaml", seed=3)
        self.assertEqual([again.reset()[1]["seed"] for _ in range(3)], seeds)
        self.assertEqual(day.reset(options={"day": "2024-01-12"})[1]["day"], "2024-01-12")

    def test_planned_by_robust_have_the_digest_of_the_program(self):
        # In a Python of its own, since only there the environment is the program's, whoever runs this test.
        stepped = subprocess.run([sys.executable, "-m", "evbal", "-c", ROBUST_DAY], capture_output=True, text=True, timeout=120)
        self.assertEqual(stepped.returncode, 0, stepped.stderr)
        info = json.loads(stepped.stdout)
        with tempfile.TemporaryDirectory() as folder:
            ran = run_evbal("run", "toy.yaml", "--controller", "robust", "--seed", "3", "--transport", "inproc", "--quiet",
                            "--out", f"{folder}/run")  # fmt: skip
            self.assertEqual(ran.returncode, 0, ran.stderr)
            summary = json.loads(pathlib.Path(folder, "run/summary.json").read_text())
        self.assertEqual(info["digest"], summary["digest"])
        self.assertEqual(info["totals"]["lost"], summary["totals"]["lost"])

    def test_take_a_plan_and_its_array_alike(self):
        day = evbal.Day("toy.yaml", seed=2)
        greedy = evbal.Controller("greedy", day)
        _, by_plans = play(day, greedy)
        day.reset(seed=2)
        same = evbal.Day("toy.yaml", seed=2)
        greedy = evbal.Controller("greedy", same)
        _, by_arrays = play(same, lambda observation: greedy(observation).action())
        self.assertEqual(by_plans["totals"], by_arrays["totals"])

    def test_reward_what_they_are_asked_to(self):
        weights = {"lost": -1.0, "served": 0.25, "idle_km": -0.125}
        day = evbal.Day("toy.yaml", reward=weights)
        total, info = play(day, evbal.Controller("greedy", day))
        self.assertAlmostEqual(total, sum(weights[name] * info["totals"][name] for name in weights), places=6)

    def test_survive_any_action_under_any_fault(self):
        for faults in ["lying-sensors.yaml", "crashing-agents.yaml", "coordinator-lost.yaml"]:
            day = evbal.Day("toy.yaml", faults=faults)
            day.action_space.seed(1)
            _, info = play(day, lambda _: day.action_space.sample())
            self.assertGreater(info["totals"]["rebalance_moves"], 0)

    def test_tell_what_faults_were_seen_to_do(self):
        day = evbal.Day("toy.yaml")
        day.reset()
        seen, terminated = set(), False
        while not terminated:
            _, _, terminated, _, info = day.step(np.zeros((2, 5, 5), np.int32))
            seen |= {name for name, _, _ in info["faults"]}
        self.assertEqual(seen, {"morning-outage", "evening-spike"})

    def test_give_arrays_that_share_a_block(self):
        observation, info = evbal.Day("toy.yaml").reset()
        self.assertIs(observation["vacant"].base, observation["demand"].base)
        self.assertIs(info["regions"]["lost"].base, info["regions"]["served"].base)
        self.assertEqual(observation["heard"].tolist(), [1] * 5)

    def test_go_on_in_processes(self):
        expected = [play_by_greedy(seed) for seed in (1, 2)]
        for method in ("fork", "spawn"):
            with multiprocessing.get_context(method).Pool(2) as pool:
                self.assertEqual(pool.map_async(play_by_greedy, (1, 2)).get(timeout=120), expected)

    def test_end_by_ctrl_c(self):
        program = textwrap.dedent("""
            import evbal
            day = evbal.Day("toy.yaml")
            flow = evbal.Controller("flow", day)
            while True:
                observation, _ = day.reset()
                print("begun", flush=True)
                done = False
                while not done:
                    observation, _, done, _, _ = day.step(flow(observation))
            """)
        with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as child:
            self.assertEqual(child.stdout.readline(), b"begun\n")
            child.send_signal(signal.SIGINT)
            _, complaint = child.communicate(timeout=60)
        self.assertIn(b"KeyboardInterrupt", complaint)


class Errors(unittest.TestCase):
    def test_have_the_text_of_the_program(self):
        for words, settings in [
            (["--set", "balancing.tua=3"], {"balancing.tua": 3}),
            (["--set", "clock.tick=7min"], {"clock.tick": "7min"}),
        ]:
            ran = run_evbal("show", "toy.yaml", *words)
            with self.assertRaises(evbal.Error) as caught:
                evbal.Day("toy.yaml", settings=settings)
            self.assertEqual(ran.stderr, f"evbal: {caught.exception}\n")

    def test_name_what_is_unknown(self):
        day = evbal.Day("toy.yaml")
        for wrong, complaint in [
            (lambda: evbal.Day("ty.yaml"), "did you mean `toy.yaml`"),
            (lambda: evbal.Day("toy.yaml", reward={"lst": -1.0}), "reward: .*`lost`"),
            (lambda: evbal.Day("toy.yaml", reward={"lost": float("nan")}), "reward: lost: a finite number"),
            (lambda: evbal.Controller("gredy", day), "controller: .*`greedy`"),
            (lambda: day.reset(options={"date": "2024-01-12"}), "there is no option 'date'"),
            (lambda: day.reset(options={"day": "2024-01-31"}), "day: .*`2024-01-11`"),
            (lambda: day.reset(seed=-1), "seed: "),
        ]:
            with self.assertRaisesRegex(evbal.Error, complaint):
                wrong()

    def test_say_what_an_action_should_be(self):
        day = evbal.Day("toy.yaml")
        idle = np.zeros((2, 5, 5), np.int32)
        with self.assertRaisesRegex(evbal.Error, r"no day was begun; call reset\(\) first"):
            day.step(idle)
        day.reset()
        less = idle.copy()
        less[1, 3, 0] = -2
        for action, complaint in [
            (np.zeros((2, 5), int), r"shape \(2, 5, 5\) is expected"),
            (idle.astype(float), "whole numbers are expected"),
            (less, r"action\[1, 3, 0\]: -2 cars; 0 or more are expected"),
        ]:
            with self.assertRaisesRegex(evbal.Error, complaint):
                day.step(action)
        day.step(idle)

    def test_refuse_to_plan_when_the_day_is_over(self):
        day = evbal.Day("toy.yaml")
        none = evbal.Controller("none", day)
        observation, _ = day.reset()
        terminated = False
        while not terminated:
            observation, _, terminated, _, _ = day.step(none(observation))
        with self.assertRaisesRegex(evbal.Error, "controller: the day is over"):
            none(observation)

    def test_refuse_a_plan_of_another_moment(self):
        day = evbal.Day("toy.yaml")
        greedy = evbal.Controller("greedy", day)
        first, _ = day.reset()
        old = greedy(first)
        day.step(old)
        with self.assertRaisesRegex(evbal.Error, "the observation is of minute 0, the day is at minute 10"):
            greedy(first)
        with self.assertRaisesRegex(evbal.Error, "the plan is of another moment"):
            day.step(old)


class WithGymnasium(unittest.TestCase):
    """With a package of that name that has no more than what is used of it."""

    def test_a_day_is_an_env_of_gymnasium(self):
        with tempfile.TemporaryDirectory() as folder:
            spaces = pathlib.Path(folder, "gymnasium", "spaces.py")
            spaces.parent.mkdir()
            spaces.write_text(textwrap.dedent("""
                class Box:
                    def __init__(self, low, high, shape=None, dtype=float, seed=None):
                        self.shape = shape
                class Dict:
                    def __init__(self, spaces=None, seed=None, **others):
                        self.spaces = spaces
                """))
            spaces.with_name("__init__.py").write_text(textwrap.dedent("""
                class Env:
                    def reset(self, *, seed=None, options=None):
                        self.told = seed
                    @property
                    def unwrapped(self):
                        return self
                """))
            program = textwrap.dedent("""
                import gymnasium, evbal
                day = evbal.Day("toy.yaml")
                assert isinstance(day, gymnasium.Env)
                assert isinstance(day.action_space, gymnasium.spaces.Box)
                observation, _ = day.reset(seed=4)
                assert day.told == 4
                day.step(evbal.Controller("none", day)(observation))
                """)
            path = f"{folder}:{os.environ['PYTHONPATH']}"
            subprocess.run([sys.executable, "-c", "import gymnasium.spaces\n" + program], check=True, timeout=60,
                           env={**os.environ, "PYTHONPATH": path})  # fmt: skip


if __name__ == "__main__":
    unittest.main()
