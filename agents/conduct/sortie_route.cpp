#include "agents/conduct/sortie_route.hpp"

#include "agents/aircraft.hpp"
#include "planner/coverage/route.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace furrow::agents {
namespace {

constexpr double same_place_m = 1e-6;
constexpr double blocked_room_m = 0.5;  // that a hovering aircraft takes

double spacing(const Piece& piece) {
  return piece.cells.count < 2 ? 0.0
                               : distance(piece.from, piece.to).base() / (piece.cells.count - 1);
}

// A place on the legs of a route.
struct Placed {
  FieldPoint at;
  double leg_m;
};

// Where along the legs the centres of a piece's cells are first abeam.
std::vector<double> abeam_leg_m(const Piece& piece, const std::vector<Placed>& legs) {
  const bool is_one = piece.cells.count == 1;
  const Xy from = xy_m(piece.from);
  const Xy way = is_one ? xy_m(piece.exit) - xy_m(piece.entry) : xy_m(piece.to) - from;
  const Xy ahead = (1.0 / std::max(norm(way), same_place_m)) * way;
  const auto along = [&](FieldPoint p) { return dot(xy_m(p) - from, ahead); };
  const double spacing_m = spacing(piece);
  std::vector<double> cells;
  cells.reserve(piece.cells.count);
  std::size_t leg = 1;
  for (std::uint32_t i = 0; i < piece.cells.count; ++i) {
    const double wanted_m = i * spacing_m;
    while (leg + 1 < legs.size() && along(legs[leg].at) < wanted_m) ++leg;
    const double a = along(legs[leg - 1].at), b = along(legs[leg].at);
    const double share = b > a ? std::clamp((wanted_m - a) / (b - a), 0.0, 1.0) : 1.0;
    cells.push_back(std::lerp(legs[leg - 1].leg_m, legs[leg].leg_m, share));
  }
  return cells;
}

// Where a piece is laid: its corners, the first where it begins, and the way around obstacles.
struct PieceLegs {
  std::vector<Placed> corners;
  std::optional<double> first_bend_m{}, last_bend_m{};
  std::vector<PieceOnPath::Closed> closed{};
};

// Lays the legs of a route around what was seen, over terrain with heights.
class Laying {
 public:
  Laying(SortieRoute& route, Xy from_m, const Vehicle& vehicle, const planner::FerryMap& ferries,
         const Surroundings& around, std::optional<Length> begins)
      : route_{route},
        vehicle_{vehicle},
        ferries_{ferries},
        relief_{ferries.relief()},
        around_{around},
        begins_{begins},
        at_{field_point(from_m)} {}

  /// Each returns where along the legs it ends [m].
  double spray(FieldPoint to, Corner corner = Corner::cut) {
    const auto bends = around_.strip_bends(at_, to, vehicle_.swath);
    if (!bends) block(leg_m_, at_, to);
    for (const StripBend& b : bends.value_or(std::vector<StripBend>{})) {
      const double from_m = leg_m_;
      bend(b.at, vehicle_.spray_speed);
      if (!b.sprays) close(from_m, leg_m_);
    }
    level_or_over(to, vehicle_.spray_speed, corner);
    piece_.corners.push_back({at_, leg_m_});
    return leg_m_;
  }
  double work(FieldPoint to, Speed speed, Corner corner = Corner::cut) {
    return bent(ferry_bends(at_, to), to, speed, corner);
  }
  /// By the way points of an approach at their heights, where it has any and nothing stands in the
  /// way; and on to `entry`.
  double approach(const Piece& piece, Speed speed, Corner corner) {
    std::vector<FieldPoint> way{at_};
    way.insert(way.end(), piece.approach.begin(), piece.approach.end());
    way.push_back(piece.entry);
    const bool has_heights = relief_ != nullptr && !piece.approach_altitudes_m.empty();
    if (has_heights && is_clear(way)) {
      const auto air =
          relief_->way_at(at_, piece.approach, piece.approach_altitudes_m, piece.entry);
      return over(relief_->straight(air, speed), corner, Corner::held);
    }
    if (has_heights || (relief_ != nullptr && planner::is_high(way))) {
      return over(relief_->ferry(led_around(way), vehicle_, begins()), corner, Corner::held);
    }
    for (const FieldPoint at : piece.approach) pass(at, vehicle_.ferry_speed, Corner::held);
    return work(piece.entry, speed, corner);
  }
  double ferry(FieldPoint to, Corner corner = Corner::cut) {
    const Speed speed = vehicle_.ferry_speed;
    const std::vector<FieldPoint> way = ferries_.ferry_way(at_, to, vehicle_);
    if (relief_ != nullptr) {
      const auto led = led_around(way);
      return over(relief_->ferry(led, vehicle_, begins()), corner);
    }
    for (std::size_t i = 1; i + 1 < way.size(); ++i) pass(way[i], speed, Corner::cut);
    return work(to, speed, corner);
  }

