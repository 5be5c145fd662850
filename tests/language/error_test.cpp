// Monitor texts letter by letter, and sentences that say what, where and what to do.
#include "language/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tape_block.hpp"

namespace cnclab::language {
namespace {

std::vector<ErrorCode> all_codes() {
  std::vector<ErrorCode> codes;
  for (int code = 0; code <= static_cast<int>(kLastErrorCode); ++code) codes.push_back(static_cast<ErrorCode>(code));
  return codes;
}

TEST(ErrorText, MonitorTextsOfManualAndDecisions_ERR_001_to_004_DEC_50) {
  struct Row {
    ErrorCode code;
    std::string_view text;
  };
  constexpr Row kRows[] = {
      {ErrorCode::function_unknown, "Funktion nicht vorgesehen"},
      {ErrorCode::word_missing, "Satz überprüfen"},
      {ErrorCode::word_out_of_range, "Satz überprüfen"},
      {ErrorCode::checksum_wrong, "CHECKSUM FEHLER"},
      {ErrorCode::program_missing, "Programm fehlt"},
      {ErrorCode::block_missing, "Satz fehlt"},
      {ErrorCode::memory_full, "Speicher voll"},
      {ErrorCode::nesting_too_deep, "Zu tief verschachtelt"},
      {ErrorCode::feed_missing, "F fehlt"},
      {ErrorCode::plane_wrong, "Falsche Ebene"},
      {ErrorCode::arc_wrong, "Kreis falsch"},
      {ErrorCode::compensation_impossible, "Korrektur nicht moeglich"},
      {ErrorCode::arc_at_entry_or_exit, "Korrektur nicht moeglich"},
      {ErrorCode::inside_arc_too_small, "Korrektur nicht moeglich"},
      {ErrorCode::offset_not_left, "Korrektur nicht moeglich"},
      {ErrorCode::arc_under_axis_offset, "Korrektur nicht moeglich"},
      {ErrorCode::radius_too_small, "Kreis falsch"},
      {ErrorCode::arc_without_way, "Kreis falsch"},
      {ErrorCode::rounding_way_back, "Kreis falsch"},
      {ErrorCode::scale_unequal, "Skalenfaktor unzulaessig"},
      {ErrorCode::no_intersection, "Korrektur nicht moeglich"},
      {ErrorCode::runs_backwards, "Korrektur nicht moeglich"},
      {ErrorCode::too_close, "Korrektur nicht moeglich"},
      {ErrorCode::entry_too_close, "Korrektur nicht moeglich"},
      {ErrorCode::exit_too_close, "Korrektur nicht moeglich"},
      {ErrorCode::rounding_without_lines, "Kreis falsch"},
      {ErrorCode::rounding_too_large, "Kreis falsch"},
      {ErrorCode::scale_not_allowed, "Skalenfaktor unzulaessig"},
      {ErrorCode::m_unknown, "M nicht vorgesehen"},
      {ErrorCode::cycle_value_wrong, "Zykluswert falsch"},
      {ErrorCode::parameter_read_only, "Parameter nur lesbar"},
      {ErrorCode::transfer_wrong, "Uebertragung falsch"},
      {ErrorCode::reserved_for_cycles, "Reserviert fuer Zyklen"},
      {ErrorCode::feed_above_limit, "Satz überprüfen"},
  };
  for (const Row& row : kRows) EXPECT_EQ(monitor_text(row.code, Tongue::german), row.text);
}

TEST(ErrorText, EveryCodeHasTextsInBothLanguages_DEC_02) {
  for (const ErrorCode code : all_codes()) {
    SCOPED_TRACE(static_cast<int>(code));
    const Error error{.code = code, .program = 1, .block = 3, .word = 'F', .detail = "4000", .expected = "0001..3000"};
    for (const Tongue tongue : {Tongue::german, Tongue::english}) {
      EXPECT_FALSE(monitor_text(code, tongue).empty());
      EXPECT_LE(columns_of(monitor_text(code, tongue)), 64);
      const std::string sentence = explain(error, tongue);
      EXPECT_THAT(sentence, testing::StartsWith("P0001 N003: "));
      EXPECT_THAT(sentence, testing::HasSubstr("0001..3000"));
      EXPECT_THAT(sentence, testing::EndsWith("."));
      EXPECT_THAT(sentence, testing::Not(testing::AnyOf(testing::HasSubstr("{"), testing::HasSubstr("("))));
    }
    EXPECT_NE(explain(error, Tongue::german), explain(error, Tongue::english));
  }
}

TEST(ErrorText, SentencesFitRow18_DEC_01) {
  for (const ErrorCode code : all_codes())
    for (const Tongue tongue : {Tongue::german, Tongue::english})
      EXPECT_LE(columns_of(explain({.code = code, .block = 3, .word = 'F', .detail = "4000"}, tongue)), 80)
          << explain({.code = code, .block = 3, .word = 'F', .detail = "4000"}, tongue);
}

TEST(ErrorText, SaysBlockWordValueLimitAndRemedy_DEC_01) {
  const Error error{.code = ErrorCode::word_out_of_range,
                    .program = 1,
                    .block = 3,
                    .word = 'F',
                    .detail = "4000",
                    .expected = "0001..3000"};
  EXPECT_EQ(explain(error, Tongue::german), "P0001 N003: F 4000 ist nicht erlaubt, richtig: 0001..3000. Wert ändern.");
  EXPECT_EQ(explain(error, Tongue::english), "P0001 N003: F 4000 is not allowed, right: 0001..3000. Change the value.");
  EXPECT_EQ(message_of(error, Tongue::german), "F 4000 ist nicht erlaubt, richtig: 0001..3000. Wert ändern.");
}

TEST(ErrorText, ContoursThatCannotBeFollowedSayWhy_DEC_09_D_66_D_71) {
  struct Row {
    ErrorCode code;
    std::string detail, expected;
    std::string_view german, english;
  };
  const Row rows[] = {
      {ErrorCode::arc_at_entry_or_exit, "", "", "Der Satz: An- und Abfahren nur auf Geraden. G01 statt Bogen nehmen.",
       "The block: enter and leave a contour on lines. Use G01, no arc."},
      {ErrorCode::inside_arc_too_small, "R 4.000", "R >= 5.000",
       "R 4.000: Innenbogen zu klein für das Werkzeug, richtig: R >= 5.000. Kleineres nehmen.",
       "R 4.000: inside arc too small for the tool, right: R >= 5.000. Use a smaller one."},
      {ErrorCode::no_intersection, "", "", "Der Satz: an der Innenecke schneiden sich die Bahnen nicht. Kontur ändern.",
       "The block: the paths do not meet at the inside corner. Change contour."},
      {ErrorCode::runs_backwards, "3.000 mm", ">= 5.000 mm",
       "Weg 3.000 mm: zu kurz für das Werkzeug, liefe rückwärts, richtig: >= 5.000 mm. Kontur ändern.",
       "Way 3.000 mm: too short for the tool, would run backwards, right: >= 5.000 mm. Change contour."},
      {ErrorCode::too_close, "N007", "", "Werkzeug würde in N007 schneiden. Kontur ändern oder kleineres nehmen.",
       "Tool would cut into N007. Change the contour or use a smaller one."},
      {ErrorCode::entry_too_close, "N007", "", "Einfahren würde in N007 schneiden. Von der freien Seite anfahren.",
       "Entry would cut into N007. Begin on the free side."},
      {ErrorCode::exit_too_close, "N007", "", "Ausfahren würde in N007 schneiden. Zur freien Seite wegfahren.",
       "Exit would cut into N007. Leave to the free side."},
      {ErrorCode::offset_not_left, "G68", "G01 Z",
       "G68: Versatz von G41 bis G46 noch nicht verlassen, richtig: G01 Z. Erst Gerade fahren.",
       "G68: the offset of G41 to G46 is still to be left, right: G01 Z. First a line."},
      {ErrorCode::rounding_without_lines, "", "", "Der Satz: G10 rundet nur zwischen zwei G01 der Ebene. Sätze prüfen.",
       "The block: G10 rounds only between two G01 of the plane. Check them."},
      {ErrorCode::rounding_too_large, "6.000 mm", ">= 8.000 mm",
       "Gerade 6.000 mm: zu kurz für die Rundung, richtig: >= 8.000 mm. R verkleinern.",
       "Line 6.000 mm: too short for the rounding, right: >= 8.000 mm. Use a smaller R."},
      {ErrorCode::checksum_wrong, "", "", "Der Satz ist im Speicher beschädigt. Löschen und neu eingeben.",
       "The block is damaged in memory. Delete and enter it again."},
  };
  for (const Row& row : rows) {
    const Error error{.code = row.code, .program = 1, .block = 3, .detail = row.detail, .expected = row.expected};
    EXPECT_EQ(message_of(error, Tongue::german), row.german);
    EXPECT_EQ(message_of(error, Tongue::english), row.english);
  }
}

TEST(ErrorText, PlaceAsFarAsKnown) {
  EXPECT_EQ(place_of({.program = 1, .block = 3}), "P0001 N003");
  EXPECT_EQ(place_of({.program = 12}), "P0012");
  EXPECT_EQ(place_of({.block = 7}), "N007");
  EXPECT_EQ(place_of({.block = 7, .in_tool_table = true}), "P0000 T007");
  EXPECT_EQ(place_of({}), "");
}

}  // namespace
}  // namespace cnclab::language
