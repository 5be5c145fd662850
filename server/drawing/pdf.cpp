// Writes pictures with libharu.
#include "drawing/pdf.hpp"

#include <fmt/format.h>
#include <hpdf.h>

#include <algorithm>
#include <memory>

namespace cnclab::drawing {

namespace {

constexpr double kA4Short_pt = 595.28, kA4Long_pt = 841.89, kMargin_pt = 28.35;

struct FreeDocument {
  void operator()(HPDF_Doc document) const { HPDF_Free(document); }
};
using Document = std::unique_ptr<_HPDF_Doc_Rec, FreeDocument>;

HPDF_REAL real(double value) { return static_cast<HPDF_REAL>(value); }

/// The next character of UTF-8 text; malformed bytes count as one character each.
char32_t take_character(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  char32_t code = length == 1 ? first : first & (0xFFU >> (length + 1));
  const std::size_t taken = std::min(length, text.size());
  for (std::size_t i = 1; i < taken; ++i) code = code << 6U | (static_cast<unsigned char>(text[i]) & 0x3FU);
  text.remove_prefix(taken);
  return code;
}

std::string win_ansi(std::string_view text) {
  std::string bytes;
  while (!text.empty()) {
    const char32_t code = take_character(text);
    const bool is_known = (code >= ' ' && code < 0x7F) || (code >= 0xA0 && code <= 0xFF);
    bytes += is_known ? static_cast<char>(static_cast<unsigned char>(code)) : '?';
  }
  return bytes;
}

/// Draws one picture on one page.
class PageWriter {
 public:
  PageWriter(HPDF_Doc document, const Picture& picture) : document_(document), page_(HPDF_AddPage(document)) {
    const bool is_across = picture.width_px > picture.height_px;
    const double width = is_across ? kA4Long_pt : kA4Short_pt, height = is_across ? kA4Short_pt : kA4Long_pt;
    HPDF_Page_SetWidth(page_, real(width));
    HPDF_Page_SetHeight(page_, real(height));
    scale_ = std::min((width - 2 * kMargin_pt) / picture.width_px, (height - 2 * kMargin_pt) / picture.height_px);
    left_ = (width - picture.width_px * scale_) / 2;
    top_ = height - kMargin_pt;
  }

  void write(const Stretch& stretch) {
    use(look_of(stretch.style));
    move_to(stretch.from);
    line_to(stretch.to);
    HPDF_Page_Stroke(page_);
  }
  void write(const Polyline& line) {
    if (line.points.empty()) return;
    use(look_of(line.style));
    move_to(line.points.front());
    for (std::size_t i = 1; i < line.points.size(); ++i) line_to(line.points[i]);
    HPDF_Page_Stroke(page_);
  }
  void write(const Rectangle& box) {
    use(look_of(box.style));
    HPDF_Page_Rectangle(page_, x(box.corner), y({box.corner.right, box.corner.up + box.height}),
                        real(box.width * scale_), real(box.height * scale_));
    paint(look_of(box.style));
  }
  void write(const Disc& disc) {
    use(look_of(disc.style));
    HPDF_Page_Circle(page_, x(disc.center), y(disc.center), real(disc.radius * scale_));
    paint(look_of(disc.style));
  }
  void write(const Words& words) {
    const Look& look = look_of(words.style);
    use(look);
    const char* name = look.is_monospaced ? "Courier" : look.is_bold ? "Helvetica-Bold" : "Helvetica";
    HPDF_Page_SetFontAndSize(page_, HPDF_GetFont(document_, name, "WinAnsiEncoding"), real(look.font_px * scale_));
    const std::string text = win_ansi(words.text);
    const double width = HPDF_Page_TextWidth(page_, text.c_str());
    const double shift = words.anchor == Anchor::start ? 0 : words.anchor == Anchor::middle ? width / 2 : width;
    HPDF_Page_BeginText(page_);
    HPDF_Page_TextOut(page_, real(x(words.at) - shift), y(words.at), text.c_str());
    HPDF_Page_EndText(page_);
  }

 private:
  [[nodiscard]] HPDF_REAL x(const Flat& point) const { return real(left_ + point.right * scale_); }
  [[nodiscard]] HPDF_REAL y(const Flat& point) const { return real(top_ - point.up * scale_); }
  void move_to(const Flat& point) { HPDF_Page_MoveTo(page_, x(point), y(point)); }
  void line_to(const Flat& point) { HPDF_Page_LineTo(page_, x(point), y(point)); }

  void use(const Look& look) {
    if (look.fill) HPDF_Page_SetRGBFill(page_, part(*look.fill, 16), part(*look.fill, 8), part(*look.fill, 0));
    if (!look.stroke) return;
    HPDF_Page_SetRGBStroke(page_, part(*look.stroke, 16), part(*look.stroke, 8), part(*look.stroke, 0));
    HPDF_Page_SetLineWidth(page_, real(look.width_px * scale_));
    HPDF_Page_SetLineJoin(page_, look.has_round_joins ? HPDF_ROUND_JOIN : HPDF_MITER_JOIN);
    const HPDF_UINT16 dash[] = {static_cast<HPDF_UINT16>(look.dash_px), static_cast<HPDF_UINT16>(look.gap_px)};
    HPDF_Page_SetDash(page_, look.dash_px > 0 ? dash : nullptr, look.dash_px > 0 ? 2 : 0, 0);
  }
  [[nodiscard]] static HPDF_REAL part(std::uint32_t rgb, unsigned shift) {
    return real((rgb >> shift & 0xFFU) / 255.0);
  }

  void paint(const Look& look) {
    if (look.fill && look.stroke)
      HPDF_Page_FillStroke(page_);
    else if (look.fill)
      HPDF_Page_Fill(page_);
    else
      HPDF_Page_Stroke(page_);
  }

  HPDF_Doc document_;
  HPDF_Page page_;
  double scale_ = 1, left_ = 0, top_ = 0;
};

std::unexpected<std::string> fault_of(HPDF_Doc document) {
  return std::unexpected(fmt::format("the PDF library failed with code {:04X}", HPDF_GetError(document)));
}

std::expected<std::string, std::string> bytes_of(HPDF_Doc document) {
  if (HPDF_SaveToStream(document) != HPDF_OK) return fault_of(document);
  std::string bytes(HPDF_GetStreamSize(document), '\0');
  auto length = static_cast<HPDF_UINT32>(bytes.size());
  HPDF_ReadFromStream(document, reinterpret_cast<HPDF_BYTE*>(bytes.data()), &length);
  bytes.resize(length);
  return bytes;
}

}  // namespace

std::expected<std::string, std::string> pdf_of(std::span<const Picture> pages) {
  if (pages.empty()) return std::unexpected("a PDF file needs a page");
  const Document document(HPDF_New(nullptr, nullptr));  // without a handler errors stay in the document
  if (document == nullptr) return std::unexpected("no memory for a PDF file");
  HPDF_SetCompressionMode(document.get(), HPDF_COMP_ALL);
  HPDF_SetInfoAttr(document.get(), HPDF_INFO_TITLE, win_ansi(pages.front().title).c_str());
  for (const Picture& picture : pages) {
    PageWriter writer(document.get(), picture);
    for (const Shape& shape : picture.shapes) std::visit([&](const auto& drawn) { writer.write(drawn); }, shape);
    if (HPDF_GetError(document.get()) != HPDF_OK) return fault_of(document.get());
  }
  return bytes_of(document.get());
}

}  // namespace cnclab::drawing