  /// Begins to note the legs of a piece.
  void mark() { piece_ = {{{at_, leg_m_}}}; }
  const PieceLegs& since_mark() const { return piece_; }
  std::optional<double> blocked_leg_m() const { return blocked_leg_m_; }

 private:
  std::optional<Length> begins() const { return leg_m_ > 0.0 ? std::nullopt : begins_; }

  /// A way point, unless an obstacle has come up there.
  void pass(FieldPoint at, Speed speed, Corner corner) {
    if (!around_.is_too_near(at)) work(at, speed, corner);
  }

  std::optional<std::vector<FieldPoint>> ferry_bends(FieldPoint from, FieldPoint to) {
    auto found = around_.ferry_bends(from, to);
    if (!found) return std::nullopt;
    route_.leaves_land = route_.leaves_land || found->leaves_land;
    return std::move(found->bends);
  }

  bool is_clear(const std::vector<FieldPoint>& way) const {
    return std::adjacent_find(way.begin(), way.end(), [this](FieldPoint a, FieldPoint b) {
             return around_.clear_m(a, b).has_value();
           }) == way.end();
  }

  // The way in plan of a ferry, around what was seen.
  std::vector<FieldPoint> led_around(const std::vector<FieldPoint>& way) {
    std::vector<FieldPoint> led{way.front()};
    double leg_m = leg_m_;
    const auto go_on = [&](FieldPoint to) {
      leg_m += distance(led.back(), to).base();
      led.push_back(to);
    };
    for (std::size_t i = 1; i < way.size(); ++i) {
      if (i + 1 < way.size() && around_.is_too_near(way[i])) continue;
      const auto bends = ferry_bends(led.back(), way[i]);
      if (!bends) block(leg_m, led.back(), way[i]);
      for (const FieldPoint bend : bends.value_or(std::vector<FieldPoint>{})) go_on(bend);
      go_on(way[i]);
    }
    return led;
  }

  // Only the first place counts.
  void block(double leg_m, FieldPoint from, FieldPoint to) {
    if (blocked_leg_m_) return;
    blocked_leg_m_ =
        leg_m + std::max(0.0, around_.clear_m(from, to).value_or(0.0) - blocked_room_m);
  }

  double bent(const std::optional<std::vector<FieldPoint>>& bends, FieldPoint to, Speed speed,
              Corner corner) {
    if (!bends) block(leg_m_, at_, to);
    for (const FieldPoint at : bends.value_or(std::vector<FieldPoint>{})) bend(at, speed);
    return level_or_over(to, speed, corner);
  }

  void bend(FieldPoint at, Speed speed) {
    level_or_over(at, speed, Corner::held);
    if (!piece_.first_bend_m) piece_.first_bend_m = leg_m_;
    piece_.last_bend_m = leg_m_;
    piece_.corners.push_back({at, leg_m_});
  }

  // Of one way around, from leg to leg.
  void close(double from_m, double to_m) {
    if (!piece_.closed.empty() && piece_.closed.back().to_m == from_m) {
      piece_.closed.back().to_m = to_m;
    } else {
      piece_.closed.push_back({from_m, to_m});
    }
  }

  double level_or_over(FieldPoint to, Speed speed, Corner corner) {
    if (relief_ == nullptr) return straight(to, speed.base(), corner);
    return over(relief_->contour(at_, to, speed), corner);
  }

  // No corner is cut that an obstacle is near to.
  double straight(FieldPoint to, double limit_mps, Corner corner) {
    const bool is_near = around_.is_within(to, 0.5 * vehicle_.swath);
    at_ = to;
    return leg_m_ = route_.path.add(xy_m(to), limit_mps,
                                    is_near ? std::max(corner, Corner::held) : corner);
  }

  // Pieces of one speed in a row are one leg.
  double over(const planner::AirWay& air, Corner corner, Corner within = Corner::cut) {
    route_.heights.mark(leg_m_, air.altitude_m);
    for (std::size_t i = 0; i < air.legs.size(); ++i) {
      const planner::AirLeg& leg = air.legs[i];
      const bool is_last = i + 1 == air.legs.size();
      const bool goes_on = !is_last && !leg.bends && air.legs[i + 1].limit_mps == leg.limit_mps;
      if (goes_on) {
        route_.heights.mark(leg_m_ + distance(at_, leg.to).base(), leg.altitude_m);
      } else {
        straight(leg.to, leg.limit_mps, is_last ? corner : within);
        route_.heights.mark(leg_m_, leg.altitude_m);
      }
    }
    return leg_m_;
  }

