#!/usr/bin/env python3
"""Runs the built programs as a user does. Usage: furrow_test.py BIN_FOLDER SOURCE_FOLDER [TEST ...]"""

import json
import os
import pathlib
import shutil
import signal
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


class Deaths(Furrow):
    def test_an_agent_that_dies_by_the_scenario_is_reported_by_sim_and_run_alike(self):
        deadly = self.scenario(GARDEN.read_text() +
                               "faults: [{at_s: 100, kind: agent_kill, target: 2}]\n")
        for command in ("sim", "run"):
            done = furrow(command, deadly, "--quiet", "--out", self.out(command))
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("expectation missed: missed_m2", done.stderr)
            self.assertNotIn("not completed", done.stderr)
            self.assertRegex(done.stderr, r"uncertain since 10\d\.\d s: cells \d+ to \d+")
            self.assertRegex(done.stderr, r"lost at 10\d\.\d s: agent 2: nothing was heard of it")
        self.assertEqual(without_timing(self.out("sim")), without_timing(self.out("run")))
        result = json.loads((self.out("run") / "result.json").read_text())
        self.assertLessEqual(result["faults"][0]["noticed_s"], 100 + 3 + 2)  # lease and heartbeat

    def flown_alike(self, scenario, said="", code=0):
        """Flies a scenario by sim and by run to the same result and events; gives both."""
        for command in ("sim", "run"):
            done = furrow(command, ROOT / "scenarios" / scenario, "--out", self.out(command))
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertIn(said, done.stderr)
        self.assertEqual(without_timing(self.out("sim")), without_timing(self.out("run")))
        events = (self.out("run") / "events.jsonl").read_bytes()
        self.assertEqual((self.out("sim") / "events.jsonl").read_bytes(), events)
        return json.loads((self.out("run") / "result.json").read_text()), events

    def test_work_of_a_lost_agent_is_taken_over_by_sim_and_run_alike(self):
        _, events = self.flown_alike("lost_agent.yaml")
        self.assertIn(b"work_taken_over", events)

    def test_who_joins_late_is_given_a_share_by_sim_and_run_alike(self):
        result, _ = self.flown_alike("late_joiner.yaml")
        self.assertGreater(len(result["uavs"][3]["sorties"]), 0)
        self.assertLessEqual(result["faults"][0]["noticed_s"], 601)

    def test_a_tree_that_no_map_shows_is_flown_around_by_sim_and_run_alike(self):
        _, events = self.flown_alike("surprise_tree.yaml")
        self.assertIn(b"obstacle_planned", events)

    def test_what_lies_behind_a_tree_without_a_way_past_is_sprayed_by_sim_and_run_alike(self):
        result, events = self.flown_alike("alley_blocked.yaml", "the mission is not completed", 1)
        self.assertEqual(events.count(b"way_blocked"), 3)  # on each of three rows
        self.assertLess(result["coverage"]["missed_m2"], 300)

    def test_what_an_empty_station_leaves_is_done_from_another_by_sim_and_run_alike(self):
        result, _ = self.flown_alike("empty_stock.yaml", "station 1 has no mix for it")
        self.assertGreater(result["stations"][0]["filled_l"], 24.5)
        self.assertLessEqual(result["stations"][0]["filled_l"], 25)

    def test_aircraft_of_a_station_that_fails_go_to_another_by_sim_and_run_alike(self):
        result, events = self.flown_alike("station_down.yaml",
                                     "at 600.0 s: station 1 shuts bay 1, 0 of 1 are left")
        self.assertEqual(result["faults"][0]["noticed_s"], 600)
        self.assertIn(b"station 1 has 0 bays left to plan with", events)
        self.assertNotIn(True, [uav["lost"] for uav in result["uavs"]])

    def test_sorties_from_one_station_to_another_are_flown_by_sim_and_run_alike(self):
        result, _ = self.flown_alike("two_stations.yaml", "sorties chosen jointly")
        for uav in result["uavs"]:
            self.assertEqual({s["station"] for s in uav["sorties"] if s["station"]}, {1, 2})

    def test_a_queue_at_one_bay_is_planned_by_sim_and_run_alike(self):
        result, _ = self.flown_alike("bottleneck_bay.yaml", "sorties chosen jointly")
        others = result["solver"]["fleet"]
        for other in ("shares_s", "till_empty_s", "simple_s"):
            self.assertLess(result["fleet"]["planned_makespan_s"], others[other])
        self.assertLess(abs(result["fleet"]["makespan_s"] / result["fleet"]["planned_makespan_s"] - 1),
                        0.02)

    def test_a_mixed_fleet_shares_by_what_each_can_do_by_sim_and_run_alike(self):
        result, _ = self.flown_alike("mixed_fleet.yaml")
        small, _, fast, big = (uav["area_m2"] for uav in result["uavs"])
        self.assertLess(1.2 * small, fast)
        self.assertLess(1.2 * small, big)

    def test_a_mission_whose_only_station_fails_ends_and_says_so(self):
        shut = self.scenario(GARDEN.read_text() +
                             "faults: [{at_s: 60, kind: bay_down, target: 1}]\n")
        done = furrow("sim", shut, "--quiet", "--out", self.out("sim"))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("the mission is not completed", done.stderr)
        self.assertIn("station 1 shuts bay 1, 0 of 1 are left", done.stderr)
        self.assertNotIn("law ", done.stderr)

    def test_a_mission_that_lacks_mix_ends_and_says_so(self):
        short = self.scenario(GARDEN.read_text().replace("bays: 1", "bays: 1, mix_l: 5"))
        done = furrow("sim", short, "--quiet", "--out", self.out("sim"))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("the mission is not completed", done.stderr)
        self.assertIn("station 1 has no mix for it", done.stderr)
        self.assertNotIn("law ", done.stderr)

    def test_a_killed_agent_process_leaves_dry_what_it_held_and_results(self):
        process = self.started("run", self.garden, "--speed", 60, "--out", self.out("run"))
        agents = lambda: [pid for pid, line in processes_in(self.garden).items()
                          if "furrow-agents" in line[0]]
        self.assertTrue(eventually(lambda: len(agents()) == 2, 20))
        time.sleep(3)
        os.kill(agents()[0], signal.SIGKILL)
        code, errors = self.ended(process)
        self.assertEqual(code, 1, errors)
        self.assertIn("ended with code 137", errors)
        self.assertRegex(errors, r"lost at \d+\.\d s: agent \d: ")
        self.assertTrue((self.out("run") / "report.html").exists())
        self.assertEqual(processes_in(self.garden), {})

    def test_a_killed_scheduler_ends_the_run_as_partial(self):
        process = self.started("run", self.garden, "--speed", 60, "--out", self.out("run"))
        scheduler = lambda: [pid for pid, line in processes_in(self.garden).items()
                             if "furrow-scheduler" in line[0]]
        self.assertTrue(eventually(scheduler, 20))
        time.sleep(3)
        os.kill(scheduler()[0], signal.SIGKILL)
        code, errors = self.ended(process)
        self.assertEqual(code, 1, errors)
        self.assertTrue(json.loads((self.out("run") / "result.json").read_text())["partial"])
        self.assertEqual(processes_in(self.garden), {})

    def test_an_interrupt_keeps_results_and_leaves_nothing_behind(self):
        before = set(os.listdir("/dev/shm"))
        process = self.started("run", self.garden, "--speed", 30, "--out", self.out("run"))
        self.assertTrue(eventually(lambda: len(processes_in(self.garden)) == 5, 20))
        time.sleep(3)
        process.send_signal(signal.SIGINT)
        code, errors = self.ended(process)
        self.assertEqual(code, 1, errors)
        result = json.loads((self.out("run") / "result.json").read_text())
        self.assertTrue(result["partial"])
        self.assertEqual(processes_in(self.garden), {})
        self.assertEqual(set(os.listdir("/dev/shm")) - before, set())

    def test_an_interrupt_before_the_start_ends_quietly_with_the_plan(self):
        process = self.started("run", self.garden, "--speed", 0.01, "--out", self.out("run"),
                               start_new_session=True)
        self.assertTrue(eventually(lambda: len(processes_in(self.garden)) > 1, 20))
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to the children, too
        code, errors = self.ended(process)
        self.assertEqual(code, 1, errors)
        for line in errors.splitlines():
            self.assertNotRegex(line, "director|ended with code")
        result = json.loads((self.out("run") / "result.json").read_text())
        self.assertTrue(result["partial"])
        self.assertEqual(result["coverage"]["covered_m2"], 0)
        self.assertGreater(result["fleet"]["planned_makespan_s"], 0)
        self.assertEqual(processes_in(self.garden), {})

    def test_an_interrupt_while_the_plan_is_made_keeps_the_plan_and_a_second_ends_at_once(self):
        for command in ("sim", "run"):
            for interrupts, expected in ((1, 1), (2, 130)):
                with self.subTest(command=command, interrupts=interrupts):
                    out = self.out(f"{command}{interrupts}")
                    process = self.started(command, self.slow_to_plan(), "--out", out)
                    time.sleep(0.5)
                    for _ in range(interrupts):
                        process.send_signal(signal.SIGINT)
                        time.sleep(0.2)
                    code, errors = self.ended(process)
                    self.assertEqual(code, expected, errors)
                    self.assertIn("once more", errors)
                    if expected == 130:
                        self.assertFalse(out.exists())
                    else:
                        result = json.loads((out / "result.json").read_text())
                        self.assertTrue(result["partial"])
                        self.assertEqual(result["log"]["messages"], 0)

    def test_when_the_director_is_killed_every_process_ends(self):
        process = self.started("run", self.garden, "--speed", 30, "--out", self.out("run"))
        self.assertTrue(eventually(lambda: len(processes_in(self.garden)) == 5, 20))
        time.sleep(1)
        process.kill()
        process.wait()
        self.assertTrue(eventually(lambda: not processes_in(self.garden), 10),
                        processes_in(self.garden))


