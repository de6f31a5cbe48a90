"""docs/python.md as a user would try it."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest


class Page(unittest.TestCase):
    def test_runs_as_it_stands_and_its_policy_learns_to_beat_greedy(self):
        page = pathlib.Path(os.environ["EVBAL_SOURCE"], "docs/python.md").read_text()
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder, "page.py")
            program.write_text("\n".join(re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)))
            ran = subprocess.run([sys.executable, program], capture_output=True, text=True, timeout=500)
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        self.assertRegex(ran.stdout, r"lost passengers, digest [0-9a-f]{32}\n\[[\d., ]+\]\n")
        learnt, greedy = map(int, re.search(r"learnt (-\d+), greedy (-\d+)", ran.stdout).groups())
        self.assertGreater(learnt, greedy + 10)


if __name__ == "__main__":
    unittest.main()
