#include "app/exports/sortie_tracks.hpp"

#include "planner/routes/drawn.hpp"
#include "scheduler/orders.hpp"

namespace furrow::app {
namespace {

using planner::WayPoint;

constexpr double altitude_m = 3.0;  // above the crop, as plant-protection UAVs fly
constexpr double drawn_m = 0.25;    // heights are drawn by so few points that they are so far off

// The places of a sortie; over terrain also those between them where the height bends.
class Places {
 public:
  Places(const planner::FerryMap& ferries, const Vehicle& vehicle, FieldPoint home, Length height)
      : ferries_{ferries},
        relief_{ferries.relief()},
        vehicle_{vehicle},
        home_ground_{ground_at(home)},
        height_{relief_ != nullptr ? relief_->rule().spray_height : height},
        at_{home} {}

  void ferry(FieldPoint to) {
    const auto way = ferries_.ferry_way(at_, to, vehicle_);
    if (relief_ != nullptr) return pass(relief_->ferry(way, vehicle_));
    for (std::size_t i = 1; i + 1 < way.size(); ++i) add(way[i], false);
  }

  void approach(const Piece& piece) {
    std::vector<FieldPoint> way{at_};
    way.insert(way.end(), piece.approach.begin(), piece.approach.end());
    way.push_back(piece.entry);
    const Speed speed = vehicle_.ferry_speed;
    if (relief_ != nullptr && !piece.approach_altitudes_m.empty()) {
      const auto& heights_m = piece.approach_altitudes_m;
      return pass(
          relief_->straight(relief_->way_at(at_, piece.approach, heights_m, piece.entry), speed));
    }
    if (relief_ != nullptr && planner::is_high(way)) return pass(relief_->ferry(way, vehicle_));
    for (std::size_t i = 1; i + 1 < way.size(); ++i) work(way[i], false);
    if (relief_ != nullptr) pass(relief_->contour(at_, piece.entry, speed));
  }

  // At the height of work, the valve as it is until there.
  void work(FieldPoint to, bool is_spraying, Length width = {}) {
    if (relief_ != nullptr) {
      pass(relief_->contour(at_, to, vehicle_.spray_speed));
    }
    add(to, is_spraying, width);
  }

  // A place is named once; what the valve does from it on is the last word on it.
  void add(FieldPoint at, bool is_spraying, Length width = {}) {
    const Length ground = ground_at(at) - home_ground_;
    add({at, is_spraying, width, ground + height_, ground});
  }

  exchange::SortieTrack track(FieldPoint home, FieldPoint landing) const {
    return {.uav = vehicle_.id,
            .sortie = 1,
            .home = home,
            .landing = landing,
            .points = points_,
            .take_off = height_,
            .landing_ground = ground_at(landing) - home_ground_,
            .spray_speed = vehicle_.spray_speed,
            .ferry_speed = vehicle_.ferry_speed};
  }

 private:
  Length ground_at(FieldPoint at) const {
    return relief_ != nullptr ? relief_->surface().height(at) : Length{};
  }

  void add(const exchange::TrackPoint& point) {
    if (!points_.empty() && points_.back().at == point.at) {
      points_.back() = point;
    } else {
      points_.push_back(point);
    }
    at_ = point.at;
  }

  // Between the ends of a way over terrain.
  void pass(const planner::AirWay& way) {
    std::vector<WayPoint> line{{at_.x.base(), at_.y.base(), way.altitude_m}};
    for (const planner::AirLeg& leg : way.legs) {
      line.push_back({leg.to.x.base(), leg.to.y.base(), leg.altitude_m});
    }
    const bool is_open = !points_.empty() && points_.back().is_spraying;
    const Length width = points_.empty() ? Length{} : points_.back().width;
    for (const WayPoint& p : planner::drawn(line, drawn_m)) {
      const FieldPoint at = at_m(p.x_m, p.y_m);
      add({at, is_open, is_open ? width : Length{}, metres(p.z_m) - home_ground_,
           ground_at(at) - home_ground_});
    }
  }

  const planner::FerryMap& ferries_;
  const planner::Relief* relief_;
  const Vehicle& vehicle_;
  Length home_ground_, height_;
  FieldPoint at_;
  std::vector<exchange::TrackPoint> points_{};
};

exchange::SortieTrack track(const SortieOrder& order, FieldPoint home, FieldPoint landing,
                            Places places) {
  bool is_first = true;
  for (const Piece& piece : order.pieces) {
    if (is_first) {
      places.ferry(piece.entry);
    } else {
      places.approach(piece);
    }
    is_first = false;
    places.add(piece.entry, true, piece.width);
    if (!(piece.from == piece.entry)) places.work(piece.from, true, piece.width);
    places.work(piece.to, true, piece.width);
    places.work(piece.exit, false);
  }
  places.ferry(landing);
  return places.track(home, landing);
}

}  // namespace

std::vector<exchange::SortieTrack> sortie_tracks(const scheduler::FleetPlan& plan,
                                                 std::optional<Length> survey_height) {
  const Length height = survey_height.value_or(metres(altitude_m));
  std::vector<exchange::SortieTrack> tracks;
  for (const scheduler::UavPlan& uav : plan.uavs) {
    std::uint32_t number = 0;
    FieldPoint home = uav.vehicle.home;
    for (const SortieOrder& order : scheduler::orders(plan.route, uav)) {
      const FieldPoint landing = scheduler::landing(uav, number).position;
      tracks.push_back(
          track(order, home, landing, Places{plan.route.ferries, uav.vehicle, home, height}));
      tracks.back().sortie = ++number;
      home = landing;  // from the second sortie on
    }
  }
  return tracks;
}

}  // namespace furrow::app
