#include "exchange/ascii_grid.hpp"

#include "exchange/gdal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>
#include <optional>
#include <string>

namespace furrow::exchange {
namespace {

// The words of a text in order, with the line of the last one, from 1.
class Words {
 public:
  explicit Words(std::string_view text) : rest_{text} {}

  // Empty at the end.
  std::string_view next() {
    const std::size_t begin = std::min(rest_.find_first_not_of(space), rest_.size());
    for (std::size_t i = 0; i < begin; ++i) {
      const bool is_second = i > 0 && rest_[i] == '\n' && rest_[i - 1] == '\r';
      line_ += (rest_[i] == '\n' || rest_[i] == '\r') && !is_second;
    }
    rest_.remove_prefix(begin);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(space));
    rest_.remove_prefix(word.size());
    return word;
  }
  std::size_t line() const { return line_; }

 private:
  static constexpr std::string_view space = " \t\r\n\v\f";
  std::string_view rest_;
  std::size_t line_ = 1;
};

// The words behind a line of the header; nothing where none begins.
std::optional<Words> behind_header_line(Words words) {
  const std::string_view key = words.next();
  if (key.empty() || !std::isalpha(static_cast<unsigned char>(key.front()))) return std::nullopt;
  const std::size_t line = words.line();
  if (words.next().empty() || words.line() != line) return std::nullopt;
  Words ahead = words;
  if (!ahead.next().empty() && ahead.line() == line) return std::nullopt;
  return words;
}

std::optional<float> sample_of(std::string_view word) {
  constexpr double most = std::numeric_limits<float>::max();
  if (word.front() == '+') word.remove_prefix(1);
  std::string text{word};
  if (const auto comma = text.find(','); comma != std::string::npos) text[comma] = '.';
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [read_to, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || read_to != end) return std::nullopt;
  return static_cast<float>(std::clamp(value, -most, most));
}

}  // namespace

Expected<std::vector<float>, Fault> ascii_samples(std::string_view bytes, std::size_t columns,
                                                  std::size_t rows) {
  Words words{bytes};
  while (const auto behind = behind_header_line(words)) words = *behind;
  const std::size_t wanted = columns * rows;
  std::vector<float> samples;
  samples.reserve(std::min(wanted, bytes.size() / 2));
  std::size_t count = 0;
  for (auto word = words.next(); !word.empty(); word = words.next(), ++count) {
    if (count >= wanted) continue;
    const auto sample = sample_of(word);
    if (!sample) {
      return Unexpected{
          Fault{"must have a number for every sample",
                fmt::format("\"{}\" in line {}, row {}, column {}", shown(word.substr(0, 20)),
                            words.line(), count / columns + 1, count % columns + 1)}};
    }
    samples.push_back(*sample);
  }
  if (count == wanted) return samples;
  return Unexpected{Fault{"must have as many samples as its header says",
                          fmt::format("{} for {} x {}", count, columns, rows)}};
}

}  // namespace furrow::exchange
