// Aircraft that are lost at random: no cell is lost with them, none is sprayed twice.

#include "core/random.hpp"
#include "mission/load.hpp"
#include "scheduler/plan_fleet.hpp"
#include "sim/checkers/laws.hpp"
#include "tests/sim/whole_fleet.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

namespace furrow::sim {
namespace {

/// Four aircraft on 1.2 ha, each back for mix once or twice, at one bay.
mission::Scenario small_fleet() {
  auto loaded = mission::load("scenarios/lost_agent.yaml");
  REQUIRE(loaded);
  loaded->field.boundary = {at_m(140, 0), at_m(260, 0), at_m(260, 100), at_m(140, 100)};
  loaded->stations[0].bays = 1;
  for (Vehicle& v : loaded->uavs) v.spray_endurance = seconds(80);
  loaded->faults.clear();
  loaded->mission_limit = std::chrono::hours{2};
  return *loaded;
}

/// One to all of the aircraft die at any time of the mission, over a radio that delays and repeats.
std::vector<mission::Fault> random_faults(Random& random, const mission::Scenario& s,
                                          double mission_s) {
  std::vector<mission::Fault> faults;
  for (const Vehicle& v : s.uavs) {
    if (!faults.empty() && random.below(2) == 0) continue;
    const double at_s =
        static_cast<double>(random.below(static_cast<std::uint64_t>(1.2 * mission_s)));
    faults.push_back({.at = instant(seconds(at_s)),
                      .kind = mission::Fault::Kind::agent_kill,
                      .target = node(v.id)});
  }
  return faults;
}

/// The last one or two aircraft come at any time of the mission; those who never come are lost to
/// nobody.
std::vector<mission::Fault> random_joins(Random& random, const mission::Scenario& s,
                                         double mission_s) {
  std::vector<mission::Fault> faults;
  const std::size_t late = 1 + random.below(2);
  for (std::size_t i = s.uavs.size() - late; i < s.uavs.size(); ++i) {
    const auto at_s = static_cast<double>(1 + random.below(static_cast<std::uint64_t>(mission_s)));
    faults.push_back({.at = instant(seconds(at_s)),
                      .kind = mission::Fault::Kind::agent_join,
                      .target = node(s.uavs[i].id)});
  }
  return faults;
}

SchedulerState last_word(const Log& log) {
  SchedulerState last{};
  for (const Envelope& e : log.envelopes) {
    if (const auto* state = std::get_if<SchedulerState>(&e.body)) last = *state;
  }
  return last;
}

std::size_t count(const Log& log, std::string_view kind) {
  return static_cast<std::size_t>(
      std::count_if(log.envelopes.begin(), log.envelopes.end(), [&](const Envelope& e) {
        const auto* event = std::get_if<Event>(&e.body);
        return event != nullptr && event->kind == kind;
      }));
}

/// In how many runs which law was broken.
class Verdicts {
 public:
  void add(std::uint64_t seed, const std::vector<Violation>& violations) {
    std::set<std::string> laws;
    for (const Violation& v : violations) {
      if (!laws.insert(v.law).second) continue;
      Broken& broken = broken_[v.law];
      if (++broken.runs > 1) continue;
      broken.first = "first by seed " + std::to_string(seed) + " at " +
                     std::to_string(seconds(v.at).base()) + " s: " + v.detail;
    }
  }
  void check() const {
    for (const auto& [law, broken] : broken_) {
      FAIL_CHECK("law " << law << " is broken in " << broken.runs << " runs, " << broken.first);
    }
  }

