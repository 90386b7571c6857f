#pragma once

#include <string_view>

namespace furrow::app {

/// The style sheet of the report.
extern const std::string_view page_style;

}  // namespace furrow::app
