// PDF files as another program reads them: poppler's pdftotext and pdfinfo.
#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "drawing/path_picture.hpp"
#include "drawing/pdf.hpp"
#include "drawing/text_pages.hpp"

namespace cnclab::drawing {
namespace {

using testing::HasSubstr;

/// What a program prints about a file.
std::string output_of(const std::string& command) {
  std::string text;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  char buffer[4096];
  for (std::size_t read = 0; (read = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) text.append(buffer, read);
  pclose(pipe);
  return text;
}

class Pdf : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("pdftotext -v 2>/dev/null") != 0) GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
    file_ = std::filesystem::path(testing::TempDir()) /
            (std::string("pdf_") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".pdf");
  }
  void TearDown() override { std::filesystem::remove(file_); }

  void write(const std::vector<Picture>& pages) {
    const auto bytes = pdf_of(pages);
    ASSERT_TRUE(bytes.has_value()) << bytes.error();
    EXPECT_EQ(*bytes, *pdf_of(pages));
    std::ofstream(file_, std::ios::binary) << *bytes;
  }
  /// Without the blanks that pdftotext sets to keep columns apart.
  [[nodiscard]] std::string text() const {
    std::string words;
    for (const char c : output_of("pdftotext -layout '" + file_.string() + "' -"))
      if (c != ' ' || !words.ends_with(' ')) words += c;
    return words;
  }
  [[nodiscard]] std::string info() const { return output_of("pdfinfo '" + file_.string() + "'"); }

  std::filesystem::path file_;
};

TEST_F(Pdf, AListIsReadBackWithUmlautsAndColumns) {
  const std::vector<std::string> lines{"CNC 3300 P0001 Jörg Weiß Seite 1/1", "",
                                       "N001 G00 X+..50.000 Y+..50.000 Z+..50.000 (EILGANG)",
                                       "Überprüfen: Länge größer als 5 µm"};
  write({text_page(lines, "P0001 für Jörg")});
  for (const std::string& line : lines) EXPECT_THAT(text(), HasSubstr(line));
  EXPECT_THAT(info(), HasSubstr("P0001 für Jörg"));
  EXPECT_THAT(info(), HasSubstr("595.28 x 841.89 pts (A4)"));
  EXPECT_THAT(info(), HasSubstr("Pages:           1"));
}

TEST_F(Pdf, EachPictureIsAPage) {
  const std::vector<std::string> one{"eins"}, two{"zwei"};
  write({text_page(one, "a"), text_page(two, "b")});
  EXPECT_THAT(info(), HasSubstr("Pages:           2"));
  EXPECT_THAT(text(), HasSubstr("zwei"));
}

TEST_F(Pdf, ADrawingLiesAcross) {
  const std::vector<Stroke> path{{.is_rapid = true, .spots = {{0, 0, 0}, {10, 0, 0}}},
                                 {.is_rapid = false, .spots = {{10, 0, 0}, {10, 10, 0}}}};
  write({path_picture({.path = path, .contour = {}}, {.title = "P0007", .workpiece = standard_workpiece({})})});
  EXPECT_THAT(text(), HasSubstr("P0007"));
  EXPECT_THAT(text(), HasSubstr("Werkstück"));
  EXPECT_THAT(info(), HasSubstr("841.89 x 595.28 pts (A4)"));
}

TEST_F(Pdf, SignsThatFontsLackAreDrawn) {
  const std::vector<std::string> rows{"┌──┐ → ↓ ● ○ ↻ ↺ □006 ⠿⣿", "N002 ↓01 #01 = #02 + #03", "€"};
  const std::vector<InverseRun> inverse{{.row = 1, .column = 0, .length = 4}};
  write({screen_page(rows, inverse, "Platz 07")});
  EXPECT_THAT(text(), HasSubstr("01 #01 = #02 + #03"));
  EXPECT_THAT(text(), HasSubstr("N002"));
  const Picture picture = screen_page(rows, inverse, "");
  const auto grounds = std::ranges::count_if(picture.shapes, [](const Shape& shape) {
    const auto* box = std::get_if<Rectangle>(&shape);
    return box != nullptr && box->style == Style::ink && box->width == 24;
  });
  EXPECT_EQ(grounds, 1);
  const auto unknown = std::ranges::count_if(picture.shapes, [](const Shape& shape) {
    const auto* words = std::get_if<Words>(&shape);
    return words != nullptr && words->text == "?";
  });
  EXPECT_EQ(unknown, 1);  // the euro sign alone
}

TEST(PdfOf, NoPagesIsAnError) { EXPECT_FALSE(pdf_of({}).has_value()); }

}  // namespace
}  // namespace cnclab::drawing
