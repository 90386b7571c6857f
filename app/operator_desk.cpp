#include "app/operator_desk.hpp"

#include "app/options.hpp"

#include <array>
#include <charconv>
#include <fmt/format.h>

namespace furrow::app {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds between_calls{20};
constexpr milliseconds until_repeated{500};

constexpr std::array asks{OperatorAsk::pause, OperatorAsk::resume, OperatorAsk::return_all,
                          OperatorAsk::stop, OperatorAsk::take_out};

std::optional<OperatorAsk> ask(std::string_view word) {
  for (const OperatorAsk one : asks) {
    if (name(one) == word) return one;
  }
  return std::nullopt;
}

// 0 where it is no number.
std::uint32_t uav_number(std::string_view text) {
  std::uint32_t value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc{} && read.ptr == text.data() + text.size() ? value : 0;
}

}  // namespace

Expected<OperatorOrder, std::string> operator_order(const std::string& line, std::uint32_t uavs) {
  const auto gap = line.find(' ');
  const std::string word = line.substr(0, gap);
  const std::string uav = gap == std::string::npos ? "" : line.substr(gap + 1);
  const auto asked = ask(word);
  if (!asked) {
    return Unexpected{
        fmt::format("order: must be pause, resume, return_all, stop or take_out (got {})", word)};
  }
  if (*asked != OperatorAsk::take_out) {
    if (uav.empty()) return OperatorOrder{.ask = *asked};
    return Unexpected{
        fmt::format("uav: must be left out of orders to the whole fleet (got {})", uav)};
  }
  const std::uint32_t number = uav_number(uav);
  if (number >= 1 && number <= uavs) return OperatorOrder{.ask = *asked, .agent = AgentId{number}};
  return Unexpected{fmt::format("uav: must be the number of a UAV of the mission, 1 to {} (got {})",
                                uavs, uav.empty() ? "none" : uav)};
}

OperatorDesk::~OperatorDesk() {
  for (const Waiting& w : waiting_) w.caller.answer({Exit::not_met, "the mission is over"});
}

void OperatorDesk::take_calls() {
  for (Caller& caller : line_.callers()) {
    auto order = operator_order(caller.said(), uavs_);
    if (!order) {
      caller.answer({Exit::bad_input, order.error()});
      continue;
    }
    order->number = ++orders_;
    waiting_.push_back({std::move(caller), *order});
  }
}

std::vector<Body> OperatorDesk::says() {
  const auto now = Clock::now();
  if (now - listened_ < between_calls) return {};
  listened_ = now;
  const bool had_none = waiting_.empty();
  take_calls();
  if (waiting_.empty() || (!had_none && now - said_ < until_repeated)) return {};
  said_ = now;
  return {waiting_.front().order};
}

void OperatorDesk::observe(const Envelope& envelope) {
  const auto* state = std::get_if<OperatorState>(&envelope.body);
  if (state == nullptr) return;
  while (!waiting_.empty() && waiting_.front().order.number <= state->answered) {
    const double at_s = seconds(envelope.sent).base();
    const bool is_obeyed = state->refusal.empty();
    waiting_.front().caller.answer(
        {is_obeyed ? Exit::done : Exit::not_met,
         is_obeyed ? fmt::format("obeyed at {:.1f} s", at_s)
                   : fmt::format("refused at {:.1f} s: {}", at_s, state->refusal)});
    waiting_.pop_front();
    said_ = {};
  }
}

}  // namespace furrow::app
