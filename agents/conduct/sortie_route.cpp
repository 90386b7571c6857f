#include "agents/conduct/sortie_route.hpp"

#include "agents/aircraft.hpp"

namespace furrow::agents {
namespace {

constexpr double same_place_m = 1e-6;

double spacing(const Piece& piece) {
  return piece.cells.count < 2 ? 0.0
                               : distance(piece.from, piece.to).base() / (piece.cells.count - 1);
}

// Lays the legs of a route, over terrain with heights.
class Laying {
 public:
  Laying(SortieRoute& route, Xy from_m, const Vehicle& vehicle, const planner::FerryMap& ferries)
      : route_{route}, vehicle_{vehicle}, ferries_{ferries}, at_{field_point(from_m)} {}

  /// Each returns where along the legs it ends [m].
  double work(FieldPoint to, Speed speed, Corner corner = Corner::cut) {
    const planner::Relief* relief = ferries_.relief();
    if (relief == nullptr) return straight(to, speed.base(), corner);
    return over(relief->contour(at_, to, speed), corner);
  }
  double ferry(FieldPoint to, Corner corner = Corner::cut) {
    const Speed speed = vehicle_.ferry_speed;
    if (const planner::Relief* relief = ferries_.relief()) {
      return over(ferries_.air_way(at_, to, speed, relief->layer_of(vehicle_.id)), corner);
    }
    const std::vector<FieldPoint> way = ferries_.way(at_, to);
    for (std::size_t i = 1; i + 1 < way.size(); ++i) straight(way[i], speed.base(), Corner::cut);
    return straight(to, speed.base(), corner);
  }

 private:
  double straight(FieldPoint to, double limit_mps, Corner corner) {
    at_ = to;
    return leg_m_ = route_.path.add(xy_m(to), limit_mps, corner);
  }

  // Pieces of one speed in a row are one leg.
  double over(const planner::AirWay& air, Corner corner) {
    route_.heights.mark(leg_m_, air.altitude_m);
    for (std::size_t i = 0; i < air.legs.size(); ++i) {
      const planner::AirLeg& leg = air.legs[i];
      const bool is_last = i + 1 == air.legs.size();
      const bool goes_on = !is_last && !leg.bends && air.legs[i + 1].limit_mps == leg.limit_mps;
      if (goes_on) {
        route_.heights.mark(leg_m_ + distance(at_, leg.to).base(), leg.altitude_m);
      } else {
        straight(leg.to, leg.limit_mps, is_last ? corner : Corner::cut);
        route_.heights.mark(leg_m_, leg.altitude_m);
      }
    }
    return leg_m_;
  }

  SortieRoute& route_;
  const Vehicle& vehicle_;
  const planner::FerryMap& ferries_;
  FieldPoint at_;
  double leg_m_ = 0.0;
};

}  // namespace

double SortieRoute::cell_m(std::size_t piece, std::uint32_t index) const {
  const PieceOnPath& p = pieces[piece];
  return path.along_m(p.from_leg_m + index * p.spacing_m);
}

SortieRoute sortie_route(Xy from_m, std::span<const Piece> pieces, Xy to_m, const Vehicle& v,
                         const planner::FerryMap& ferries) {
  SortieRoute route{.path = Path{from_m,
                                 {.acceleration_mps2 = planned_acceleration_mps2(v),
                                  .corner_cut_m = 0.5 * v.swath.base(),
                                  .min_radius_m = v.min_turn_radius.base()}},
                    .pieces = {},
                    .spray_m = 0.0};
  Laying lay{route, from_m, v, ferries};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    const bool to_its_end = !(piece.exit == piece.to);
    const auto meets = [](const Piece& before, const Piece& after) {
      return norm(xy_m(after.entry) - xy_m(before.exit)) < same_place_m;
    };
    const bool continues = i > 0 && meets(pieces[i - 1], piece);
    const bool goes_on = i + 1 < pieces.size() && meets(piece, pieces[i + 1]);
    const auto corner = [&](bool open) {
      return !to_its_end ? Corner::cut : open ? Corner::held : Corner::stop;
    };
    if (i > 0) {
      for (const FieldPoint at : piece.approach) lay.work(at, v.ferry_speed, Corner::held);
    }
    const Speed speed = continues ? v.spray_speed : v.ferry_speed;
    const double open = i == 0 ? lay.ferry(piece.entry, corner(false))
                               : lay.work(piece.entry, speed, corner(continues));
    if (!to_its_end) {
      const double from = lay.work(piece.from, v.spray_speed);
      const double close = lay.work(piece.to, v.spray_speed);
      route.pieces.push_back({piece, open, close, from, spacing(piece), 0.0});
    } else {  // one straight leg
      const double from = open + distance(piece.entry, piece.from).base();
      const double close = lay.work(piece.exit, v.spray_speed, corner(goes_on));
      route.pieces.push_back({piece, open, close, from, spacing(piece), 0.0});
    }
  }
  lay.ferry(field_point(to_m));
  route.path.finish();
  route.heights.move([&](double leg_m) { return route.path.along_m(leg_m); });
  for (PieceOnPath& p : route.pieces) {  // known only now that corners are cut
    p.open_m = route.path.along_m(p.open_m);
    p.close_m = route.path.along_m(p.close_m);
    p.from_m = route.path.along_m(p.from_leg_m);
    route.spray_m += p.close_m - p.open_m;
  }
  return route;
}

double ferry_pack_m(FieldPoint from, FieldPoint to, const Vehicle& v,
                    const planner::FerryMap& ferries) {
  const planner::Relief* relief = ferries.relief();
  if (relief == nullptr) return ferries.length(from, to).base();
  const auto air = ferries.air_way(from, to, v.ferry_speed, relief->layer_of(v.id));
  return relief->cost(from, air).energy_s * v.ferry_speed.base();
}

double straight_way_s(double length_m, const Vehicle& v) {
  const double speed = v.ferry_speed.base();
  return length_m / speed + speed / planned_acceleration_mps2(v);
}

}  // namespace furrow::agents
