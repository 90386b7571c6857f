#include "scheduler/fleet_returns.hpp"

#include "core/random.hpp"
#include "planner/at_once.hpp"
#include "planner/returns/simple.hpp"
#include "planner/returns/unplanned.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

namespace furrow::scheduler {
namespace {

using planner::PlanError;
using planner::ReturnPlan;
using planner::ReturnProblem;
using planner::Solution;

constexpr std::uint32_t rounds = 2;
constexpr std::size_t abreast = 16;  // threads at once

Itinerary itinerary_of(const FleetTask& task, ReturnPlan plan) {
  if (!task.times) return grounded(task.agent);
  Itinerary it = itinerary(task.agent, task.station, plan, *task.times);
  swap_as_flown(std::vector<const ReturnProblem*>(plan.sorties.size(), &*task.problem), plan, it);
  it.begins_s = task.problem->vehicle.available_from.base();
  return it;
}

/// The search for a fleet's return points: what is flown now, and the best seen so far.
class Search {
 public:
  Search(const std::vector<FleetTask>& tasks, std::span<const Station> stations,
         const planner::SolveSettings& settings)
      : tasks_{tasks}, stations_{stations}, settings_{settings} {
    for (const FleetTask& t : tasks) flying_ += t.problem ? 1 : 0;
  }

  /// Every aircraft as if it were alone.
  std::optional<PlanError> solve_alone() {
    const auto solve_one = [this](std::size_t u) -> Expected<Solution, PlanError> {
      if (!tasks_[u].problem) return Solution{};
      return planner::solve(*tasks_[u].problem, settings_for(tasks_[u].agent, 0));
    };
    for (std::size_t u = 0; u < tasks_.size(); u += abreast) {
      const std::size_t count = std::min(abreast, tasks_.size() - u);
      for (auto& solved :
           planner::at_once(count, [&](std::size_t i) { return solve_one(u + i); })) {
        if (!solved) return solved.error();
        current_.push_back(std::move(*solved));
      }
    }
    flown_.emplace(itineraries(current_), stations_);
    best_ = current_;
    best_worth_ = worth(flown_->spray_ends_s());
    return std::nullopt;
  }

  /// Looks at the fleet with every aircraft on the plan that `planned` makes.
  template <class Planned>
  void consider_all(Planned planned) {
    std::vector<Solution> solutions = current_;
    for (std::size_t u = 0; u < tasks_.size(); ++u) {
      if (!tasks_[u].problem) continue;
      const auto plan = planned(*tasks_[u].problem);
      if (!plan) return;
      solutions[u].plan = *plan;
      solutions[u].objective_s = plan->non_spray_s;
      solutions[u].proven = plan->non_spray_s <= solutions[u].lower_bound_s;
    }
    const auto seen = worth(forecast(itineraries(solutions), stations_));
    if (seen >= best_worth_) return;
    best_ = std::move(solutions);
    best_worth_ = seen;
    since_best_.resize(tasks_.size());
    std::iota(since_best_.begin(), since_best_.end(), std::size_t{0});
  }

  /// Lets every aircraft in turn answer what the others do.
  void respond(std::uint32_t round) {
    for (std::size_t u = 0; u < tasks_.size(); ++u) {
      if (tasks_[u].problem) respond(u, round);
    }
  }

  std::size_t flying() const { return flying_; }
  FleetReturns best() && {
    Forecast seen = forecast(itineraries(best_), stations_);
    return {std::move(best_), std::move(seen)};
  }

 private:
  planner::SolveSettings settings_for(AgentId agent, std::uint32_t round) const {
    planner::SolveSettings s = settings_;
    if (flying_ <= 1) return s;
    const std::size_t times = planner::is_by_gravity(s.returns) ? 1 + rounds : 1;
    s.seed = seed_for(s.seed, {number(agent), round});
    s.budget_s /= static_cast<double>(flying_ * times);
    return s;
  }

  std::vector<Itinerary> itineraries(const std::vector<Solution>& solutions) const {
    std::vector<Itinerary> all;
    for (std::size_t u = 0; u < tasks_.size(); ++u) {
      all.push_back(itinerary_of(tasks_[u], solutions[u].plan));
    }
    return all;
  }

  void respond(std::size_t u, std::uint32_t round) {
    const std::uint32_t station = tasks_[u].station;
    std::vector<Itinerary> here;
    std::size_t index = 0;
    for (std::size_t other = 0; other < tasks_.size(); ++other) {
      if (tasks_[other].station != station) continue;
      if (other == u) index = here.size();
      here.push_back(flown_->itineraries()[other]);
    }
    QueueClock clock{stations_[station], std::move(here)};
    const double without_s = clock.queue_wait_without_s(index);
    const double with_s = clock.queue_wait_s(index, itinerary_of(tasks_[u], current_[u].plan));
    // Nobody waits, and no plan takes less time by itself.
    if (current_[u].proven && with_s <= 0.0 && without_s <= 0.0) return;
    const auto added_wait_s = [&](const ReturnPlan& plan) {
      return clock.queue_wait_s(index, itinerary_of(tasks_[u], plan)) - without_s;
    };
    const double now_s = current_[u].plan.non_spray_s + (with_s - without_s);
    auto answer =
        planner::solve(*tasks_[u].problem, settings_for(tasks_[u].agent, round), added_wait_s);
    if (!answer || answer->objective_s >= now_s) return;
    current_[u] = std::move(*answer);
    flown_->change(u, itinerary_of(tasks_[u], current_[u].plan));
    since_best_.push_back(u);
    const auto seen = worth(flown_->spray_ends_s());
    if (seen >= best_worth_) return;
    for (const std::size_t i : since_best_) best_[i] = current_[i];
    since_best_.clear();
    best_worth_ = seen;
  }

  const std::vector<FleetTask>& tasks_;
  std::span<const Station> stations_;
  planner::SolveSettings settings_;
  std::size_t flying_ = 0;
  std::vector<Solution> current_{};
  std::optional<FleetEnds> flown_{};  ///< By the current solutions.
  std::vector<Solution> best_{};
  std::tuple<double, double> best_worth_{};
  std::vector<std::size_t> since_best_{};  ///< Whose current solution may not be the best's.
};

}  // namespace

Expected<FleetReturns, PlanError> fleet_returns(const std::vector<FleetTask>& tasks,
                                                std::span<const Station> stations,
                                                const planner::SolveSettings& settings) {
  Search search{tasks, stations, settings};
  if (auto error = search.solve_alone()) return Unexpected{std::move(*error)};
  if (planner::is_by_gravity(settings.returns) && search.flying() > 1) {
    search.consider_all([](const ReturnProblem& p) { return planner::unplanned_plan(p); });
    search.consider_all([](const ReturnProblem& p) { return planner::simple_plan(p); });
    for (std::uint32_t round = 1; round <= rounds; ++round) search.respond(round);
  }
  return std::move(search).best();
}

}  // namespace furrow::scheduler
