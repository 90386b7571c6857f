#include "planner/fleet/strip_path.hpp"

#include "core/require.hpp"

#include <algorithm>
#include <cmath>

namespace furrow::planner::fleet {

StripPath::StripPath(const std::vector<StraightStrip>& strips, double cut_m) : cut_m_{cut_m} {
  require(!strips.empty(), "a path has strips");
  double at_m = 0.0, hops_m = 0.0;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const auto& [begin, end, hop_m] = strips[i];
    const double length_m = distance(begin, end).base();
    require(length_m > 0.0, "a strip is longer than zero");
    if (i > 0) hops_m += hop_m.value_or(distance(strips[i - 1].end, begin).base());
    strips_.push_back({begin.x.base(), begin.y.base(), (end.x - begin.x).base() / length_m,
                       (end.y - begin.y).base() / length_m});
    begins_m_.push_back(at_m);
    hops_m_.push_back(hops_m);
    at_m += length_m;
  }
  begins_m_.push_back(at_m);
  first_.resize(strips_.size());
  std::uint32_t strip = 0;
  for (std::size_t i = 0; i < first_.size(); ++i) {
    while (strip + 1 < strips_.size() && stretch_of(begins_m_[strip + 1]) < i) ++strip;
    first_[i] = strip;
  }
}

// Which part of the path a position lies in; rises with it.
std::size_t StripPath::stretch_of(double at_m) const {
  const double number = at_m / begins_m_.back() * static_cast<double>(first_.size());
  return static_cast<std::size_t>(std::clamp(number, 0.0, static_cast<double>(first_.size() - 1)));
}

std::uint32_t StripPath::strip_from(double at_m) const {
  std::uint32_t s = first_[stretch_of(at_m)];
  while (s + 1 < strips() && begins_m_[s + 1] <= at_m) ++s;
  return s;
}

std::uint32_t StripPath::strip_to(double at_m) const {
  std::uint32_t s = first_[stretch_of(at_m)];
  while (s + 1 < strips() && begins_m_[s + 1] < at_m) ++s;
  return s;
}

StripPath StripPath::part(double from_m, double to_m) const {
  std::vector<StraightStrip> strips;
  const std::uint32_t first = strip_from(from_m), last = strip_to(to_m);
  strips.reserve(last - first + 1);
  for (std::uint32_t s = first; s <= last; ++s) {
    strips.push_back({point(s, std::max(from_m, begins_m_[s])),
                      point(s, std::min(to_m, begins_m_[s + 1])),
                      s > first ? hops_m_[s] - hops_m_[s - 1] : 0.0});
  }
  return StripPath{strips, cut_m_};
}

FieldPoint StripPath::point(std::uint32_t strip, double at_m) const {
  const Line& line = strips_[strip];
  const double along_m = at_m - begins_m_[strip];
  return furrow::at_m(line.x_m + along_m * line.along_x, line.y_m + along_m * line.along_y);
}

double StripPath::away_m(FieldPoint place, std::uint32_t strip, double at_m) const {
  const Line& line = strips_[strip];
  const double along_m = at_m - begins_m_[strip];
  const double x_m = line.x_m + along_m * line.along_x - place.x.base();
  const double y_m = line.y_m + along_m * line.along_y - place.y.base();
  return std::max(0.0, std::sqrt(x_m * x_m + y_m * y_m) - cut_m_);
}

}  // namespace furrow::planner::fleet
