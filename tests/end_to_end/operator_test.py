#!/usr/bin/env python3
"""Orders of the operator, at set times and to a running mission."""

import json
import time

from furrow import GARDEN, Furrow, eventually, furrow, main, without_timing


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


if __name__ == "__main__":
    main()
