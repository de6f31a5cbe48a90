"""Runs and sweeps read into arrays."""

import csv
import os
import pathlib
import subprocess
import tempfile
import unittest

import evbal

SWEEP = """
schema: 1
scenario: toy.yaml
days: [2024-01-11]
seeds: [1, 2]
variants:
  - controller: greedy
    settings: {balancing.m1: [10, 5]}
"""


def evbal_program(*words):
    subprocess.run([os.environ["EVBAL"], *words], check=True, capture_output=True, timeout=120)


class Records(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_of_a_run_are_its_tables(self):
        evbal_program("run", "toy.yaml", "--controller", "greedy", "--transport", "inproc", "--quiet", "--out", str(self.folder / "run"))
        run = evbal.read_run(self.folder / "run")
        self.assertEqual((run.controller, run.day), ("greedy", "2024-01-11"))
        with open(self.folder / "run/steps.csv") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([int(row["lost"]) for row in rows], run.steps["lost"].tolist())
        with open(self.folder / "run/regions.csv") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([int(row["served"]) for row in rows], run.regions["served"].ravel().tolist())
        self.assertEqual(run.totals["lost"], run.steps["lost"].sum())

    def test_of_a_sweep_are_columns(self):
        (self.folder / "toy.yaml").write_text(pathlib.Path(os.environ["EVBAL_SOURCE"], "experiments/scenarios/toy.yaml").read_text())
        (self.folder / "sweep.yaml").write_text(SWEEP)
        evbal_program("sweep", str(self.folder / "sweep.yaml"), "--out", str(self.folder / "days"))
        days = evbal.read_sweep(self.folder / "days")
        self.assertEqual(days["seed"].tolist(), [1, 2, 1, 2])
        self.assertEqual(sorted(set(days["balancing.m1"])), ["10", "5"])
        with open(self.folder / "days/days.csv") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([int(row["lost"]) for row in rows], days["lost"].tolist())
        try:
            import pandas
        except ImportError:
            return
        self.assertEqual(len(pandas.DataFrame(days)), 4)

    def test_that_are_not_there_are_missed(self):
        for read in (evbal.read_run, evbal.read_sweep):
            with self.assertRaisesRegex(evbal.Error, str(self.folder)):
                read(self.folder / "nothing")


if __name__ == "__main__":
    unittest.main()