  SortieRoute& route_;
  const Vehicle& vehicle_;
  const planner::FerryMap& ferries_;
  const planner::Relief* relief_;
  const Surroundings& around_;
  std::optional<Length> begins_;
  FieldPoint at_;
  double leg_m_ = 0.0;
  std::optional<double> blocked_leg_m_{};
  PieceLegs piece_{};
};

// Moves what was known along the legs to the path, now that its corners are cut.
void settle(SortieRoute& route) {
  const auto settled = [&](double leg_m) { return route.path.along_m(leg_m); };
  for (PieceOnPath& p : route.pieces) {
    p.open_m = settled(p.open_m);
    p.close_m = settled(p.close_m);
    p.from_m = settled(p.from_leg_m);
    p.bends_from_m = settled(p.bends_from_m);
    p.bends_to_m = settled(p.bends_to_m);
    for (double& abeam_m : p.abeam_m) abeam_m = settled(abeam_m);
    for (PieceOnPath::Closed& c : p.closed) c = {settled(c.from_m), settled(c.to_m)};
    route.spray_m += p.sprayed_m(p.open_m, p.close_m);
  }
}

// A piece that an obstacle stands on the end of, or near it, up to there. Where nothing is left it
// stays. `from` is where its straight line begins, unless a step leads to that.
Piece clear_line(Piece piece, FieldPoint from, const Surroundings& around, Length swath) {
  const auto part = around.clear_part(from, piece.exit, swath);
  if (!part || (part->from == from && part->to == piece.exit)) return piece;
  const Xy begin = xy_m(part->from), way = xy_m(part->to) - begin;
  const auto within = [&](FieldPoint p) {
    const double share = dot(xy_m(p) - begin, way) / dot(way, way);
    return share <= 0.0 ? part->from : share >= 1.0 ? part->to : p;
  };
  piece.from = within(piece.from);
  piece.to = within(piece.to);
  if (piece.entry == from) piece.entry = part->from;
  piece.exit = part->to;
  return piece;
}

Piece clear_part(const Piece& piece, const Surroundings& around, Length swath) {
  const bool begins_with_step =
      piece.exit == piece.to && !(piece.entry == piece.from) && !(piece.from == piece.to);
  if (!begins_with_step) return clear_line(piece, piece.entry, around, swath);
  Piece part = clear_line(piece, piece.from, around, swath);
  const bool leads_on = !around.is_too_near(part.entry) &&
                        around.strip_bends(part.entry, part.from, swath).has_value();
  if (!leads_on) part.entry = part.from;
  return part;
}

double work_end_m(const SortieRoute& route, std::size_t piece) {
  const PieceOnPath& p = route.pieces[piece];
  return p.has_tail() ? p.close_m : route.cell_m(piece, p.piece.cells.count - 1);
}

void note_ways(SortieRoute& route, Length swath) {
  const std::size_t home = route.pieces.size();
  for (std::size_t i = 0; i <= home; ++i) {
    const bool is_way = i == 0 || i == home ||
                        planner::are_apart(route.pieces[i - 1].piece, route.pieces[i].piece, swath);
    if (!is_way) continue;
    route.ways.push_back({i, i == 0 ? 0.0 : work_end_m(route, i - 1),
                          i == home ? route.path.length_m() : route.pieces[i].open_m});
  }
}

// Takes note of the way around obstacles, if there is one.
void bend(PieceOnPath& piece, const PieceLegs& legs, bool is_shorter) {
  if (!legs.first_bend_m && !is_shorter) return;
  piece.abeam_m = abeam_leg_m(piece.piece, legs.corners);
  if (!legs.first_bend_m) return;
  piece.bends_from_m = *legs.first_bend_m;
  piece.bends_to_m = *legs.last_bend_m;
  piece.closed = legs.closed;
}

}  // namespace

bool PieceOnPath::is_sprayed(double along_m) const {
  return along_m >= open_m && along_m < close_m &&
         std::none_of(closed.begin(), closed.end(), [along_m](const Closed& c) {
           return along_m >= c.from_m && along_m < c.to_m;
         });
}

