// Writes a picture's shapes one after another.
#include "drawing/svg.hpp"

#include <fmt/format.h>

#include <array>

namespace cnclab::drawing {

namespace {

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += letter;
    }
  }
  return safe;
}

std::string colour(std::optional<std::uint32_t> rgb) { return rgb ? fmt::format("#{:06x}", *rgb) : "none"; }

std::string css_of(const Look& look) {
  std::string css = fmt::format(".{}{{fill:{}", look.name, colour(look.fill));
  if (look.stroke) css += fmt::format(";stroke:{};stroke-width:{:g}", colour(look.stroke), look.width_px);
  if (look.dash_px > 0) css += fmt::format(";stroke-dasharray:{:g} {:g}", look.dash_px, look.gap_px);
  if (look.has_round_joins) css += ";stroke-linejoin:round";
  if (look.font_px > 0)
    css +=
        fmt::format(";font-family:{};font-size:{:g}px", look.is_monospaced ? "monospace" : "sans-serif", look.font_px);
  if (look.is_monospaced) css += ";white-space:pre";
  if (look.is_bold) css += ";font-weight:bold";
  return css + "}";
}

class Writer {
 public:
  std::string file_of(const Picture& picture) {
    add(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {:g} {:g}" width="{:g}" height="{:g}">)"
        "\n<title>{}</title>\n<style>",
        picture.width_px, picture.height_px, picture.width_px, picture.height_px, escaped(picture.title));
    for (int style = 0; style < kStyles; ++style) out_ += css_of(look_of(static_cast<Style>(style)));
    out_ += "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (const Shape& shape : picture.shapes) {
      std::visit([&](const auto& drawn) { write(drawn); }, shape);
      out_ += '\n';
    }
    return out_ + "</svg>\n";
  }

 private:
  template <typename... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Values>(values)...);
  }

  void write(const Stretch& stretch) {
    add(R"(<line class="{}" x1="{:.2f}" y1="{:.2f}" x2="{:.2f}" y2="{:.2f}"/>)", look_of(stretch.style).name,
        stretch.from.right, stretch.from.up, stretch.to.right, stretch.to.up);
  }
  void write(const Polyline& line) {
    add(R"(<polyline class="{}" points=")", look_of(line.style).name);
    for (const Flat& point : line.points) add("{:.2f},{:.2f} ", point.right, point.up);
    if (out_.back() == ' ') out_.pop_back();
    out_ += "\"/>";
  }
  void write(const Rectangle& box) {
    add(R"(<rect class="{}" x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}"/>)", look_of(box.style).name,
        box.corner.right, box.corner.up, box.width, box.height);
  }
  void write(const Disc& disc) {
    add(R"(<circle class="{}" cx="{:.2f}" cy="{:.2f}" r="{:.2f}"/>)", look_of(disc.style).name, disc.center.right,
        disc.center.up, disc.radius);
  }
  void write(const Words& words) {
    constexpr std::array<std::string_view, 3> kAnchors{"start", "middle", "end"};
    add(R"(<text class="{}" x="{:.2f}" y="{:.2f}" text-anchor="{}">{}</text>)", look_of(words.style).name,
        words.at.right, words.at.up, kAnchors[static_cast<std::size_t>(words.anchor)], escaped(words.text));
  }

  std::string out_;
};

}  // namespace

std::string svg_of(const Picture& picture) { return Writer().file_of(picture); }

}  // namespace cnclab::drawing
