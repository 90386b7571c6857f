#include "mission/obstacles.hpp"

#include "exchange/land.hpp"
#include "planner/coverage/mend.hpp"

#include <fmt/format.h>

#include <set>

namespace furrow::mission {
namespace {

constexpr std::size_t most_entries = 1'000;
constexpr double latest_s = 10'000'000, furthest_m = 10'000;
constexpr const char* sound_outline = "must be a ring that does not cross itself";

// What planning would refuse it for.
std::optional<std::string> outline_fault(const Ring& outline) {
  const auto mended = planner::mended(outline, planner::origin_of(outline), "outline");
  if (mended) return std::nullopt;
  return mended.error().detail;
}

// Round, or of any outline.
Obstacle read_obstacle(const Section& s) {
  std::string id = s.name("id");
  const Ring outline = s.optional_ring("boundary_m", "round");
  const auto center = s.optional_point("center_m", "boundary_m");
  const auto radius = s.optional_number("radius_m", above_to(0, 10'000), "boundary_m");
  if (s.has("boundary_m")) {
    for (const char* key : {"center_m", "radius_m"}) {
      if (s.has(key)) s.fail(key, "must be left out beside boundary_m");
    }
    if (!outline.empty()) {
      if (const auto fault = outline_fault(outline)) s.fail("boundary_m", sound_outline, *fault);
      return outlined(std::move(id), outline);
    }
  } else {
    for (const char* key : {"center_m", "radius_m"}) {
      if (!s.has(key)) s.fail(key, "is required, or boundary_m");
    }
  }
  return {std::move(id), center.value_or(FieldPoint{}), metres(radius.value_or(1))};
}

// What the plan does not know of it, if anything.
std::optional<Surprise> read_surprise(const Section& s, const Obstacle& obstacle) {
  const auto seen_m =
      s.optional_number("seen_within_m", above_to(0, furthest_m), "known to the plan");
  const auto appears_s = s.optional_number("appears_s", from_to(0, latest_s), "from the start");
  if (!s.has("seen_within_m") && s.has("appears_s")) {
    s.fail("appears_s", "needs seen_within_m: how near an aircraft must be to see it");
  }
  if (!s.has("seen_within_m")) return std::nullopt;
  if (!obstacle.outline.empty()) {
    s.fail("seen_within_m", "belongs to round obstacles, not to those with boundary_m");
  }
  return Surprise{.id = obstacle.id,
                  .obstacle = {obstacle.center, obstacle.radius},
                  .appears = Instant{duration(seconds(appears_s.value_or(0)))},
                  .seen_within = metres(seen_m.value_or(1))};
}

// Reads the obstacles of one scenario, whose ids are unique.
class Reading {
 public:
  explicit Reading(Draft& draft) : draft_{draft} {}

  void read_entries(const Section& root) {
    for (const auto& s : root.list("obstacles", 0, most_entries)) {
      Obstacle made = read_obstacle(s);
      if (!made.id.empty() && !ids_.insert(made.id).second) {
        s.fail("id", "must be unique among the obstacles");
      }
      if (auto surprise = read_surprise(s, made)) {
        add(std::move(*surprise), {s, "seen_within_m", "center_m", {}});
      } else {
        const char* place_key = made.outline.empty() ? "center_m" : "boundary_m";
        add(std::move(made), {s, "seen_within_m", place_key, {}});
      }
    }
  }

  void read_file(const Section& root) {
    const auto file = root.optional_text("obstacles_file", "none");
    if (!file) return;
    if (!draft_.scenario.datum) {
      root.fail("obstacles_file", "needs field.file or field.datum, its places being on the globe");
      return;
    }
    auto read = exchange::read_obstacles(root.findings().beside(*file),
                                         exchange::LocalFrame{*draft_.scenario.datum});
    if (!read) {
      root.fail("obstacles_file", read.error().rule,
                fmt::format("{} in {}", read.error().value, *file));
      return;
    }
    for (exchange::FileObstacle& found : *read) take(root, *file, std::move(found));
    const std::size_t all = draft_.obstacles.size() + draft_.surprises.size();
    if (all > most_entries) {
      root.fail("obstacles_file",
                fmt::format("must leave at most {} obstacles in all", most_entries),
                std::to_string(all));
    }
  }

 private:
  void add(Obstacle obstacle, ObstacleEntry entry) {
    draft_.scenario.field.obstacles.push_back(std::move(obstacle));
    draft_.obstacles.push_back(std::move(entry));
  }

  void add(Surprise surprise, ObstacleEntry entry) {
    draft_.scenario.surprises.push_back(std::move(surprise));
    draft_.surprises.push_back(std::move(entry));
  }

  void take(const Section& root, const std::string& file, exchange::FileObstacle found) {
    Obstacle& o = found.obstacle;
    const std::string where = fmt::format("{} in {}", found.feature, file);
    const auto fail = [&](std::string rule, const std::string& value = {}) {
      root.fail("obstacles_file", std::move(rule),
                value.empty() ? where : fmt::format("{}: {}", where, value));
    };
    if (!ids_.insert(o.id).second) fail("must hold ids that are unique among the obstacles", o.id);
    if (o.radius > metres(furthest_m)) fail("must hold radius_m of at most 10000");
    if (!o.outline.empty()) {
      if (const auto fault = outline_fault(o.outline)) {
        fail("must hold rings that do not cross themselves", *fault);
      }
    }
    if (found.appears && !found.seen_within) fail("must hold appears_s beside seen_within_m only");
    if (!found.seen_within) {
      return add(std::move(o), {root, "obstacles_file", "obstacles_file", where});
    }
    if (!o.outline.empty()) fail("must hold seen_within_m of points only");
    const double appears_s = found.appears.value_or(Seconds{}).base();
    if (*found.seen_within > metres(furthest_m)) fail("must hold seen_within_m of at most 10000");
    if (appears_s > latest_s) fail("must hold appears_s of at most 10000000");
    add({.id = o.id,
         .obstacle = {o.center, o.radius},
         .appears = Instant{duration(seconds(std::min(appears_s, latest_s)))},
         .seen_within = *found.seen_within},
        {root, "obstacles_file", "obstacles_file", where});
  }

  Draft& draft_;
  std::set<std::string> ids_{};
};

}  // namespace

void read_obstacles(const Section& root, Draft& draft) {
  Reading reading{draft};
  reading.read_entries(root);
  reading.read_file(root);
}

}  // namespace furrow::mission
