// The table of errors, and the sentences made from it.
#include "language/error.hpp"

#include <fmt/format.h>

namespace cnclab::language {

namespace {

/// One language's texts. In sentences {0} is the word with what was found ("F 4000"), {1} is ", richtig: 0001..3000"
/// or nothing. No parentheses: a sentence can stand in a program's comment.
struct Texts {
  std::string_view monitor;
  std::string_view sentence;
};

struct Row {
  ErrorCode code;
  Texts german, english;
};

constexpr std::string_view kCheckBlock = "Satz überprüfen";  // ERR-002, ERR-003
constexpr std::string_view kCheckBlockEnglish = "Check block";

constexpr std::string_view kNoCompensation = "Korrektur nicht moeglich";  // DEC-50
constexpr std::string_view kNoCompensationEnglish = "Compensation impossible";
constexpr std::string_view kArcWrong = "Kreis falsch";  // DEC-50
constexpr std::string_view kArcWrongEnglish = "Arc wrong";

constexpr Row kRows[] = {
    {ErrorCode::function_unknown,
     {"Funktion nicht vorgesehen", "{0} gibt es an dieser Steuerung nicht{1}. Andere Funktion eingeben."},
     {"Function not available", "{0} does not exist on this control{1}. Enter another function."}},
    {ErrorCode::word_missing,
     {kCheckBlock, "{0} fehlt{1}. Wort ergänzen."},
     {kCheckBlockEnglish, "{0} is missing{1}. Add the word."}},
    {ErrorCode::word_out_of_range,
     {kCheckBlock, "{0} ist nicht erlaubt{1}. Wert ändern."},
     {kCheckBlockEnglish, "{0} is not allowed{1}. Change the value."}},
    {ErrorCode::word_not_allowed,
     {kCheckBlock, "{0} passt nicht in diesen Satz{1}. Wort entfernen."},
     {kCheckBlockEnglish, "{0} does not fit into this block{1}. Remove the word."}},
    {ErrorCode::program_missing,
     {"Programm fehlt", "Programm {0} ist nicht gespeichert{1}. Andere Nummer wählen oder eingeben."},
     {"Program missing", "Program {0} is not stored{1}. Choose another number or enter it."}},
    {ErrorCode::block_missing,
     {"Satz fehlt", "Satz {0} gibt es nicht{1}. Andere Satznummer wählen."},
     {"Block missing", "Block {0} does not exist{1}. Choose another block number."}},
    {ErrorCode::memory_full,
     {"Speicher voll", "Speicher voll{1}: {0} ist nicht gespeichert. Programme löschen."},
     {"Memory full", "Memory full{1}: {0} is not stored. Delete programs."}},
    {ErrorCode::nesting_too_deep,
     {"Zu tief verschachtelt", "{0}: mehr als 16 Aufrufe ineinander{1}. Aufrufe verringern."},
     {"Nested too deeply", "{0}: more than 16 calls inside each other{1}. Use fewer."}},
    {ErrorCode::feed_missing,
     {"F fehlt", "Noch kein Vorschub: {0} vorher programmieren{1}, z. B. mit G11."},
     {"F missing", "No feed yet: program {0} before{1}, e.g. with G11."}},
    {ErrorCode::plane_wrong,
     {"Falsche Ebene", "{0} passt nicht zur Kreisebene{1}. G17, G18 oder G19 davor setzen."},
     {"Wrong plane", "{0} does not fit the plane{1}. Put G17, G18 or G19 before it."}},
    {ErrorCode::arc_wrong,
     {kArcWrong, "{0}: Endpunkt liegt nicht auf dem Kreis{1}. Endpunkt oder Mitte ändern."},
     {kArcWrongEnglish, "{0}: end point is not on the arc{1}. Change end point or centre."}},
    {ErrorCode::radius_too_small,
     {kArcWrong, "{0} reicht nicht bis zum Endpunkt{1}. R vergrößern."},
     {kArcWrongEnglish, "{0} does not reach the end point{1}. Use a larger R."}},
    {ErrorCode::arc_without_way,
     {kArcWrong, "{0}: Endpunkt ist der Startpunkt{1}. Vollkreis mit G02 oder G03 fahren."},
     {kArcWrongEnglish, "{0}: end point is the start point{1}. Full circle by G02 or G03."}},
    {ErrorCode::compensation_impossible,
     {kNoCompensation, "{0}: Werkzeugkorrektur geht hier nicht{1}. Kontur oder T ändern."},
     {kNoCompensationEnglish, "{0}: no tool compensation possible here{1}. Change contour or T."}},
    {ErrorCode::arc_at_entry_or_exit,
     {kNoCompensation, "{0}: An- und Abfahren nur auf Geraden{1}. G01 statt Bogen nehmen."},
     {kNoCompensationEnglish, "{0}: enter and leave a contour on lines{1}. Use G01, no arc."}},
    {ErrorCode::offset_not_left,
     {kNoCompensation, "{0}: Versatz von G41 bis G46 noch nicht verlassen{1}. Erst Gerade fahren."},
     {kNoCompensationEnglish, "{0}: the offset of G41 to G46 is still to be left{1}. First a line."}},
    {ErrorCode::arc_under_axis_offset,
     {kNoCompensation, "{0}: kein Bogen, solange G43/G44 versetzt{1}. Erst G40 und Gerade."},
     {kNoCompensationEnglish, "{0}: no arc while G43/G44 shift the axes{1}. First G40 and a line."}},
    {ErrorCode::inside_arc_too_small,
     {kNoCompensation, "{0}: Innenbogen zu klein für das Werkzeug{1}. Kleineres nehmen."},
     {kNoCompensationEnglish, "{0}: inside arc too small for the tool{1}. Use a smaller one."}},
    {ErrorCode::no_intersection,
     {kNoCompensation, "{0}: an der Innenecke schneiden sich die Bahnen nicht{1}. Kontur ändern."},
     {kNoCompensationEnglish, "{0}: the paths do not meet at the inside corner{1}. Change contour."}},
    {ErrorCode::runs_backwards,
     {kNoCompensation, "Weg {0}: zu kurz für das Werkzeug, liefe rückwärts{1}. Kontur ändern."},
     {kNoCompensationEnglish, "Way {0}: too short for the tool, would run backwards{1}. Change contour."}},
    {ErrorCode::too_close,
     {kNoCompensation, "Werkzeug würde in {0} schneiden{1}. Kontur ändern oder kleineres nehmen."},
     {kNoCompensationEnglish, "Tool would cut into {0}{1}. Change the contour or use a smaller one."}},
    {ErrorCode::entry_too_close,
     {kNoCompensation, "Einfahren würde in {0} schneiden{1}. Von der freien Seite anfahren."},
     {kNoCompensationEnglish, "Entry would cut into {0}{1}. Begin on the free side."}},
    {ErrorCode::exit_too_close,
     {kNoCompensation, "Ausfahren würde in {0} schneiden{1}. Zur freien Seite wegfahren."},
     {kNoCompensationEnglish, "Exit would cut into {0}{1}. Leave to the free side."}},
    {ErrorCode::contour_unchecked,
     {kNoCompensation, "{0}: Kontur ungeprüft, sie hängt von Input 1 ab{1}. Nur im TRAINING."},
     {kNoCompensationEnglish, "{0}: contour unchecked, it depends on Input 1{1}. In TRAINING only."}},
    {ErrorCode::rounding_without_lines,
     {kArcWrong, "{0}: G10 rundet nur zwischen zwei G01 der Ebene{1}. Sätze prüfen."},
     {kArcWrongEnglish, "{0}: G10 rounds only between two G01 of the plane{1}. Check them."}},
    {ErrorCode::rounding_too_large,
     {kArcWrong, "Gerade {0}: zu kurz für die Rundung{1}. R verkleinern."},
     {kArcWrongEnglish, "Line {0}: too short for the rounding{1}. Use a smaller R."}},
    {ErrorCode::rounding_way_back,
     {kArcWrong, "{0}: zweite Gerade führt zurück, da ist keine Ecke{1}. G10 löschen."},
     {kArcWrongEnglish, "{0}: the second line leads back, there is no corner{1}. Delete G10."}},
    {ErrorCode::scale_not_allowed,
     {"Skalenfaktor unzulaessig", "{0}: Skalenfaktor geht hier nicht{1}. G91, G40, G45 vorher."},
     {"Scale not allowed", "{0}: no scale factor here{1}. G91, G40, G45 first."}},
    {ErrorCode::scale_unequal,
     {"Skalenfaktor unzulaessig", "{0}: ein Bogen braucht gleiche Faktoren{1}. G75 ändern."},
     {"Scale not allowed", "{0}: an arc needs equal scale factors{1}. Change G75."}},
    {ErrorCode::m_unknown,
     {"M nicht vorgesehen", "{0} gibt es nicht{1}. Andere M-Funktion eingeben."},
     {"M not available", "{0} does not exist{1}. Enter another M function."}},
    {ErrorCode::cycle_value_wrong,
     {"Zykluswert falsch", "{0} geht in diesem Zyklus nicht{1}. Wert ändern."},
     {"Cycle value wrong", "{0} does not work in this cycle{1}. Change the value."}},
    {ErrorCode::parameter_read_only,
     {"Parameter nur lesbar", "{0} kann nur gelesen werden{1}. Anderen Parameter nehmen."},
     {"Parameter read only", "{0} can only be read{1}. Use another parameter."}},
    {ErrorCode::transfer_wrong,
     {"Uebertragung falsch", "{0}: Übertragung falsch{1}. Daten prüfen, neu senden."},
     {"Transfer wrong", "{0}: transfer wrong{1}. Check the data, send again."}},
    {ErrorCode::reserved_for_cycles,
     {"Reserviert fuer Zyklen", "P9981 bis P9989 gehören den Zyklen{1}. Andere Nummer nehmen."},
     {"Reserved for cycles", "P9981 to P9989 belong to the cycles{1}. Use another number."}},
    {ErrorCode::checksum_wrong,
     {"CHECKSUM FEHLER", "{0} ist im Speicher beschädigt{1}. Löschen und neu eingeben."},
     {"CHECKSUM ERROR", "{0} is damaged in memory{1}. Delete and enter it again."}},
    {ErrorCode::feed_above_limit,
     {kCheckBlock, "{0} ist größer als F MAX{1}. F verringern."},
     {kCheckBlockEnglish, "{0} is above F MAX{1}. Use a smaller F."}},
    {ErrorCode::travel_exceeded,
     {"Verfahrweg zu gross", "{0} verlässt den Verfahrweg{1}. Nullpunkt oder Weg ändern."},
     {"Travel exceeded", "{0} leaves the travel{1}. Change zero or way."}},
    {ErrorCode::tool_not_listed,
     {"Werkzeug fehlt", "{0} steht nicht in der Werkzeugliste{1}. Anderes T nehmen."},
     {"Tool missing", "{0} is not in the machine's tool list{1}. Use another T."}},
    {ErrorCode::tool_differs,
     {"Werkzeug falsch", "{0} weicht ab{1}. P0000 ändern."},
     {"Wrong tool", "{0} differs{1}. Change P0000."}},
    {ErrorCode::block_number_wrong,
     {kCheckBlock, "Satznummer {0} geht nicht{1}. Andere Nummer wählen."},
     {kCheckBlockEnglish, "Block number {0} does not work{1}. Choose another number."}},
    {ErrorCode::program_number_wrong,
     {"Programmnummer falsch", "Programmnummer {0} falsch{1}. P und vier Ziffern angeben."},
     {"Program number wrong", "Program number {0} wrong{1}. Give P and four digits."}},
    {ErrorCode::program_empty,
     {"Uebertragung falsch", "{0} hat keinen Satz{1}. Sätze ergänzen oder Nummer streichen."},
     {"Transfer wrong", "{0} has no block{1}. Add blocks or strike out its number."}},
    {ErrorCode::text_malformed,
     {"Uebertragung falsch", "{0} ist so nicht lesbar{1}. Text berichtigen."},
     {"Transfer wrong", "{0} cannot be read like this{1}. Correct the text."}},
    {ErrorCode::machine_datum_wrong,
     {"Maschinendaten falsch", "Maschinendatum {0} ist nicht lesbar{1}. Zahl berichtigen."},
     {"Machine data wrong", "Machine datum {0} cannot be read{1}. Correct the number."}},
    {ErrorCode::lower_case,
     {"Uebertragung falsch", "Kleinbuchstabe {0} würde die Steuerung überlesen{1}. Groß schreiben."},
     {"Transfer wrong", "The control would skip the small letter {0}{1}. Use capitals."}},
    {ErrorCode::helix_too_steep,
     {kArcWrong, "{0} Schritte sind zu viele neben denen des Bogens{1}. Z verkleinern."},
     {kArcWrongEnglish, "{0} steps are too many beside those of the arc{1}. Use a smaller Z."}},
    {ErrorCode::plane_locked,
     {"Falsche Ebene", "{0}: unter Werkzeugkorrektur bleibt die Ebene{1}. Erst G40 und G45."},
     {"Wrong plane", "{0}: the plane stays while a tool is compensated{1}. First G40 and G45."}},
};

/// Rows are found by their code.
constexpr bool is_complete() {
  std::size_t code = 0;
  for (const Row& row : kRows)
    if (static_cast<std::size_t>(row.code) != code++) return false;
  return code == static_cast<std::size_t>(kLastErrorCode) + 1;
}
static_assert(is_complete(), "one row for each ErrorCode, in their order");

const Texts& texts_of(ErrorCode code, Tongue tongue) {
  const Row& row = kRows[static_cast<std::size_t>(code)];
  return tongue == Tongue::german ? row.german : row.english;
}

/// "F 4000", "G99": the word with what was found; without a word what was found; else the block or "the text".
std::string subject_of(const Error& error, Tongue tongue) {
  std::string text;
  if (error.code == ErrorCode::function_unknown && !error.detail.empty()) return error.detail;  // "G99", "↓18"
  if (error.word == '=')
    text = tongue == Tongue::german ? "Wert" : "Value";
  else if (error.word != 0)
    text = error.word;
  if (error.detail.empty()) {
    if (!text.empty()) return text;
    if (tongue == Tongue::german) return error.block == 0 ? "das Programm" : "der Satz";
    return error.block == 0 ? "the program" : "the block";
  }
  if (error.detail.front() == error.word || text.empty()) return error.detail;  // "G99" and "#64" name the word too
  return text + ' ' + error.detail;
}

}  // namespace

std::string_view monitor_text(ErrorCode code, Tongue tongue) { return texts_of(code, tongue).monitor; }

std::string message_of(const Error& error, Tongue tongue) {
  const std::string_view right = tongue == Tongue::german ? "richtig" : "right";
  const std::string expected = error.expected.empty() ? "" : fmt::format(", {}: {}", right, error.expected);
  std::string message =
      fmt::format(fmt::runtime(texts_of(error.code, tongue).sentence), subject_of(error, tongue), expected);
  const bool is_small = message.front() >= 'a' && message.front() <= 'z';
  if (is_small) message.front() = static_cast<char>(message.front() - ('a' - 'A'));
  return message;
}

std::string explain(const Error& error, Tongue tongue) {
  const std::string place = place_of(error);
  return place.empty() ? message_of(error, tongue) : place + ": " + message_of(error, tongue);
}

std::string place_of(const Error& error) {
  if (error.in_tool_table) return error.block == 0 ? "P0000" : fmt::format("P0000 T{:03}", error.block);
  if (error.program == 0) return error.block == 0 ? "" : fmt::format("N{:03}", error.block);
  if (error.block == 0) return fmt::format("P{:04}", error.program);
  return fmt::format("P{:04} N{:03}", error.program, error.block);
}

}  // namespace cnclab::language
