#!/usr/bin/env python3
"""One mission flown in many ways: by sim and run, under load, at real pace, on two hosts."""

import json
import os
import shutil
import subprocess
import sys

from furrow import BIN, GARDEN, Furrow, eventually, furrow, main, without_timing


class Determinism(Furrow):
    def test_a_plan_is_the_same_each_time(self):
        for name in ("a", "b"):
            done = furrow("plan", self.garden, "--quiet", "--out", self.out(name))
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(without_timing(self.out("a")), without_timing(self.out("b")))

    def test_sim_and_run_agree_to_the_byte_under_any_load(self):
        done = furrow("sim", self.garden, "--quiet", "--out", self.out("sim"))
        self.assertEqual(done.returncode, 0, done.stderr)
        expected = without_timing(self.out("sim"))
        for i in range(5):
            hogs = []
            if i == 4:
                hogs = [subprocess.Popen([sys.executable, "-c", "while True: pass"])
                        for _ in range(2)]
            try:
                done = furrow("run", self.garden, "--quiet", "--out", self.out(f"run{i}"))
            finally:
                for hog in hogs:
                    hog.kill()
                    hog.wait()
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(expected, without_timing(self.out(f"run{i}")))
            self.assertEqual((self.out("sim") / "events.jsonl").read_bytes(),
                             (self.out(f"run{i}") / "events.jsonl").read_bytes())

    def test_several_agents_in_a_process_change_nothing(self):
        furrow("sim", self.garden, "--quiet", "--out", self.out("sim"))
        done = furrow("run", self.garden, "--quiet", "--agents-per-process", 2, "--out",
                      self.out("run"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(without_timing(self.out("sim")), without_timing(self.out("run")))

    def test_a_bad_radio_changes_nothing_between_sim_and_run(self):
        bad = self.scenario(GARDEN.read_text() +
                            "link: {latency_s: 0.05, jitter_s: 0.3, loss: 0.1, duplicate: 0.2}\n"
                            "limits: {agent_lease_s: 10}\n")
        for command in ("sim", "run"):
            done = furrow(command, bad, "--quiet", "--out", self.out(command))
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(without_timing(self.out("sim")), without_timing(self.out("run")))

    def test_sim_and_run_agree_where_the_mission_limit_ends_them(self):
        # Before the first heartbeat, with one at the very instant, and between two.
        for limit_s in (1, 100, 100.5):
            with self.subTest(limit_s):
                short = self.scenario(GARDEN.read_text() + f"limits: {{mission_s: {limit_s}}}\n")
                for command in ("sim", "run"):
                    done = furrow(command, short, "--quiet", "--out", self.out(command))
                    self.assertEqual(done.returncode, 1, done.stderr)
                    self.assertIn("longer than its limit", done.stderr)
                self.assertEqual(without_timing(self.out("sim")), without_timing(self.out("run")))
                result = json.loads((self.out("sim") / "result.json").read_text())
                self.assertFalse(result["partial"])
                # What the scheduler gave up at the limit is in the ledger's count.
                self.assertGreater(result["coverage"]["missed_m2"], 0)

    def test_another_seed_is_another_run(self):
        for seed in (1, 2):
            furrow("sim", self.garden, "--quiet", "--seed", seed, "--out", self.out(str(seed)))
        digests = [json.loads((self.out(str(seed)) / "result.json").read_text())["log"]["digest"]
                   for seed in (1, 2)]
        self.assertNotEqual(*digests)


class Paces(Furrow):
    def test_two_runs_at_once_do_not_mix(self):
        runs = [self.started("run", self.garden, "--quiet", "--out", self.out(str(i)))
                for i in range(2)]
        for process in runs:
            code, errors = self.ended(process)
            self.assertEqual(code, 0, errors)
        self.assertEqual(without_timing(self.out("0")), without_timing(self.out("1")))

    def test_the_wall_clock_flies_the_same_mission_in_real_time(self):
        short = self.scenario(GARDEN.read_text().replace("[60, 80], [0, 80]", "[60, 4], [0, 4]"))
        done = furrow("run", short, "--quiet", "--speed", "wall", "--out", self.out("wall"))
        self.assertEqual(done.returncode, 0, done.stderr)
        result = json.loads((self.out("wall") / "result.json").read_text())
        self.assertEqual(result["coverage"]["missed_m2"], 0)


class Hosts(Furrow):
    NAMES = [f"furrow-test-{os.getpid()}-{i}" for i in (1, 2)]
    ADDRESSES = ["10.213.77.1", "10.213.77.2"]

    def setUp(self):
        """Two hosts with nothing but a cable between them."""
        super().setUp()
        if not shutil.which("ip"):
            self.skipTest("needs iproute2")
        ip = lambda *words: subprocess.run(["ip", *words], capture_output=True, text=True)
        for name in self.NAMES:
            self.addCleanup(ip, "netns", "delete", name)
            made = ip("netns", "add", name)
            if made.returncode != 0:
                self.skipTest("needs leave to make network namespaces: " + made.stderr.strip())
        ends = [f"fr{os.getpid() % 100_000}{end}" for end in "ab"]
        made = ip("link", "add", ends[0], "netns", self.NAMES[0], "type", "veth",
                  "peer", "name", ends[1], "netns", self.NAMES[1])
        if made.returncode != 0:
            self.skipTest("needs virtual cables: " + made.stderr.strip())
        for name, address, end in zip(self.NAMES, self.ADDRESSES, ends):
            ip("-n", name, "link", "set", "lo", "up")
            ip("-n", name, "address", "add", f"{address}/24", "dev", end)
            ip("-n", name, "link", "set", end, "up")
        is_up = lambda: all(" UP " in ip("-n", name, "-br", "link", "show", "dev", end).stdout
                            for name, end in zip(self.NAMES, ends))
        self.assertTrue(eventually(is_up, 10))

    def test_agents_of_another_host_fly_with_the_rest(self):
        short = self.scenario(GARDEN.read_text().replace("[60, 80], [0, 80]", "[60, 4], [0, 4]"))
        director = subprocess.Popen(
            ["ip", "netns", "exec", self.NAMES[0], BIN / "furrow", "run", short, "--speed", "wall",
             "--interface", self.ADDRESSES[0], "--remote-agents", "2", "--start-in", "8",
             "--out", self.out("hosts")], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.addCleanup(director.stderr.close)
        self.addCleanup(director.kill)
        command = director.stderr.readline()
        self.assertTrue(command.startswith("Start on the other host: furrow-agents "), command)
        words = command.split()[5:]
        agents = subprocess.Popen(["ip", "netns", "exec", self.NAMES[1], BIN / words[0],
                                   *(self.ADDRESSES[1] if word == "ADDRESS" else word
                                     for word in words[1:])])
        self.addCleanup(agents.wait)
        self.addCleanup(agents.kill)
        code, errors = self.ended(director)
        self.assertEqual(code, 0, errors)
        self.assertEqual(agents.wait(20), 0)
        result = json.loads((self.out("hosts") / "result.json").read_text())
        self.assertEqual(result["coverage"]["missed_m2"], 0)
        self.assertTrue(all(uav["spray_s"] > 0 for uav in result["uavs"]))


if __name__ == "__main__":
    main()
