#include "planner/fleet/cut_plan.hpp"

#include "planner/fleet/queue_clock.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace furrow::planner::fleet {
namespace {

constexpr double least_m = 1e-6;  ///< No sortie is shorter.
constexpr double slack_m = 1e-9;  ///< Of rounding, in a tank.

}  // namespace

CutPlan::CutPlan(const FleetProblem& problem, FleetSorties sorties)
    : problem_{&problem}, sorties_{std::move(sorties)}, by_place_(sorties_.size()) {
  std::iota(by_place_.begin(), by_place_.end(), 0U);
  std::sort(by_place_.begin(), by_place_.end(),
            [&](auto a, auto b) { return sorties_[a].from_m < sorties_[b].from_m; });
}

bool CutPlan::change(Random& random) {
  const double drawn = random.uniform();
  if (drawn < 0.45) return shift_cut(random);
  if (drawn < 0.55) return shift_cuts(random);
  if (drawn < 0.70) return exchange(random);
  if (drawn < 0.85) return hand_over(random);
  if (drawn < 0.90) return divide(random);
  if (drawn < 0.95) return join(random);
  return land_elsewhere(random);
}

std::uint32_t CutPlan::nearest_depot(double at_m) const {
  const auto nearer = [&](const Depot& a, const Depot& b) {
    return problem_->path.back_m(a.position, at_m) < problem_->path.back_m(b.position, at_m);
  };
  const auto& depots = problem_->depots;
  return static_cast<std::uint32_t>(std::min_element(depots.begin(), depots.end(), nearer) -
                                    depots.begin());
}

double CutPlan::drawn_cut_m(Random& random, double low_m, double high_m, double now_m) const {
  const StripPath& path = problem_->path;
  const double kind = random.uniform();
  if (kind < 0.35) {
    const double step_m = (high_m - low_m) * std::pow(10.0, -4.0 * random.uniform());
    return std::clamp(now_m + random.uniform(-step_m, step_m), low_m, high_m);
  }
  if (kind < 0.75) {
    const std::uint32_t first = path.strip_from(low_m), last = path.strip_to(high_m);
    const auto strip = first + static_cast<std::uint32_t>(random.below(last - first + 1));
    const double end_m = path.begin_m(strip + (random.below(2) == 0 ? 0U : 1U));
    if (low_m <= end_m && end_m <= high_m) return end_m;
  }
  if (kind < 0.85) return random.below(2) == 0 ? low_m : high_m;
  return random.uniform(low_m, high_m);
}

bool CutPlan::shift_cut(Random& random) {
  if (by_place_.size() < 2) return false;
  const std::size_t k = random.below(by_place_.size() - 1);
  Sortie &before = along(k), &after = along(k + 1);
  const double low_m = std::max(before.from_m + least_m, after.to_m - tank_m(after));
  const double high_m = std::min(after.to_m - least_m, before.from_m + tank_m(before));
  if (!(low_m < high_m)) return false;
  const double at_m = drawn_cut_m(random, low_m, high_m, before.to_m);
  const bool to_nearest = before.depot == nearest_depot(before.to_m);
  before.to_m = after.from_m = at_m;
  if (to_nearest) before.depot = nearest_depot(at_m);
  return true;
}

bool CutPlan::shift_cuts(Random& random) {
  if (by_place_.size() < 3) return false;
  const std::size_t cuts = by_place_.size() - 1;
  const std::size_t first = random.below(cuts);
  const std::size_t last = first + random.below(std::min<std::size_t>(cuts - first, 8));
  Sortie &before = along(first), &after = along(last + 1);
  const double now_m = before.to_m, room_m = after.to_m - after.from_m;
  const double low_m = std::max(before.from_m + least_m, now_m - (tank_m(after) - room_m));
  const double high_m = std::min(before.from_m + tank_m(before), now_m + room_m - least_m);
  if (!(low_m < high_m)) return false;
  const double by_m = drawn_cut_m(random, low_m, high_m, now_m) - now_m;
  for (std::size_t k = first; k <= last; ++k) {
    along(k).to_m += by_m;
    along(k + 1).from_m = along(k).to_m;
    if (problem_->depots.size() > 1) along(k).depot = nearest_depot(along(k).to_m);
  }
  return true;
}

