#include "transport/recorder.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace furrow::transport {
namespace {

constexpr std::chrono::milliseconds between_questions{20};

bool is_due(std::chrono::steady_clock::time_point& last) {
  const auto now = std::chrono::steady_clock::now();
  if (now - last < between_questions) return false;
  last = now;
  return true;
}

}  // namespace

bool is_earlier(const Envelope& a, const Envelope& b) {
  return std::tie(a.sent, a.from, a.seq) < std::tie(b.sent, b.from, b.seq);
}

void Recorder::keep(Envelope envelope) {
  if (settings_.observer) settings_.observer(envelope);
  log_.push_back(std::move(envelope));
}

std::vector<Envelope> Recorder::own_words(Instant now) {
  std::vector<Envelope> words;
  if (!settings_.says) return words;
  for (Body& body : settings_.says()) {
    words.push_back({director_node(), ++said_, now, std::move(body)});
  }
  return words;
}

DirectorResult Recorder::result(Ending ending, Instant end, const std::set<std::uint32_t>& died,
                                std::uint64_t rounds, std::uint64_t malformed) && {
  std::sort(log_.begin(), log_.end(), is_earlier);
  std::erase_if(log_, [&](const Envelope& e) { return e.sent > end; });
  return {.log = std::move(log_),
          .end = end,
          .ending = ending,
          .died = {died.begin(), died.end()},
          .rounds = rounds,
          .malformed_messages = malformed};
}

std::vector<std::uint32_t> Watch::new_deaths() {
  std::vector<std::uint32_t> found;
  if (!is_due(asked_dead_)) return found;
  std::vector<std::uint32_t> dead;
  if (settings_.dead_members) dead = settings_.dead_members();
  for (const std::uint32_t participant : incoming_.lost()) dead.push_back(participant);
  for (const std::uint32_t participant : dead) {
    const bool is_ours =
        std::any_of(settings_.members.begin(), settings_.members.end(),
                    [&](const MemberPlan& m) { return m.participant == participant; });
    if (is_ours && died_.insert(participant).second) found.push_back(participant);
  }
  return found;
}

bool Watch::is_interrupted() {
  return settings_.interrupted && is_due(asked_interrupt_) && settings_.interrupted();
}

std::string text(const MemberPlan& member) {
  std::string nodes;
  for (std::size_t i = 0; i < std::min<std::size_t>(member.nodes.size(), 2); ++i) {
    nodes += (i == 0 ? "" : ", ") + text(member.nodes[i]);
  }
  if (member.nodes.size() > 2) nodes += ", ...";
  return "participant " + std::to_string(member.participant) + " (" + nodes + ")";
}

}  // namespace furrow::transport