class Operator(Furrow):
    def ordered(self, *orders):
        """Flies the garden under orders at set times, by sim and by run to the same bytes."""
        text = GARDEN.read_text().replace("completed: true, missed_m2: {max: 0}", "")
        path = self.scenario(text + f"faults: [{', '.join(orders)}]\n")
        for command in ("sim", "run"):
            done = furrow(command, path, "--quiet", "--out", self.out(command))
            self.assertNotIn("law ", done.stderr)
        self.assertEqual(without_timing(self.out("sim")), without_timing(self.out("run")))
        self.assertEqual((self.out("sim") / "events.jsonl").read_bytes(),
                         (self.out("run") / "events.jsonl").read_bytes())
        return done, json.loads((self.out("run") / "result.json").read_text())

    def test_a_pause_a_return_and_one_taken_out_leave_nothing_dry(self):
        done, result = self.ordered("{at_s: 60, kind: pause}", "{at_s: 90, kind: resume}",
                                    "{at_s: 150, kind: return_all}", "{at_s: 250, kind: resume}",
                                    "{at_s: 300, kind: take_out, target: 2}")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(result["coverage"]["missed_m2"], 0)
        self.assertEqual(result["coverage"]["repeated_m2"], 0)
        self.assertEqual(result["operator"], {"level": "fly", "taken_out": [2]})
        self.assertEqual([f["noticed_s"] for f in result["faults"]], [60, 90, 150, 250, 300])

    def test_a_stop_ends_the_mission_and_says_so(self):
        done, result = self.ordered("{at_s: 100, kind: stop}")
        self.assertEqual(done.returncode, 1)
        self.assertIn("the operator stopped the mission at 100.0 s", done.stderr)
        self.assertFalse(result["completed"] or result["partial"])
        self.assertEqual(result["operator"]["level"], "end")
        self.assertGreater(result["coverage"]["missed_m2"], 0)
        # Home within a minute from anywhere in the garden, 100 m at 6 m/s.
        self.assertLess(max(uav["landed_s"] for uav in result["uavs"]), 160)


    def test_orders_to_a_running_mission_are_obeyed_and_answered(self):
        # 530 s of mission in a quarter of a minute; the folder is not there yet.
        process = self.started("run", self.garden, "--speed", 30, "--out", self.out("run"))
        operate = lambda *order: furrow("operate", self.out("run"), *order)
        self.assertTrue(eventually(lambda: operate("pause").returncode == 0, 20))
        for order, text in ((("resume",), "obeyed at "), (("return-all",), "obeyed at "),
                            (("resume",), "obeyed at "), (("take-out", 2), "obeyed at ")):
            done = operate(*order)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(done.stdout.startswith(text), done.stdout)
        for order, said in ((("land",), "order: must be pause, .*got land"),
                            (("take-out",), r"uav: must be .*1 to 2 \(got none\)"),
                            (("take-out", 3), r"uav: must be .*1 to 2 \(got 3\)"),
                            (("pause", 1), r"uav: must be left out .*\(got 1\)")):
            done = operate(*order)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertRegex(done.stderr, said)
        code, errors = self.ended(process)
        self.assertEqual(code, 0, errors)
        self.assertNotIn("law ", errors)
        result = json.loads((self.out("run") / "result.json").read_text())
        self.assertEqual(result["operator"], {"level": "fly", "taken_out": [2]})
        self.assertEqual(result["coverage"]["missed_m2"], 0)

    def test_a_run_that_is_stopped_says_so_and_takes_no_order_back(self):
        process = self.started("run", self.garden, "--speed", 3, "--out", self.out("run"))
        operate = lambda *order: furrow("operate", self.out("run"), *order)
        self.assertTrue(eventually(lambda: operate("resume").returncode == 0, 20))
        time.sleep(5)  # 15 s of mission: all are at work, seconds away from home
        done = operate("stop")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = operate("resume")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("final", done.stderr)
        code, errors = self.ended(process)
        self.assertEqual(code, 1, errors)
        self.assertIn("the operator stopped the mission at ", errors)
        done = operate("pause")
        self.assertEqual(done.returncode, 2)
        self.assertIn("no run is going on", done.stderr)


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


