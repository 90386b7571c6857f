"""What tests of the built programs share.

Each file of tests runs as NAME_test.py BIN_FOLDER SOURCE_FOLDER [TEST ...].
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

BIN, ROOT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
GARDEN = ROOT / "tests/end_to_end/garden.yaml"
PATIENCE_S = 120


def furrow(*arguments):
    return subprocess.run([BIN / "furrow", *map(str, arguments)], capture_output=True, text=True,
                          timeout=PATIENCE_S)


def without_timing(folder):
    result = json.loads((pathlib.Path(folder) / "result.json").read_text())
    result.pop("mode")
    result.pop("timing")
    result["solver"].pop("wall_s")
    return json.dumps(result)


def eventually(question, seconds):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if question():
            return True
        time.sleep(0.02)
    return False


def processes_in(folder):
    """Pids whose command line names `folder`."""
    found = {}
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            line = (entry / "cmdline").read_bytes().decode().split("\0")
        except OSError:
            continue
        if any(str(folder) in word for word in line):
            found[int(entry.name)] = line
    return found


class Furrow(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        # A copy of its own: the path tells this test's processes from all others.
        self.garden = self.scenario(GARDEN.read_text())

    def scenario(self, text):
        path = self.folder / "garden.yaml"
        path.write_text(text)
        return path

    def slow_to_plan(self):
        """48 hectares and a search that only its budget ends: seconds of planning."""
        text = GARDEN.read_text().replace("[60, 0], [60, 80], [0, 80]",
                                          "[600, 0], [600, 800], [0, 800]")
        for key, small, large in (("spray", 150, 900), ("flight", 400, 1500)):
            text = text.replace(f"{key}_endurance_s: {small}", f"{key}_endurance_s: {large}")
        return self.scenario(
            text + "solver: {returns: gsa, iterations: 1000000, agents: 1000, budget_s: 2}\n")

    def out(self, name):
        return self.folder / name

    def started(self, *arguments, **settings):
        process = subprocess.Popen([BIN / "furrow", *map(str, arguments)], text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, **settings)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        return process

    def ended(self, process):
        _, errors = process.communicate(timeout=PATIENCE_S)
        return process.returncode, errors


def main():
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
