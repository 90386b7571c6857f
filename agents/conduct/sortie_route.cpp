#include "agents/conduct/sortie_route.hpp"

#include "agents/aircraft.hpp"

namespace furrow::agents {
namespace {

constexpr double same_place_m = 1e-6;

double spacing(const Piece& piece) {
  return piece.cells.count < 2 ? 0.0
                               : distance(piece.from, piece.to).base() / (piece.cells.count - 1);
}

}  // namespace

double SortieRoute::cell_m(std::size_t piece, std::uint32_t index) const {
  const PieceOnPath& p = pieces[piece];
  return path.along_m(p.from_leg_m + index * p.spacing_m);
}

SortieRoute sortie_route(Xy from_m, std::span<const Piece> pieces, Xy to_m, const Vehicle& v,
                         const planner::FerryMap& ferries) {
  const double ferry = v.ferry_speed.base(), spray = v.spray_speed.base();
  SortieRoute route{.path = Path{from_m,
                                 {.acceleration_mps2 = planned_acceleration_mps2(v),
                                  .corner_cut_m = 0.5 * v.swath.base(),
                                  .min_radius_m = v.min_turn_radius.base()}},
                    .pieces = {},
                    .spray_m = 0.0};
  const auto ferry_to = [&](FieldPoint from, FieldPoint to) {
    const std::vector<FieldPoint> way = ferries.way(from, to);
    for (std::size_t i = 1; i + 1 < way.size(); ++i) route.path.add(xy_m(way[i]), ferry);
  };
  if (!pieces.empty()) ferry_to(field_point(from_m), pieces.front().entry);
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
      for (const FieldPoint at : piece.approach) route.path.add(xy_m(at), ferry, Corner::held);
    }
    const double open =
        route.path.add(xy_m(piece.entry), continues ? spray : ferry, corner(continues));
    if (!to_its_end) {
      const double from = route.path.add(xy_m(piece.from), spray);
      const double close = route.path.add(xy_m(piece.to), spray);
      route.pieces.push_back({piece, open, close, from, spacing(piece), 0.0});
    } else {  // one straight leg
      const double from = open + distance(piece.entry, piece.from).base();
      const double close = route.path.add(xy_m(piece.exit), spray, corner(goes_on));
      route.pieces.push_back({piece, open, close, from, spacing(piece), 0.0});
    }
  }
  ferry_to(pieces.empty() ? field_point(from_m) : pieces.back().exit, field_point(to_m));
  route.path.add(to_m, ferry);
  route.path.finish();
  for (PieceOnPath& p : route.pieces) {  // known only now that corners are cut
    p.open_m = route.path.along_m(p.open_m);
    p.close_m = route.path.along_m(p.close_m);
    p.from_m = route.path.along_m(p.from_leg_m);
    route.spray_m += p.close_m - p.open_m;
  }
  return route;
}

double straight_way_s(double length_m, const Vehicle& v) {
  const double speed = v.ferry_speed.base();
  return length_m / speed + speed / planned_acceleration_mps2(v);
}

}  // namespace furrow::agents