class Scenarios(Furrow):
    ELSEWHERE = {"alley_blocked", "block_1000ha", "bottleneck_bay", "empty_stock", "fleet_20",
                 "fleet_200", "late_joiner", "lost_agent", "mixed_fleet", "station_down",
                 "surprise_tree", "template", "two_stations", "wang2017_field_a",
                 "wang2017_field_a_single"}  # flown by other tests, or large

    def test_scenarios_of_the_repository_meet_what_they_expect(self):
        for path in sorted((ROOT / "scenarios").glob("*.yaml")):
            if path.stem in self.ELSEWHERE:
                continue
            with self.subTest(path.stem):
                done = furrow("sim", path, "--quiet", "--out", self.out(path.stem))
                self.assertEqual(done.returncode, 0, done.stderr)


class Input(Furrow):
    def test_every_scenario_of_the_repository_is_sound(self):
        for path in sorted((ROOT / "scenarios").glob("*.yaml")):
            done = furrow("check", path)
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_broken_scenario_ends_with_2_and_writes_nothing(self):
        broken = self.scenario(GARDEN.read_text().replace("swath_m: 2", "swath_m: -2"))
        for command in ("check", "plan", "sim", "run"):
            with self.subTest(command):
                done = furrow(command, broken, *(() if command == "check" else
                                                 ("--out", self.out("none"))))
                self.assertEqual(done.returncode, 2)
                self.assertRegex(done.stderr, r"garden.yaml:\d+: uavs\[0\].swath_m: .*-2")
                self.assertFalse(self.out("none").exists())

    def test_a_field_that_no_aircraft_reaches_is_explained(self):
        far = self.scenario(GARDEN.read_text().replace("[30, -5]", "[30, -5000]"))
        done = furrow("plan", far, "--out", self.out("none"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("reach", done.stderr)
        self.assertFalse(self.out("none").exists())

    def test_a_missing_file_or_a_wrong_option_ends_with_2(self):
        for arguments in (("plan", "none.yaml"), ("plan",), ("fly", self.garden), (),
                          ("run", self.garden, "--speed", "fast"),
                          ("run", self.garden, "--agents-per-process", 51),
                          ("run", self.garden, "--interface", "203.0.113.1"),
                          ("run", self.garden, "--speed", "-1"),
                          ("run", self.garden, "--speed", "nan"),
                          ("run", self.garden, "--speed", "1e-9"),
                          ("run", self.garden, "--speed", "0x10"),
                          ("run", self.garden, "--speed", " 5"),
                          ("run", self.garden, "--speed", ""),
                          ("run", self.garden, "--agents-per-process", 0),
                          ("run", self.garden, "--agents-per-process", "+2"),
                          ("run", self.garden, "--remote-agents", "2"),
                          ("run", self.garden, "--speed", "wall", "--remote-agents", "2-1"),
                          ("run", self.garden, "--speed", "wall", "--remote-agents", "2-3"),
                          ("run", self.garden, "--speed", "wall", "--remote-agents", "-2"),
                          ("run", self.garden, "--speed", "wall", "--start-in", 0),
                          ("run", self.garden, "--interface", ""),
                          ("run", self.garden, "--interface", "localhost"),
                          ("sim", self.garden, "--out", ""),
                          ("sim", self.garden, "--seed", "x"),
                          ("sim", self.garden, "--seed", "-1"),
                          ("sim", self.garden, "--seed", "+1"),
                          ("sim", self.garden, "--seed", ""),
                          ("sim", self.garden, "--seed", "1.5"),
                          ("sim", self.garden, "--seed", 2**64)):
            with self.subTest(arguments):
                done = furrow(*arguments)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertNotEqual(done.stderr.strip(), "")

    def test_check_counts_what_it_found_in_words(self):
        done = furrow("check", self.garden)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.endswith("sound: 2 UAVs, 1 station\n"), done.stdout)

    def test_json_is_all_that_is_printed_to_stdout(self):
        done = furrow("sim", self.garden, "--json", "--out", self.out("sim"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, (self.out("sim") / "result.json").read_text())

    def test_an_expectation_that_is_missed_is_named(self):
        vain = self.scenario(GARDEN.read_text().replace("missed_m2: {max: 0}",
                                                        "makespan_s: {max: 10}"))
        done = furrow("sim", vain, "--quiet", "--out", self.out("sim"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("makespan_s", done.stderr)

    def test_results_that_cannot_be_written_are_explained(self):
        (self.folder / "file").write_text("")
        done = furrow("plan", self.garden, "--out", self.folder / "file" / "out")
        self.assertEqual(done.returncode, 2)
        self.assertIn(str(self.folder / "file"), done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
