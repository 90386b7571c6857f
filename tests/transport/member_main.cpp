// A process of the toy fleet, for the tests of the transport and its benchmark.
//
// transport_member DOMAIN RUN PARTICIPANT AGENTS STATIONS SECONDS EPOCH_NS FROM TO
// hosts the nodes FROM .. TO - 1 of the fleet's list; EPOCH_NS 0 is granted time. PARTICIPANT 0 is
// the director of such a fleet with one agent in each process.

#include "toy_run.hpp"
#include "transport/member.hpp"

#include <cstdlib>
#include <string>

int main(int argc, char** argv) {
  using namespace furrow;
  if (argc != 10) return 2;
  const auto number_at = [&](int i) { return std::strtoll(argv[i], nullptr, 10); };
  const auto count_at = [&](int i) { return static_cast<std::uint32_t>(number_at(i)); };

  const toy::Fleet fleet{
      .agents = count_at(4), .stations = count_at(5), .seconds = static_cast<int>(number_at(6))};
  const std::int64_t epoch_ns = number_at(7);
  if (count_at(3) == transport::director_participant) {
    const toy::Run run{.fleet = fleet, .domain = count_at(1), .name = argv[2]};
    return transport::run_director({.network = toy::network(run),
                                    .members = toy::plans(run),
                                    .latency = toy::bad_radio.latency})
               ? 0
               : 1;
  }
  const bool wall = epoch_ns != 0;
  const Link at_once{.latency = Duration{1}, .jitter = {}, .loss = 0, .duplication = 0};

  transport::MemberSettings settings{
      .network = {.domain = count_at(1), .run = argv[2], .stations = fleet.stations},
      .participant = count_at(3),
      .nodes = {}};
  NodeHost host{wall ? at_once : toy::bad_radio, fleet.seed};
  const Instant first = wall ? std::max(Instant{}, transport::mission_now(epoch_ns)) : Instant{};
  const auto all = toy::nodes(fleet);
  for (auto i = count_at(8); i < count_at(9) && i < all.size(); ++i) {
    settings.nodes.push_back(all[i]);
    toy::add(host, fleet, all[i], first);
  }
  if (wall) settings.epoch_realtime_ns = epoch_ns;
  return transport::run_member(settings, std::move(host));
}
