"""Starts Python under the environment in which results are the same bytes on every machine; its arguments are Python's:

    python3 -m evbal mine.py
    python3 -m evbal -m unittest
"""

import os
import sys

from evbal import pinned_environment

os.execve(sys.executable, [sys.executable, *sys.argv[1:]], {**os.environ, **pinned_environment})
