#include "agents/agent_node.hpp"

#include <algorithm>

namespace furrow::agents {

void AgentNode::obey(const OperatorState& state, Instant now) {
  const bool is_fenced_off = state.epoch < scheduler_epoch_ || state.epoch < level_epoch_;
  const bool is_known = state.epoch == level_epoch_ && state.revision <= level_revision_;
  if (is_fenced_off || is_known) return;
  level_epoch_ = state.epoch;
  level_revision_ = state.revision;
  const bool is_out = std::find(state.taken_out.begin(), state.taken_out.end(), vehicle_.id) !=
                      state.taken_out.end();
  if (state.level == level_ && is_out == is_taken_out_) return;
  level_ = state.level;
  is_taken_out_ = is_out;

  if (is_recalled()) return come_home(now);
  if (leaving_ == CloseReason::recalled) leaving_.reset();  // not yet on its way
  if (may_work()) return go_on(now);
  pause();
}

// From where it is next at rest on its line, so that work can be taken up there.
void AgentNode::come_home(Instant t) {
  if (!is_airborne()) {
    if (is_dismissed()) dismiss(t);
    return;
  }
  if (phase_ == Phase::fly_back || leaving_ || is_astray_) return;
  leave(CloseReason::recalled, t);
}

// Whom the scheduler has given up is given no more work by it, so it goes home for good.
void AgentNode::heed_loss(const SchedulerState& state, Instant now) {
  const bool is_lost =
      std::find(state.lost.begin(), state.lost.end(), vehicle_.id) != state.lost.end();
  if (!is_lost || is_given_up_) return;
  is_given_up_ = true;
  if (phase_ == Phase::offline || phase_ == Phase::done) return;
  note("given_up", "hears that it was taken for lost and comes home for good");
  come_home(now);
}

// Who is on its way home lands: hovering there would only cost its pack.
void AgentNode::pause() {
  const bool is_at_work = phase_ == Phase::fly_out || phase_ == Phase::spray;
  if (!is_at_work || leaving_ || is_astray_) return;
  stop_m_ = leaving_stop_m();
}

void AgentNode::go_on(Instant t) {
  if (is_airborne()) return relicense();
  ready_ = std::max(ready_, t);
  const bool is_at_bay = visit_ && !visit_->is_released();
  if (phase_ == Phase::wait && !is_at_bay) prepare(t);  // it may have been refused meanwhile
}

// On the ground for good; who is in a bay is served first.
void AgentNode::dismiss(Instant t) {
  if (phase_ == Phase::done || phase_ == Phase::offline || phase_ == Phase::service) return;
  if (visit_ && visit_->is_waiting()) {
    visit_->release();
    send(visit_->claim());
  }
  report_sortie();
  diverts_ = false;
  slot_.drop();
  if (order_) {
    ledger_.close_all(CloseReason::recalled, t);
    if (!ledger_.closures().empty()) send_report(t);
  }
  phase_ = Phase::offline;
  note("dismissed", "stays on the ground, as the operator orders");
}

}  // namespace furrow::agents
