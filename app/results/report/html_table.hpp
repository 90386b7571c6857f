#pragma once

#include "app/results/report/svg.hpp"

#include <initializer_list>
#include <string>
#include <string_view>

namespace furrow::app {

/// A table that grows row by row. Columns are numbers, set to the right, unless their heading
/// starts with '<', which is taken off.
class HtmlTable {
 public:
  explicit HtmlTable(std::initializer_list<std::string_view> headings) {
    for (std::string_view heading : headings) {
      const bool is_text = heading.starts_with('<');
      if (is_text) heading.remove_prefix(1);
      is_text_.push_back(is_text);
      head_ += fmt::format("<th{}>{}</th>", is_text ? " class=\"words\"" : "", escaped(heading));
    }
  }

  void row(std::initializer_list<std::string> cells, std::string_view style = {}) {
    body_ += style.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", style);
    std::size_t column = 0;
    for (const std::string& cell : cells) {
      const bool is_text = column < is_text_.size() && is_text_[column];
      body_ += fmt::format("<td{}>{}</td>", is_text ? " class=\"words\"" : "", escaped(cell));
      ++column;
    }
    body_ += "</tr>\n";
  }

  bool empty() const { return body_.empty(); }

  std::string markup(std::string_view style = {}) const {
    return fmt::format("<table{}><thead><tr>{}</tr></thead><tbody>\n{}</tbody></table>\n",
                       style.empty() ? "" : fmt::format(" class=\"{}\"", style), head_, body_);
  }

 private:
  std::string head_, body_;
  std::vector<bool> is_text_;
};

}  // namespace furrow::app
