#pragma once

#include "agents/xy.hpp"

namespace furrow::agents {

/// Where an aircraft takes itself to be: its own velocity carried forward, drawn to each fix by as
/// much as the fix is worth. A noisy fix moves it slowly, so the track does not follow the noise; a
/// bias it cannot see.
/// Source: steady-state Kalman filter of a random walk, Simon 2006, section 7.3.
class PositionFilter {
 public:
  /// @param sigma_m  Of each axis of a fix, >= 0.
  explicit PositionFilter(double sigma_m);

  void restart(Xy position_m) { estimate_ = position_m; }
  void predict(Xy velocity_mps);
  void correct(Xy fix_m) { estimate_ = estimate_ + gain_ * (fix_m - estimate_); }

  Xy estimate_m() const { return estimate_; }
  double gain() const { return gain_; }

 private:
  Xy estimate_;
  double gain_;
};

}  // namespace furrow::agents
