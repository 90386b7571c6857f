#include "sim/checkers/laws.hpp"

#include <fmt/format.h>
#include <set>
#include <type_traits>

namespace furrow::sim {
namespace {

// Every node that a message names, as sender or within.
template <class Visit>
void visit_names(const Envelope& e, const Visit& visit) {
  visit(e.from);
  std::visit(
      [&](const auto& body) {
        constexpr bool is_order = std::is_same_v<std::decay_t<decltype(body)>, OperatorOrder>;
        if constexpr (!is_order && requires { body.agent; }) visit(node(body.agent));
      },
      e.body);
  if (const auto* claim = std::get_if<ServiceClaim>(&e.body)) visit(node(claim->station));
  if (const auto* grant = std::get_if<ServiceGrant>(&e.body)) visit(node(grant->station));
  if (const auto* state = std::get_if<StationState>(&e.body)) visit(node(state->station));
}

class SenderLaws final : public Checker {
 public:
  explicit SenderLaws(const Facts& facts) {
    known_ = {scheduler_node(), director_node()};
    for (const Station& station : facts.stations) known_.insert(node(station.id));
    for (const auto& uav : facts.plan.uavs) known_.insert(node(uav.vehicle.id));
  }

  void observe(const Envelope& e) override {
    visit_names(e, [&](NodeId id) {
      if (known_.contains(id) || !told_.insert(id).second) return;
      report("L21", e.sent,
             fmt::format("unknown sender: {} is not of this fleet ({} of {})", text(id),
                         topic(e.body), text(e.from)));
    });
  }

  void conclude(Instant) override {}

 private:
  std::set<NodeId> known_, told_;
};

}  // namespace

std::unique_ptr<Checker> sender_laws(const Facts& facts) {
  return std::make_unique<SenderLaws>(facts);
}

}  // namespace furrow::sim