bool CutPlan::exchange(Random& random) {
  const std::size_t i = random.below(sorties_.size()), j = random.below(sorties_.size());
  Sortie &a = sorties_[i], &b = sorties_[j];
  if (i == j || a.to_m - a.from_m > tank_m(b) + slack_m || b.to_m - b.from_m > tank_m(a) + slack_m)
    return false;
  std::swap(a.from_m, b.from_m);
  std::swap(a.to_m, b.to_m);
  std::swap(a.depot, b.depot);
  for (std::uint32_t& s : by_place_)
    s = s == i ? static_cast<std::uint32_t>(j) : s == j ? static_cast<std::uint32_t>(i) : s;
  return true;
}

void CutPlan::take_out(std::size_t flown) {
  sorties_.erase(sorties_.begin() + static_cast<std::ptrdiff_t>(flown));
  by_place_.erase(std::find(by_place_.begin(), by_place_.end(), flown));
  for (std::uint32_t& s : by_place_) s -= s > flown ? 1U : 0U;
}

void CutPlan::put_in(std::size_t flown, std::size_t place, const Sortie& sortie) {
  for (std::uint32_t& s : by_place_) s += s >= flown ? 1U : 0U;
  sorties_.insert(sorties_.begin() + static_cast<std::ptrdiff_t>(flown), sortie);
  by_place_.insert(by_place_.begin() + static_cast<std::ptrdiff_t>(place),
                   static_cast<std::uint32_t>(flown));
}

bool CutPlan::hand_over(Random& random) {
  const std::size_t place = random.below(sorties_.size());
  Sortie sortie = along(place);
  sortie.flier = static_cast<std::uint32_t>(random.below(problem_->fliers.size()));
  const std::size_t to = random.below(sorties_.size());
  if (sortie.to_m - sortie.from_m > tank_m(sortie) + slack_m) return false;
  take_out(by_place_[place]);
  put_in(to, place, sortie);
  return true;
}

bool CutPlan::divide(Random& random) {
  const std::size_t place = random.below(sorties_.size());
  Sortie& before = along(place);
  if (before.to_m - before.from_m < 4.0 * least_m) return false;
  const auto flier = static_cast<std::uint32_t>(random.below(problem_->fliers.size()));
  Sortie after = before;
  after.flier = flier;
  const double low_m = std::max(before.from_m + least_m, before.to_m - tank_m(after));
  const double high_m = before.to_m - least_m;
  if (!(low_m < high_m)) return false;
  after.from_m = before.to_m =
      drawn_cut_m(random, low_m, high_m, 0.5 * (before.from_m + before.to_m));
  before.depot = nearest_depot(before.to_m);
  put_in(random.below(sorties_.size() + 1), place + 1, after);
  return true;
}

bool CutPlan::join(Random& random) {
  if (by_place_.size() < 2) return false;
  const std::size_t place = random.below(by_place_.size() - 1);
  const bool keep_first = random.below(2) == 0;
  Sortie joined = along(keep_first ? place : place + 1);
  joined.from_m = along(place).from_m;
  joined.to_m = along(place + 1).to_m;
  joined.depot = along(place + 1).depot;
  if (joined.to_m - joined.from_m > tank_m(joined) + slack_m) return false;
  along(keep_first ? place : place + 1) = joined;
  take_out(by_place_[keep_first ? place + 1 : place]);
  return true;
}

bool CutPlan::land_elsewhere(Random& random) {
  if (problem_->depots.size() < 2) return shift_cut(random);
  Sortie& sortie = sorties_[random.below(sorties_.size())];
  sortie.depot = static_cast<std::uint32_t>(random.below(problem_->depots.size()));
  return true;
}

bool is_carried(const FleetProblem& problem, const FleetSorties& sorties) {
  std::vector<FieldPoint> from;
  from.reserve(problem.fliers.size());
  for (const Flier& f : problem.fliers) from.push_back(f.start);
  return std::all_of(sorties.begin(), sorties.end(), [&](const Sortie& s) {
    const Flier& f = problem.fliers[s.flier];
    const bool carried = s.to_m - s.from_m <= f.tank_m + slack_m &&
                         flight_s(problem, s, from[s.flier]) <= f.pack_s + slack_m;
    from[s.flier] = problem.depots[s.depot].position;
    return carried;
  });
}

}  // namespace furrow::planner::fleet
