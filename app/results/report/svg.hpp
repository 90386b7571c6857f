#pragma once
// A picture as text. Coordinates are pixels, x right, y down.

#include <cmath>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <vector>

namespace furrow::app {

/// `text` as it may stand in HTML or SVG, between tags or in a quoted attribute.
inline std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&': safe += "&amp;"; break;
      case '<': safe += "&lt;"; break;
      case '>': safe += "&gt;"; break;
      case '"': safe += "&quot;"; break;
      case '\'': safe += "&#39;"; break;
      default:
        // Control characters have no place in a document, escaped or not.
        safe += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? ' ' : c;
    }
  }
  return safe;
}

struct Pixel {
  double x, y;
};

/// How a shape is drawn. Colours are CSS; empty means none.
struct Paint {
  std::string_view fill = {};
  std::string_view stroke = {};
  double width = 1;
  double opacity = 1;
  std::string_view dash = {};
};

/// How a text is set.
struct Lettering {
  double size = 11;
  std::string_view anchor = "start";  ///< start, middle or end.
  std::string_view fill = "#333";
  bool bold = false;
  bool halo = false;  ///< A white rim, to be read over a picture.
};

/// An SVG picture that grows shape by shape, the later over the earlier.
class Svg {
 public:
  /// @param title  What it shows, for those who cannot see it.
  Svg(double width, double height, std::string_view title)
      : body_{fmt::format("<svg viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" "
                          "aria-label=\"{2}\">",
                          number(width), number(height), escaped(title))} {}

  void line(Pixel a, Pixel b, const Paint& paint) {
    body_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"{}/>", number(a.x),
                         number(a.y), number(b.x), number(b.y), style(paint));
  }
  void rect(Pixel corner, double width, double height, const Paint& paint, double round = 0,
            std::string_view tip = {}) {
    body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"", number(corner.x),
                         number(corner.y), number(width), number(height));
    if (round > 0) body_ += fmt::format(" rx=\"{}\"", number(round));
    close("rect", paint, tip);
  }
  void circle(Pixel center, double radius, const Paint& paint, std::string_view tip = {}) {
    body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"", number(center.x), number(center.y),
                         number(radius));
    close("circle", paint, tip);
  }
  /// Each chain of points is drawn on its own; closed ones make holes where they lie in another.
  void path(const std::vector<std::vector<Pixel>>& chains, bool closed, const Paint& paint) {
    std::string d;
    for (const auto& chain : chains) {
      for (std::size_t i = 0; i < chain.size(); ++i) {
        d += fmt::format("{}{} {}", i == 0 ? 'M' : 'L', number(chain[i].x), number(chain[i].y));
      }
      if (closed && !chain.empty()) d += 'Z';
    }
    if (d.empty()) return;
    body_ += fmt::format("<path d=\"{}\" fill-rule=\"evenodd\" stroke-linejoin=\"round\"{}/>", d,
                         style(paint));
  }
  void text(Pixel at, std::string_view words, const Lettering& how) {
    body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"",
                         number(at.x), number(at.y), number(how.size), how.anchor, how.fill);
    if (how.bold) body_ += " font-weight=\"600\"";
    if (how.halo) {
      body_ +=
          " stroke=\"#fff\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
    }
    body_ += fmt::format(">{}</text>", escaped(words));
  }

  std::string markup() const { return body_ + "</svg>"; }

 private:
  // Two digits at most, none where they say nothing.
  static std::string number(double value) {
    const double tidy = std::round(value * 100) / 100 + 0.0;
    return std::isfinite(tidy) ? fmt::format("{}", tidy) : "0";
  }

  static std::string style(const Paint& paint) {
    std::string s = fmt::format(" fill=\"{}\"", paint.fill.empty() ? "none" : paint.fill);
    if (!paint.stroke.empty()) {
      s += fmt::format(" stroke=\"{}\" stroke-width=\"{}\"", paint.stroke, number(paint.width));
    }
    if (!paint.dash.empty()) s += fmt::format(" stroke-dasharray=\"{}\"", paint.dash);
    if (paint.opacity < 1) s += fmt::format(" opacity=\"{}\"", number(paint.opacity));
    return s;
  }

  void close(std::string_view tag, const Paint& paint, std::string_view tip) {
    body_ += style(paint);
    body_ += tip.empty() ? "/>" : fmt::format("><title>{}</title></{}>", escaped(tip), tag);
  }

  std::string body_;
};

}  // namespace furrow::app
