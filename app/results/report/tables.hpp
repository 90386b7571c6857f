#pragma once
// The tables of the report, each a piece of HTML; empty where there is nothing to tell.

#include "app/results/mission_record.hpp"
#include "app/results/result.hpp"

#include <string>

namespace furrow::app {

std::string headline(const Result& result);
/// Areas and order of the swath model, planned and flown; empty for the grid.
std::string coverage_table(const Result& result);
std::string expectation_table(const Result& result);
std::string optimum_table(const Result& result);
std::string uav_table(const Result& result);
std::string deviation_table(const Result& result);
std::string sortie_table(const Result& result);
std::string battery_table(const Result& result);
std::string station_table(const Result& result);
std::string event_table(const MissionRecord& record);
std::string scenario_table(const MissionRecord& record);

}  // namespace furrow::app
