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

TEST(ErrorText, PlaceAsFarAsKnown) {
  EXPECT_EQ(place_of({.program = 1, .block = 3}), "P0001 N003");
  EXPECT_EQ(place_of({.program = 12}), "P0012");
  EXPECT_EQ(place_of({.block = 7}), "N007");
  EXPECT_EQ(place_of({.block = 7, .in_tool_table = true}), "P0000 T007");
  EXPECT_EQ(place_of({}), "");
}

}  // namespace
}  // namespace cnclab::language
