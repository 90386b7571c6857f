#!/usr/bin/env python3
"""What a scenario lets go wrong, flown by sim and by run to the same bytes."""

import json

from furrow import GARDEN, ROOT, Furrow, furrow, main, without_timing


class Faults(Furrow):
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

    def test_aircraft_with_windows_are_flown_by_sim_and_run_alike(self):
        result, _ = self.flown_alike("time_windows.yaml")
        for uav in result["uavs"]:
            self.assertGreater(len(uav["sorties"]), 0)

    def test_stations_with_hours_are_flown_by_sim_and_run_alike(self):
        result, _ = self.flown_alike("station_hours.yaml")
        west, east = result["stations"]
        self.assertEqual((west["available_from_s"], east["available_until_s"]), (300, 900))
        for station in result["stations"]:
            self.assertGreater(station["filled_l"], 0)

    def test_a_tree_that_no_map_shows_is_flown_around_by_sim_and_run_alike(self):
        for scenario in ("surprise_tree.yaml", "surprise_hill.yaml", "orchard_grid.yaml"):
            _, events = self.flown_alike(scenario)
            self.assertIn(b"obstacle_planned", events)

    def test_what_lies_behind_a_tree_without_a_way_past_is_sprayed_by_sim_and_run_alike(self):
        result, events = self.flown_alike(
            "alley_blocked.yaml",
            "runs of cells: an obstacle stands there, with no room for a detour\n"
            "furrow: the mission is not completed", 1)
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


if __name__ == "__main__":
    main()
