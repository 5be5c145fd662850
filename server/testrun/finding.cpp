// The sentences of a test run.
#include "testrun/finding.hpp"

#include <fmt/format.h>

#include <cctype>

#include "language/block.hpp"

namespace cnclab::testrun {

namespace {

using Kind = Finding::Kind;

std::string german(const Finding& finding) {
  switch (finding.kind) {
    case Kind::travel_exceeded:
      return fmt::format("Endschalter: {} soll auf {:+.3f}, erlaubt ist {:+.3f} bis {:+.3f}. Start oder Weg ändern.",
                         finding.axis, finding.found, finding.least, finding.most);
    case Kind::rapid_in_material:
      return "Eilgang im Material. Vorher höher fahren oder mit Vorschub (G01) fräsen.";
    case Kind::spindle_off_in_material:
      return "Fräser steht im Material. Vorher die Spindel einschalten (M03).";
    case Kind::tool_missing_in_material:
      return "Kein Werkzeug mit Radius gerufen, aber Material berührt. T in G11 programmieren, P0000 ausfüllen.";
    case Kind::tool_not_in_table:
      return fmt::format("Werkzeug T{:02.0f} fehlt in P0000: keine Korrektur. Zeile T{:03.0f} eingeben.", finding.found,
                         finding.found);
    case Kind::contour_in_parts:
      return fmt::format("Kontur hat mehr als {:.0f} Sätze: ab hier nur in Teilen geprüft. START prüft sie ganz.",
                         finding.most);
    case Kind::endless_loop:
      return "Programm endet nicht: nach der größten Satzzahl abgebrochen. Sprünge prüfen.";
    case Kind::too_long:
      return fmt::format("Programm dauert über {:g} Stunden: abgebrochen. Sprünge prüfen.", finding.most);
    case Kind::error:
      break;
  }
  return {};
}

std::string english(const Finding& finding) {
  switch (finding.kind) {
    case Kind::travel_exceeded:
      return fmt::format("limit switch: {} is to go to {:+.3f}, allowed is {:+.3f} to {:+.3f}. Change start or way.",
                         finding.axis, finding.found, finding.least, finding.most);
    case Kind::rapid_in_material:
      return "rapid in material. Lift the tool before, or cut with a feed (G01).";
    case Kind::spindle_off_in_material:
      return "the cutter stands still in the material. Switch the spindle on before (M03).";
    case Kind::tool_missing_in_material:
      return "material is met, but no tool with a radius was called. Program T in G11, fill P0000.";
    case Kind::tool_not_in_table:
      return fmt::format("tool T{:02.0f} is not in P0000: no compensation. Enter row T{:03.0f}.", finding.found,
                         finding.found);
    case Kind::contour_in_parts:
      return fmt::format(
          "the contour has more than {:.0f} blocks: checked in parts from here on. START checks it whole.",
          finding.most);
    case Kind::endless_loop:
      return "the program does not end: broken off at the block limit. Check the jumps.";
    case Kind::too_long:
      return fmt::format("the program takes more than {:g} hours: broken off. Check the jumps.", finding.most);
    case Kind::error:
      break;
  }
  return {};
}

}  // namespace

std::string explain(const Finding& finding, language::Tongue tongue) {
  if (finding.error) return language::explain(*finding.error, tongue);
  std::string sentence = tongue == language::Tongue::german ? german(finding) : english(finding);
  const bool is_stored = finding.block.program != 0 && finding.block.program <= language::kLastProgram;
  if (!is_stored) {  // by hand, or the line of HANDEINGABE
    sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
    return sentence;
  }
  return fmt::format("P{:04} N{:03}: {}", finding.block.program, finding.block.block, sentence);
}

}  // namespace cnclab::testrun
