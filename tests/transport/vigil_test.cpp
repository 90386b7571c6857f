#include "transport/vigil.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <thread>

namespace furrow::transport {
namespace {

using std::chrono::milliseconds;

TEST_CASE("vigil: one that shows itself again is not lost, one that does not is", "[transport]") {
  std::atomic<int> lost_1{0}, lost_2{0};
  Vigil vigil{[&](std::uint32_t who) { ++(who == 1 ? lost_1 : lost_2); }, milliseconds{200}};
  vigil.suspect(1);
  vigil.suspect(2);
  vigil.suspect(2);  // by another topic: still once
  vigil.hear(1);
  CHECK(lost_2 == 0);
  std::this_thread::sleep_for(milliseconds{600});
  CHECK(lost_1 == 0);
  CHECK(lost_2 == 1);
}

TEST_CASE("vigil: what is beyond doubt is not waited for", "[transport]") {
  int lost = 0;
  Vigil vigil{[&](std::uint32_t) { ++lost; }, milliseconds{10'000}};
  vigil.lose(1);
  CHECK(lost == 1);
}

TEST_CASE("vigil: nobody is lost once it has ended", "[transport]") {
  std::atomic<int> lost{0};
  Vigil vigil{[&](std::uint32_t) { ++lost; }, milliseconds{50}};
  vigil.suspect(1);
  vigil.end();
  vigil.suspect(2);
  std::this_thread::sleep_for(milliseconds{150});
  CHECK(lost == 0);
}

}  // namespace
}  // namespace furrow::transport
