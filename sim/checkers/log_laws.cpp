#include "sim/checkers/laws.hpp"

#include <fmt/format.h>
#include <map>
#include <tuple>

namespace furrow::sim {
namespace {

class LogLaws final : public Checker {
 public:
  void observe(const Envelope& e) override {
    if (std::tie(e.sent, e.from, e.seq) <= std::tie(last_sent_, last_from_, last_seq_)) {
      report("L17", e.sent, fmt::format("{} message {} is out of order", text(e.from), e.seq));
    }
    std::tie(last_sent_, last_from_, last_seq_) = std::tie(e.sent, e.from, e.seq);

    std::uint64_t& seq = seq_[e.from];
    if (e.seq != seq + 1) {
      report("L17", e.sent,
             fmt::format("{} message {} follows message {}", text(e.from), e.seq, seq));
    }
    seq = e.seq;
  }

  void conclude(Instant) override {}

 private:
  Instant last_sent_ = Instant::min();
  NodeId last_from_{};
  std::uint64_t last_seq_ = 0;
  std::map<NodeId, std::uint64_t> seq_;
};

}  // namespace

std::unique_ptr<Checker> log_laws(const Facts&) { return std::make_unique<LogLaws>(); }

}  // namespace furrow::sim
