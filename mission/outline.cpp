#include "mission/outline.hpp"

#include "exchange/land.hpp"
#include "mission/place.hpp"
#include "mission/polygon.hpp"
#include "planner/coverage/mend.hpp"

#include <fmt/format.h>

#include <cmath>

namespace furrow::mission {
namespace {

constexpr const char* land_file = "file";

std::string key_of(const planner::SoundField::Remark& remark, bool is_file) {
  if (is_file) return land_file;
  return remark.hole ? fmt::format("holes_m[{}]", *remark.hole) : "boundary_m";
}

// Puts holes apart, and says what that took. A file's name is told beside its own faults.
void settle(const Section& s, const std::string& file, Scenario& out) {
  const bool is_file = !file.empty();
  const std::string in_file = is_file ? " in " + file : "";
  auto sound = planner::sound_field(out.field);
  if (!sound) {
    const auto& error = sound.error();
    const bool is_bare = error.fault == planner::PlanFault::nothing_to_spray;
    s.fail(is_file   ? land_file
           : is_bare ? "holes_m"
                     : "boundary_m",
           is_bare ? "must leave some of the land" : "must be rings that do not cross themselves",
           fmt::format("{}{}{}", error.detail, error.at ? ": " + place(*error.at, out.datum) : "",
                       in_file));
    return;
  }
  for (const auto& remark : sound->remarks) {
    const std::string which = remark.hole ? fmt::format("hole {}", *remark.hole + 1) : "the land";
    s.warn(key_of(remark, is_file),
           fmt::format("{} {}, at {}{}", which, remark.what, place(remark.at, out.datum), in_file));
  }
  out.field = std::move(sound->field);
}

void compare_with_stated(const Section& s, const std::string& file, const Scenario& out) {
  constexpr double same = 1e-3;
  const Area land = area(out.field);
  const double off = land / *out.stated_area - 1;
  if (std::abs(off) <= same) return;
  const auto both_units = [](Area a) {
    return fmt::format("{:.1f} m2 ({:.4f} ha)", a.base(), a / hectares(1));
  };
  s.warn(land_file,
         fmt::format("{} states {}, its land within the boundary and outside the holes has {}, "
                     "{:+.2f} %",
                     file, both_units(*out.stated_area), both_units(land), 100 * off));
}

void read_land(const Section& s, const std::string& file, std::optional<std::size_t> feature,
               Scenario& out) {
  const std::string rule = "must be left out where file is given";
  for (const char* key : {"boundary_m", "holes_m", "datum"}) s.refuse(key, rule);
  auto land = exchange::read_land(s.findings().beside(file), feature);
  if (!land) {
    s.fail(land_file, land.error().rule, fmt::format("{} in {}", land.error().value, file));
    return;
  }
  out.field = std::move(land->field);
  out.datum = land->datum;
  settle(s, file, out);
  out.stated_area = land->stated_area;
  if (out.stated_area) compare_with_stated(s, file, out);
}

// Rings written down by hand, each a sound polygon by itself.
void read_rings(const Section& s, Scenario& out) {
  out.field.boundary = s.ring("boundary_m");
  out.field.holes = s.rings("holes_m");
  bool is_sound = !out.field.boundary.empty();
  const auto judge = [&](const Ring& ring, const std::string& key) {
    const auto fault = ring.empty() ? std::nullopt : ring_fault(ring);
    if (fault) s.fail(key, *fault);
    is_sound = is_sound && !fault && !ring.empty();
  };
  judge(out.field.boundary, "boundary_m");
  for (std::size_t i = 0; i < out.field.holes.size(); ++i) {
    judge(out.field.holes[i], fmt::format("holes_m[{}]", i));
  }
  if (is_sound) settle(s, {}, out);
}

std::optional<exchange::Datum> read_datum(const Section& s) {
  const Section datum = s.section("datum");
  const auto lat = datum.optional_number("lat_deg", from_to(-85, 85), "no place on the globe");
  const auto lon = datum.optional_number("lon_deg", from_to(-180, 180), "no place on the globe");
  if (datum.has("lat_deg") != datum.has("lon_deg")) {
    s.fail("datum", "must have both lat_deg and lon_deg");
  }
  if (lat && lon) return exchange::Datum{.lat_deg = *lat, .lon_deg = *lon};
  return std::nullopt;
}

}  // namespace

void read_outline(const Section& field, Scenario& out) {
  const auto file = field.optional_text(land_file, "boundary_m");
  const auto feature = field.optional_whole("feature", 0, 1'000'000, "the only polygon");
  if (file) return read_land(field, *file, feature, out);
  if (field.has("feature")) field.fail("feature", "must be left out where no file is given");
  out.datum = read_datum(field);
  read_rings(field, out);
}

}  // namespace furrow::mission
