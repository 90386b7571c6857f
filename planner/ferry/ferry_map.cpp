#include "planner/ferry/ferry_map.hpp"

#include "core/require.hpp"
#include "planner/coverage/geos.hpp"
#include "planner/coverage/swath/inset.hpp"
#include "planner/coverage/swath/inside_paths.hpp"
#include "planner/ferry/aprons.hpp"
#include "planner/ferry/bends.hpp"
#include "planner/ferry/hill_ways.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace furrow::planner {
namespace {

constexpr double slack_m = 1e-6;  // ends of strips lie on the edge, rounding or not

bool is_within(const LandParts& parts, PointM p) {
  return std::any_of(parts.begin(), parts.end(),
                     [p](const LandPart& part) { return EdgeGrid{part}.contains(p); });
}

PlanError unreachable(FieldPoint stand, const char* why) {
  return {PlanFault::out_of_reach,
          fmt::format("({:.3f}, {:.3f}) m {}", stand.x.base(), stand.y.base(), why), stand};
}

}  // namespace

class FerryMap::Ground {
 public:
  Ground(PointM origin, const LandPart& land, double cut_m)
      : origin_{origin}, land_{land}, paths_{land}, cut_m_{cut_m} {}

  void cut_off(const LandPart& part) { cut_off_.emplace_back(part); }
  bool is_cut_off(PointM p) const {
    return std::any_of(cut_off_.begin(), cut_off_.end(),
                       [p](const EdgeGrid& part) { return part.contains(p); });
  }

  PointM plane(FieldPoint p) const { return PointM{p.x.base(), p.y.base()} - origin_; }
  FieldPoint field_point(PointM p) const { return at_m(p.x + origin_.x, p.y + origin_.y); }

  bool contains(PointM p) const { return paths_.edges().contains(p); }
  void add_stand(PointM stand) { fans_.push_back(paths_.fan(stand)); }
  std::vector<PointM> stands() const {
    std::vector<PointM> made;
    for (const InsidePaths::Fan& fan : fans_) made.push_back(fan.from);
    return made;
  }

  PathM way(PointM from, PointM to) const {
    if (paths_.is_convex() || norm(to - from) == 0) return {from, to};
    const PointM entered = on_land(from), left = on_land(to);
    const auto inside = inside_way(entered, left);
    PathM made = inside ? clear_of_corners(*inside, paths_.edges(), cut_m_) : PathM{entered, left};
    if (!(entered == from)) made.insert(made.begin(), from);
    if (!(left == to)) made.push_back(to);
    return made;
  }

  double length_m(PointM from, PointM to) const {
    if (paths_.is_convex()) return norm(to - from);
    if (const auto* fan = fan_of(from)) return fan_length_m(*fan, to);
    if (const auto* fan = fan_of(to)) return fan_length_m(*fan, from);
    return planner::length_m(way(from, to));
  }

  std::vector<double> lengths_m(PointM from, std::span<const PointM> line) const {
    std::vector<double> made(line.size());
    if (const auto* fan = fan_of(from)) {
      made = paths_.ways_m(*fan, line);
      for (std::size_t i = 0; i < line.size(); ++i) {
        if (made[i] == INFINITY) made[i] = planner::length_m(way(from, line[i]));
      }
      return made;
    }
    std::transform(line.begin(), line.end(), made.begin(),
                   [&](PointM to) { return length_m(from, to); });
    return made;
  }

 private:
  const InsidePaths::Fan* fan_of(PointM stand) const {
    const auto fan = std::find_if(fans_.begin(), fans_.end(),
                                  [&](const InsidePaths::Fan& f) { return f.from == stand; });
    return fan == fans_.end() ? nullptr : &*fan;
  }

  std::optional<PathM> inside_way(PointM from, PointM to) const {
    std::optional<PathM> way;
    if (const auto* out = fan_of(from)) {
      way = paths_.way(*out, to);
    } else if (const auto* home = fan_of(to)) {
      way = paths_.way(*home, from);
      if (way) std::reverse(way->begin(), way->end());
    }
    return way ? way : paths_.shortest(from, to);
  }

  double fan_length_m(const InsidePaths::Fan& fan, PointM to) const {
    const double inside_m = paths_.way_m(fan, to);
    return inside_m < INFINITY ? inside_m : planner::length_m(way(fan.from, to));
  }

