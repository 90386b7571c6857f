#!/usr/bin/env python3
"""Processes that are killed or interrupted, and what is left of their missions."""

import json
import os
import signal
import time

from furrow import Furrow, eventually, main, processes_in


class Deaths(Furrow):
    def test_a_killed_agent_process_leaves_dry_what_it_held_and_results(self):
        process = self.started("run", self.garden, "--speed", 60, "--out", self.out("run"))
        agents = lambda: [pid for pid, line in processes_in(self.garden).items()
                          if "furrow-agents" in line[0]]
        self.assertTrue(eventually(lambda: len(agents()) == 2, 60))
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
        self.assertTrue(eventually(scheduler, 60))
        time.sleep(3)
        os.kill(scheduler()[0], signal.SIGKILL)
        code, errors = self.ended(process)
        self.assertEqual(code, 1, errors)
        self.assertTrue(json.loads((self.out("run") / "result.json").read_text())["partial"])
        self.assertEqual(processes_in(self.garden), {})

    def test_an_interrupt_keeps_results_and_leaves_nothing_behind(self):
        before = set(os.listdir("/dev/shm"))
        process = self.started("run", self.garden, "--speed", 30, "--out", self.out("run"))
        self.assertTrue(eventually(lambda: len(processes_in(self.garden)) == 5, 60))
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
        self.assertTrue(eventually(lambda: len(processes_in(self.garden)) > 1, 60))
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
        self.assertTrue(eventually(lambda: len(processes_in(self.garden)) == 5, 60))
        time.sleep(1)
        process.kill()
        process.wait()
        self.assertTrue(eventually(lambda: not processes_in(self.garden), 10),
                        processes_in(self.garden))


if __name__ == "__main__":
    main()
