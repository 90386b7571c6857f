#include "agents/guidance/position_filter.hpp"

#include "agents/gnss/receiver.hpp"

#include <catch2/catch.hpp>

namespace furrow::agents {
namespace {

TEST_CASE("position filter: stands still in the noise of a standalone receiver", "[agents]") {
  Receiver receiver{{.sigma = metres(1.5), .bias = {}}, 4};
  PositionFilter filter{1.5};
  double squares = 0.0;
  constexpr int samples = 20'000;
  for (int i = 0; i < samples; ++i) {
    filter.predict(receiver.velocity_mps({}));
    filter.correct(receiver.fix_m({}));
    squares += filter.estimate_m().x * filter.estimate_m().x;
  }
  // Gain 0.00333 = drift of 5 mm a period over 1.5 m; variance gain * sigma^2, 0.087 m.
  CHECK(filter.gain() == Approx(0.00333).epsilon(0.01));
  CHECK(std::sqrt(squares / samples) == Approx(0.087).epsilon(0.25));
}

TEST_CASE("position filter: follows a perfect receiver at once", "[agents]") {
  CHECK(PositionFilter{0.0}.gain() == 1.0);
}

TEST_CASE("receiver: a bias is one offset for all fixes", "[agents]") {
  Receiver receiver{{.sigma = {}, .bias = metres(1.2)}, 4};
  const Xy first = receiver.fix_m({3, 4}), later = receiver.fix_m({30, 40});
  CHECK(norm(first - Xy{3, 4}) == Approx(1.2));
  CHECK(norm((later - Xy{30, 40}) - (first - Xy{3, 4})) == Approx(0.0).margin(1e-12));
}

}  // namespace
}  // namespace furrow::agents