  // The nearest place of the map.
  PointM on_land(PointM p) const {
    if (contains(p)) return p;
    PointM best = p;
    double away_m = INFINITY;
    each_edge(land_, [&](PointM a, PointM b) {
      const PointM q = nearest_on(p, a, b);
      if (norm(q - p) < away_m) {
        away_m = norm(q - p);
        best = q;
      }
    });
    return best;
  }

  PointM origin_;
  LandPart land_;
  InsidePaths paths_;
  double cut_m_;
  std::vector<InsidePaths::Fan> fans_{};
  std::vector<EdgeGrid> cut_off_{};
};

Expected<FerryMap, PlanError> FerryMap::over(const Field& field, const FerryRule& rule,
                                             std::span<const FieldPoint> stands) {
  const auto land = field_land(field, rule.margin, rule.hole_buffer, rule.safety);
  if (!land) return Unexpected{land.error()};
  LandParts open = with_necks(land->flight, land->land, land->taken, rule.margin.base());
  for (const FieldPoint stand : stands) {
    const PointM place = PointM{stand.x.base(), stand.y.base()} - land->origin;
    if (is_within(land->taken, place)) {
      return Unexpected{unreachable(stand, "lies in a hole or an obstacle, or too near to one")};
    }
    for (LandPart& part : subtracted(apron(place, land->flight), land->taken)) {
      open.push_back(std::move(part));
    }
  }
  open = united(open);
  const LandParts across = bridges(open, land->taken);
  open.insert(open.end(), across.begin(), across.end());
  open = offset(united(open), slack_m);
  const auto whole = std::max_element(
      open.begin(), open.end(),
      [](const LandPart& a, const LandPart& b) { return area_m2(a) < area_m2(b); });
  auto ground = std::make_shared<Ground>(land->origin, *whole, rule.corner_cut.base());
  for (auto part = open.begin(); part != open.end(); ++part) {
    if (part != whole) ground->cut_off(*part);
  }
  for (const FieldPoint stand : stands) {
    if (!ground->contains(ground->plane(stand))) {
      return Unexpected{unreachable(stand, "has no way to the field around holes and obstacles")};
    }
    ground->add_stand(ground->plane(stand));
  }
  return FerryMap{std::move(ground)};
}

bool FerryMap::reaches(FieldPoint place) const {
  return !ground_ || !ground_->is_cut_off(ground_->plane(place));
}

std::vector<FieldPoint> FerryMap::way(FieldPoint from, FieldPoint to) const {
  if (!ground_) return {from, to};
  const PathM path = ground_->way(ground_->plane(from), ground_->plane(to));
  std::vector<FieldPoint> made{from};
  for (std::size_t i = 1; i + 1 < path.size(); ++i) made.push_back(ground_->field_point(path[i]));
  made.push_back(to);
  return made;
}

bool FerryMap::is_open(FieldPoint place) const {
  return !ground_ || ground_->contains(ground_->plane(place));
}

FerryMap FerryMap::over_ground(Relief relief, const std::optional<RouteSettings>& search) const {
  FerryMap map{ground_};
  map.relief_ = std::make_shared<const Relief>(std::move(relief));
  if (search && ground_) {
    std::vector<FieldPoint> stands;
    for (const PointM stand : ground_->stands()) stands.push_back(ground_->field_point(stand));
    map.hill_ways_ =
        std::make_shared<const HillWays>(FerryMap{ground_}, map.relief_, *search, stands);
  }
  return map;
}

std::vector<FieldPoint> FerryMap::ferry_way(FieldPoint from, FieldPoint to,
                                            const Vehicle& vehicle) const {
  return hill_ways_ ? hill_ways_->way(from, to, vehicle) : way(from, to);
}

Length FerryMap::ferry_length(FieldPoint from, FieldPoint to, const Vehicle& vehicle) const {
  return hill_ways_ ? way_length(hill_ways_->way(from, to, vehicle)) : length(from, to);
}

Length FerryMap::length(FieldPoint from, FieldPoint to) const {
  if (!ground_) return distance(from, to);
  return metres(ground_->length_m(ground_->plane(from), ground_->plane(to)));
}

std::vector<double> FerryMap::lengths_m(FieldPoint from, std::span<const FieldPoint> line) const {
  std::vector<double> made(line.size());
  if (!ground_) {
    std::transform(line.begin(), line.end(), made.begin(),
                   [from](FieldPoint to) { return distance(from, to).base(); });
    return made;
  }
  std::vector<PointM> places(line.size());
  std::transform(line.begin(), line.end(), places.begin(),
                 [this](FieldPoint p) { return ground_->plane(p); });
  return ground_->lengths_m(ground_->plane(from), places);
}

}  // namespace furrow::planner
