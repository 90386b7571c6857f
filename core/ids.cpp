#include "core/ids.hpp"

namespace furrow {

std::string text(NodeId id) {
  switch (id.kind) {
    case NodeKind::scheduler: return "scheduler";
    case NodeKind::station: return "station " + std::to_string(id.number);
    case NodeKind::agent: return "agent " + std::to_string(id.number);
    case NodeKind::director: return "director";
  }
  return "node " + std::to_string(id.number);  // a value off the wire may be none of ours
}

}  // namespace furrow
