#include "mission/node_options.hpp"

#include <CLI/CLI.hpp>

#include <charconv>
#include <map>
#include <string_view>

namespace furrow::mission {
namespace {

std::optional<std::uint32_t> whole(std::string_view text) {
  std::uint32_t value = 0;
  const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc{} || stop != text.data() + text.size() || value == 0) return {};
  return value;
}

// "7" or "1-50" into options.first and options.last.
bool read_range(std::string_view text, NodeOptions& options) {
  const auto dash = text.find('-');
  const auto first = whole(text.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : whole(text.substr(dash + 1));
  if (!first || !last || *first > *last) return false;
  options.first = *first;
  options.last = *last;
  return true;
}

// What is read on from its words.
struct Words {
  std::uint64_t boot = 1;
  std::string agents, station;
};

void add_options(CLI::App& app, NodeOptions& o, Words& words) {
  const std::map<std::string, NodeOptions::Mode> modes{{"granted", NodeOptions::Mode::granted},
                                                       {"wall", NodeOptions::Mode::wall}};
  app.add_option("--scenario", o.scenario, "Scenario file")->required();
  app.add_option("--seed", o.seed, "Instead of the scenario's seed")->check(CLI::NonNegativeNumber);
  app.add_option("--domain", o.domain, "DDS domain")->check(CLI::Range(0, 232));
  app.add_option("--run", o.run, "Name of the run")->required();
  app.add_option("--participant", o.participant, "DDS participant id")->check(CLI::Range(0, 119));
  app.add_option("--interface", o.interface, "Network address to use");
  app.add_option("--peer", o.peers, "Address of the director's host, where it is another")
      ->check(CLI::ValidIPV4);
  app.add_option("--mode", o.mode, "granted or wall")->transform(CLI::CheckedTransformer(modes));
  app.add_option("--epoch-ns", o.epoch_ns, "Wall time of mission time zero [ns since 1970]");
  app.add_option("--boot", words.boot, "Number of this start of the process")
      ->check(CLI::NonNegativeNumber);
  auto* agents_option = app.add_option("--agents", words.agents, "Agents hosted: 7 or 1-50");
  app.add_option("--station", words.station, "Station run")->excludes(agents_option);
}

// Exceptions of the library end here, as its messages.
std::string parse_fault(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return app.help();
  } catch (const CLI::ParseError& e) {
    return e.what();
  }
  return {};
}

}  // namespace

Expected<NodeOptions, std::string> node_options(int argc, const char* const* argv) {
  NodeOptions o{.scenario = {},
                .seed = {},
                .domain = 0,
                .run = {},
                .participant = 0,
                .interface = "127.0.0.1",
                .peers = {},
                .mode = NodeOptions::Mode::granted,
                .epoch_ns = 0,
                .first = 0,
                .last = 0,
                .boot = BootId{1}};
  Words words;
  CLI::App app{"One node process of a Furrow fleet."};
  add_options(app, o, words);
  if (auto fault = parse_fault(app, argc, argv); !fault.empty()) return Unexpected{fault};
  o.boot = BootId{words.boot};
  if (!words.agents.empty() && !read_range(words.agents, o)) {
    return Unexpected{"--agents: must be a number or a range like 1-50 (got " + words.agents + ")"};
  }
  if (!words.station.empty() && (!read_range(words.station, o) || o.first != o.last)) {
    return Unexpected{"--station: must be a number (got " + words.station + ")"};
  }
  return o;
}

}  // namespace furrow::mission
