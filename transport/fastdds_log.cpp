#include "transport/fastdds_log.hpp"

#include <memory>
#include <mutex>

#include <fastdds/dds/log/Log.hpp>
#include <spdlog/spdlog.h>

namespace furrow::transport {
namespace {

using eprosima::fastdds::dds::Log;
using eprosima::fastdds::dds::LogConsumer;

struct Forward final : LogConsumer {
  void Consume(const Log::Entry& entry) override {
    const auto level = entry.kind == Log::Error ? spdlog::level::warn : spdlog::level::debug;
    spdlog::log(level, "DDS {}: {}", entry.context.category, entry.message);
  }
};

}  // namespace

void route_fastdds_log() {
  static std::once_flag once;
  std::call_once(once, [] {
    Log::ClearConsumers();
    Log::RegisterConsumer(std::make_unique<Forward>());
    Log::SetVerbosity(Log::Warning);
  });
}

}  // namespace furrow::transport
