#!/usr/bin/env python3
"""What goes in: scenarios of the repository, broken ones, wrong options."""

from furrow import GARDEN, ROOT, Furrow, furrow, main


class Scenarios(Furrow):
    ELSEWHERE = {"alley_blocked", "block_1000ha", "bottleneck_bay", "empty_stock", "fleet_20",
                 "fleet_200", "late_joiner", "lost_agent", "mixed_fleet", "orchard_grid",
                 "station_down", "station_hours", "surprise_hill", "surprise_tree", "template", "time_windows",
                 "two_stations", "wang2017_field_a", "wang2017_field_a_single"}  # flown by other tests, or large

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
        for command in (("plan", far, "--out", self.out("none")), ("check", far)):
            done = furrow(*command)
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
    main()