 private:
  struct Broken {
    std::size_t runs = 0;
    std::string first{};
  };
  std::map<std::string, Broken> broken_{};
};

/// Whether every aircraft is lost, taken out or, what nobody notices once it is done, killed.
bool is_nobody_left(const mission::Scenario& scenario, const Log& log, const SchedulerState& last) {
  std::set<AgentId> gone{last.lost.begin(), last.lost.end()};
  for (const mission::Fault& f : scenario.faults) {
    const bool is_out =
        f.kind == mission::Fault::Kind::agent_kill || f.kind == mission::Fault::Kind::take_out;
    if (is_out && f.at <= log.ended) gone.insert(AgentId{f.target.number});
  }
  return gone.size() == scenario.uavs.size();
}

/// Which laws are broken; and every cell is sprayed or uncertain unless all are lost.
SchedulerState judged(const mission::Scenario& scenario, const scheduler::FleetPlan& plan,
                      const Log& log, Verdicts& verdicts) {
  REQUIRE(log.finished);
  const Facts facts{.field = scenario.field,
                    .stations = scenario.stations,
                    .plan = plan,
                    .claim_lease = scenario.agent_lease,
                    .whole = true,
                    .wind = scenario.wind,
                    .separation = scenario.separation};
  verdicts.add(scenario.seed, violations(facts, log.envelopes, log.ended));
  const SchedulerState last = last_word(log);
  REQUIRE(last.open_cells == 0);
  REQUIRE(count(log, "agent_lost") == last.lost.size());
  return last;
}

void bad_radio(mission::Scenario& scenario, Random& random) {
  scenario.link.jitter = Duration{static_cast<std::int64_t>(random.below(300'000'000))};
  scenario.link.duplication = 0.1;
}

void fly_random_joins(std::uint64_t first_seed, std::uint64_t runs) {
  mission::Scenario scenario = small_fleet();
  std::size_t taken_over = 0;
  Verdicts verdicts;
  for (std::uint64_t seed = first_seed; seed < first_seed + runs; ++seed) {
    CAPTURE(seed);
    Random random{seed};
    scenario.seed = seed;
    scenario.faults = random_joins(random, scenario, 600);
    const auto plan = scheduler::plan_fleet(mission::fleet_problem(scenario));
    REQUIRE(plan);
    bad_radio(scenario, random);
    if (random.below(3) == 0) {
      const auto more = random_faults(random, scenario, plan->makespan_s);
      scenario.faults.insert(scenario.faults.end(), more.begin(), more.end());
    }
    const Log log = flown(scenario, *plan);
    const SchedulerState last = judged(scenario, *plan, log, verdicts);
    if (scenario.faults.size() <= 2) REQUIRE(last.completed);
    taken_over += count(log, "work_taken_over");
  }
  verdicts.check();
  CHECK(taken_over >= runs / 2);
}

/// Two stations of little mix and few packs, whose bays fail at any time.
void fly_random_shortages(std::uint64_t first_seed, std::uint64_t runs) {
  mission::Scenario scenario = small_fleet();
  scenario.stations.push_back(scenario.stations[0]);
  scenario.stations[1].id = StationId{2};
  scenario.stations[1].position = at_m(300, 50);
  const auto plan = scheduler::plan_fleet(mission::fleet_problem(scenario));
  REQUIRE(plan);
  std::size_t completed = 0, elsewhere = 0;
  Verdicts verdicts;
  for (std::uint64_t seed = first_seed; seed < first_seed + runs; ++seed) {
    CAPTURE(seed);
    Random random{seed};
    scenario.seed = seed;
    bad_radio(scenario, random);
    scenario.faults.clear();
    for (Station& station : scenario.stations) {
      station.mix = litres(static_cast<double>(random.below(120)));
      station.packs = static_cast<std::uint32_t>(random.below(4));
      if (random.below(2) == 0) continue;
      const double at_s = static_cast<double>(random.below(900));
      scenario.faults.push_back({.at = instant(seconds(at_s)),
                                 .kind = mission::Fault::Kind::bay_down,
                                 .target = node(station.id)});
    }
    const Log log = flown(scenario, *plan);
    const SchedulerState last = judged(scenario, *plan, log, verdicts);
    // Who gives up closes its windows before it says so: what is left dry is known.
    REQUIRE((last.completed || count(log, "not_served") > 0));
    completed += last.completed;
    elsewhere += count(log, "goes_elsewhere");
  }
  verdicts.check();
  CHECK(completed > runs / 10);
  CHECK(completed < runs);
  CHECK(elsewhere > runs / 4);
}

/// Flies one plan of a small fleet with the faults of each seed, over a bad radio.
template <class Faults, class Check>
void fly_seeds(std::uint64_t first_seed, std::uint64_t runs, Faults faults_of, Check check) {
  mission::Scenario scenario = small_fleet();
  Verdicts verdicts;
  const auto plan = scheduler::plan_fleet(mission::fleet_problem(scenario));
  REQUIRE(plan);
  for (std::uint64_t seed = first_seed; seed < first_seed + runs; ++seed) {
    CAPTURE(seed);
    Random random{seed};
    scenario.seed = seed;
    scenario.faults = faults_of(random, scenario, plan->makespan_s);
    bad_radio(scenario, random);
    const Log log = flown(scenario, *plan);
    const SchedulerState last = judged(scenario, *plan, log, verdicts);
    check(log, last, is_nobody_left(scenario, log, last));
  }
  verdicts.check();
}

void fly_random_faults(std::uint64_t first_seed, std::uint64_t runs) {
  std::size_t lost = 0, taken_over = 0;
  const auto check = [&](const Log& log, const SchedulerState& last, bool is_nobody_left) {
    // Whoever is left sprays what is left.
    if (!is_nobody_left) REQUIRE(last.completed);
    REQUIRE(count(log, "cells_uncertain") <= 2 * last.lost.size());
    lost += last.lost.size();
    taken_over += count(log, "work_taken_over");
  };
  fly_seeds(first_seed, runs, random_faults, check);
  CHECK(lost >= runs);
  CHECK(taken_over >= runs);
}

/// One to five orders at any time, among aircraft that die; at last all may go on.
std::vector<mission::Fault> random_orders(Random& random, const mission::Scenario& s,
                                          double mission_s) {
  using Kind = mission::Fault::Kind;
  constexpr std::array kinds{Kind::pause, Kind::resume, Kind::return_all, Kind::take_out};
  std::vector<mission::Fault> faults;
  double at_s = 0.0;
  for (std::uint64_t left = 1 + random.below(5); left > 0; --left) {
    at_s += static_cast<double>(random.below(static_cast<std::uint64_t>(0.4 * mission_s)));
    const Kind kind = kinds[random.below(kinds.size())];
    const NodeId target =
        kind == Kind::take_out ? node(s.uavs[random.below(s.uavs.size())].id) : scheduler_node();
    faults.push_back({.at = instant(seconds(at_s)), .kind = kind, .target = target});
  }
  const Kind last = random.below(4) == 0 ? Kind::stop : Kind::resume;
  faults.push_back({.at = instant(seconds(at_s + 60)), .kind = last, .target = scheduler_node()});
  if (random.below(2) == 0) {
    const auto more = random_faults(random, s, mission_s);
    faults.insert(faults.end(), more.begin(), more.end());
  }
  return faults;
}

void fly_random_orders(std::uint64_t first_seed, std::uint64_t runs) {
  std::size_t obeyed = 0, stopped = 0, completed = 0;
  const auto check = [&](const Log& log, const SchedulerState& last, bool is_nobody_left) {
    const bool is_stopped = count(log, "mission_stopped") > 0;
    if (!is_stopped && !is_nobody_left) REQUIRE(last.completed);
    obeyed += count(log, "fleet_paused") + count(log, "fleet_recalled");
    stopped += is_stopped;
    completed += last.completed;
  };
  fly_seeds(first_seed, runs, random_orders, check);
  CHECK(obeyed > runs / 2);
  CHECK(stopped > runs / 10);
  CHECK(completed > runs / 2);
}

/// Over a radio so bad that aircraft are taken for lost and fly on.
void fly_random_silences(std::uint64_t first_seed, std::uint64_t runs) {
  mission::Scenario scenario = small_fleet();
  scenario.link.loss = 0.45;
  scenario.agent_lease = std::chrono::seconds{3};
  const auto plan = scheduler::plan_fleet(mission::fleet_problem(scenario));
  REQUIRE(plan);
  std::size_t lost = 0, came_home = 0;
  Verdicts verdicts;
  for (std::uint64_t seed = first_seed; seed < first_seed + runs; ++seed) {
    CAPTURE(seed);
    scenario.seed = seed;
    const Log log = flown(scenario, *plan);
    const SchedulerState last = judged(scenario, *plan, log, verdicts);
    lost += last.lost.size();
    came_home += count(log, "given_up");
  }
  verdicts.check();
  CHECK(lost > runs);
  CHECK(came_home > lost / 2);
}

TEST_CASE("random faults: who is taken for lost and flies on is kept clear of", "[sim]") {
  fly_random_silences(1, 30);
}

TEST_CASE("random faults: what the operator orders loses no cell and sprays none twice", "[sim]") {
  fly_random_orders(1, 100);
}

TEST_CASE("random faults: what lost aircraft leave is sprayed once, by the others", "[sim]") {
  fly_random_faults(1, 100);
}

TEST_CASE("random faults: who joins late sprays nothing twice and leaves nothing out", "[sim]") {
  fly_random_joins(1, 20);
}

TEST_CASE("random faults: stations that fail or run out leave no cell unaccounted for", "[sim]") {
  fly_random_shortages(1, 100);
}

TEST_CASE("a thousand random fault runs of every kind", "[.][sim]") {
  SECTION("aircraft lost") { fly_random_faults(1001, 400); }
  SECTION("orders") { fly_random_orders(1001, 300); }
  SECTION("shortages") { fly_random_shortages(1001, 200); }
  SECTION("joins") { fly_random_joins(1001, 100); }
}

TEST_CASE("three thousand more random fault runs", "[.][sim]") {
  SECTION("aircraft lost") { fly_random_faults(2001, 1500); }
  SECTION("orders") { fly_random_orders(2001, 1500); }
}

}  // namespace
}  // namespace furrow::sim