double PieceOnPath::sprayed_m(double begin_m, double end_m) const {
  const auto length_m = [&](double low_m, double high_m) {
    return std::max(0.0, std::min(end_m, high_m) - std::max(begin_m, low_m));
  };
  double sum_m = length_m(open_m, close_m);
  for (const Closed& c : closed) sum_m -= length_m(c.from_m, c.to_m);
  return sum_m;
}

double PieceOnPath::valve_moves_m(double begin_m, double end_m) const {
  double last_m = -1.0;
  const auto note = [&](double at_m) {
    if (at_m > begin_m && at_m <= end_m) last_m = std::max(last_m, at_m);
  };
  note(open_m);
  note(close_m);
  for (const Closed& c : closed) {
    note(c.from_m);
    note(c.to_m);
  }
  return last_m < 0.0 ? end_m : last_m;
}

double SortieRoute::cell_m(std::size_t piece, std::uint32_t index) const {
  const PieceOnPath& p = pieces[piece];
  if (p.is_bent()) return p.abeam_m[index];
  return path.along_m(p.from_leg_m + index * p.spacing_m);
}

SortieRoute sortie_route(Xy from_m, std::span<const Piece> pieces, Xy to_m, const Vehicle& v,
                         const planner::FerryMap& ferries, const Surroundings& around,
                         std::optional<Length> begins) {
  SortieRoute route{.path = Path{from_m,
                                 {.acceleration_mps2 = planned_acceleration_mps2(v),
                                  .corner_cut_m = 0.5 * v.swath.base(),
                                  .min_radius_m = v.min_turn_radius.base()}},
                    .pieces = {},
                    .spray_m = 0.0};
  Laying lay{route, from_m, v, ferries, around, begins};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& whole = pieces[i];
    const Piece piece = clear_part(whole, around, v.swath);
    const bool to_its_end = !(whole.exit == whole.to);
    const auto meets = [](const Piece& before, const Piece& after) {
      return norm(xy_m(after.entry) - xy_m(before.exit)) < same_place_m;
    };
    const bool continues = i > 0 && meets(pieces[i - 1], whole);
    const bool goes_on = i + 1 < pieces.size() && meets(whole, pieces[i + 1]);
    const auto corner = [&](bool open) {
      return !to_its_end ? Corner::cut : open ? Corner::held : Corner::stop;
    };
    const Speed speed = continues ? v.spray_speed : v.ferry_speed;
    const double open = i == 0 ? lay.ferry(piece.entry, corner(false))
                               : lay.approach(piece, speed, corner(continues));
    lay.mark();
    double from = 0.0, close = 0.0;
    if (!to_its_end) {
      from = lay.spray(piece.from);
      close = lay.spray(piece.to);
    } else {  // one straight leg
      from = open + distance(piece.entry, piece.from).base();
      close = lay.spray(piece.exit, corner(goes_on));
    }
    route.pieces.push_back({whole, open, close, from, spacing(whole), 0.0});
    const bool is_shorter = !(piece.entry == whole.entry && piece.exit == whole.exit);
    bend(route.pieces.back(), lay.since_mark(), is_shorter);
  }
  lay.ferry(field_point(to_m));
  route.path.finish();
  route.heights.move([&](double leg_m) { return route.path.along_m(leg_m); });
  settle(route);
  note_ways(route, v.swath);
  if (lay.blocked_leg_m()) route.blocked_m = route.path.along_m(*lay.blocked_leg_m());
  return route;
}

void lift_ferries(SortieRoute& route, Length layer, Length begins, const Vehicle& v,
                  const planner::HeightRule& rule) {
  const double up = rule.climb / v.ferry_speed, down = rule.descent / v.ferry_speed;
  double begins_m = begins.base();
  for (const Way& way : route.ways) {
    const double from_m = way.to_piece == 0 ? 0.0 : route.pieces[way.to_piece - 1].close_m;
    route.heights.mark_hop(from_m, way.ends_m, begins_m, layer.base(), up, down);
    begins_m = 0.0;
  }
}

double ferry_pack_m(FieldPoint from, FieldPoint to, const Vehicle& v,
                    const planner::FerryMap& ferries) {
  const planner::Relief* relief = ferries.relief();
  if (relief == nullptr) return ferries.length(from, to).base();
  const auto air = relief->ferry(ferries.ferry_way(from, to, v), v);
  return relief->cost(from, air).energy_s * v.ferry_speed.base();
}

double straight_way_s(double length_m, const Vehicle& v) {
  const double speed = v.ferry_speed.base();
  return length_m / speed + speed / planned_acceleration_mps2(v);
}

}  // namespace furrow::agents
