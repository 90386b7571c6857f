#pragma once

namespace furrow::transport {

/// Sends what the middleware has to say to the log instead of stdout: its errors as warnings, for
/// none of them ends a run, the rest as debug lines. May be called more than once.
void route_fastdds_log();

}  // namespace furrow::transport
