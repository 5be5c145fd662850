// The table of texts, and how values are filled into them.
#include "panel/texts.hpp"

namespace cnclab::panel {

namespace {

constexpr std::array<TextRow, kTexts> kTable{{
    {Text::program_number, "PROGRAMM NR ", "PROGRAM NO "},
    {Text::in_preparation, "IN VORBEREITUNG", "IN PREPARATION"},
    {Text::limit_switch, "Endschalter", "Limit switch"},
    {Text::not_stored, "Nicht gespeichert", "Not stored"},
    {Text::no_programs, "Keine Programme", "No programs"},
    {Text::program_erased, "PROGRAMM GELOESCHT", "PROGRAM ERASED"},
    {Text::memory_erased, "ALLE PROGRAMME GELOESCHT", "ALL PROGRAMS ERASED"},
    {Text::all_programs_hint, "ALLE PROGRAMME: TASTE C UND DANACH →!", "ALL PROGRAMS: KEY C AND THEN →!"},
    {Text::menu_hand, "Handbetrieb", "Manual operation"},
    {Text::menu_hand_input, "Handeingabe", "Manual data input"},
    {Text::menu_teach_in, "Teach In", "Teach In"},
    {Text::menu_automat, "Automat", "Automatic"},
    {Text::menu_external_data, "Externe Daten", "External data"},
    {Text::menu_graphics, "Grafik", "Graphics"},
    {Text::menu_erase_memory, "Speicher Löschen", "Erase memory"},
    {Text::menu_editor, "Eingabemodus", "Program entry"},

    {Text::side_seat, "Platz {}", "Seat {}"},
    {Text::side_training, "TRAINING", "TRAINING"},
    {Text::side_machine, "MASCHINE", "MACHINE"},
    {Text::side_controller, "Maschine:", "Machine:"},
    {Text::side_nobody, "niemand", "nobody"},
    {Text::side_unreferenced, "UNREF.", "UNREF."},
    {Text::side_override, "Poti  {} %", "Feed  {} %"},
    {Text::side_start, "START", "START"},
    {Text::side_single, "EINZELS.", "SINGLE"},
    {Text::side_spindle, "SPINDEL", "SPINDLE"},
    {Text::side_coolant, "KUEHLM.", "COOLANT"},
    {Text::side_limit, "ENDSCH.", "LIMIT SW"},
    {Text::side_message, "Meldung {}.", "Hand {}."},
    {Text::side_halt, "HALT {}", "HALT {}"},

    {Text::all_keys, "? alle Tasten", "? all keys"},

    {Text::help_open_menu, "Menü", "menu"},
    {Text::help_digits, "Ziffern", "figures"},
    {Text::help_point, "Punkt", "point"},
    {Text::help_sign, "Vorzeichen", "sign"},
    {Text::help_clear, "löschen", "clear"},
    {Text::help_confirm, "bestätigen", "confirm"},
    {Text::help_first_blocks, "erste Sätze", "first blocks"},
    {Text::help_page, "Sätze ab N", "blocks from N"},
    {Text::help_search, "Satz N laden", "load block N"},
    {Text::help_store, "speichern", "store"},
    {Text::help_erase_block, "Satz löschen", "delete block"},
    {Text::help_parametric, "Parameterfunktion", "parametric function"},
    {Text::help_parameter, "Parameter #", "parameter #"},
    {Text::help_next_word, "nächstes Wort", "next word"},
    {Text::help_words, "Wörter", "words"},
    {Text::help_start, "Start", "start"},
    {Text::help_stop, "Halt", "stop"},
    {Text::help_single, "Einzelsatz", "single block"},
    {Text::help_directions, "Richtung wählen", "choose directions"},
    {Text::help_move, "Verfahren", "move"},
    {Text::help_drop_directions, "Richtungen löschen", "drop directions"},
    {Text::help_reference, "Referenzpunkt", "reference point"},
    {Text::help_istwert, "Istwert setzen", "set actual value"},
    {Text::help_istwert_off, "Istwert beenden", "end actual value"},
    {Text::help_axis, "Achse wählen", "choose axis"},
    {Text::help_spindle, "Spindel", "spindle"},
    {Text::help_coolant, "Kühlmittel", "coolant"},
    {Text::help_stop_to_menu, "Abbruch, Menü", "abandon, menu"},
    {Text::help_execute, "ausführen", "execute"},
    {Text::help_rest, "Rest fahren", "do the rest"},
    {Text::help_erase_program, "Programm löschen", "erase program"},
    {Text::help_erase_choose_all, "alle Programme", "all programs"},
    {Text::help_erase_all, "alles löschen", "erase everything"},
    {Text::help_next_datum, "nächstes Datum", "next datum"},
    {Text::help_test_memory, "Test beginnen", "begin the test"},
    {Text::help_destroy_memory, "ja, Speicher zerstören", "yes, destroy the memory"},

    {Text::wait_menu, "Betriebsart mit ihrer Taste wählen.", "Choose an operating mode with its key."},
    {Text::wait_coming, "{} ist in Vorbereitung. Mit MENU zurück.", "{} is in preparation. MENU leads back."},
    {Text::wait_editor_program, "P{} mit → öffnen (↓: ab dem ersten Satz), oder C und eine andere Nummer.",
     "Open P{} with → (↓: from the first block), or C and another number."},
    {Text::wait_editor_empty, "Programmnummer tippen; → oder ↓ zeigt alle Programme.",
     "Type a program number; → or ↓ lists all programs."},
    {Text::wait_overview, "Alle Programme. ↓ blättert, Ziffern wählen ein Programm.",
     "All programs. ↓ pages on, figures choose a program."},
    {Text::wait_number, "Satznummer mit → bestätigen, ↓ blättert, SATZ SUCHEN lädt den Satz.",
     "Confirm the block number with →, ↓ pages, SATZ SUCHEN loads the block."},
    {Text::wait_function, "Funktion tippen (zwei Ziffern), dann → für ihre Wörter.",
     "Type the function (two figures), then → for its words."},
    {Text::wait_word, "Wort {} eingeben, → zum nächsten, EINGABE speichert den Satz.",
     "Enter word {}, → for the next one, EINGABE stores the block."},
    {Text::wait_store, "Der Satz wird gespeichert …", "The block is being stored …"},
    {Text::wait_automat_program, "P{} mit → bestätigen, oder C und eine andere Nummer.",
     "Confirm P{} with →, or C and another number."},
    {Text::wait_automat_block, "Startsatz mit → bestätigen, oder C und eine andere Nummer.",
     "Confirm the start block with →, or C and another number."},
    {Text::wait_ready, "Bereit: START beginnt P{} bei N{}.", "Ready: START begins P{} at N{}."},
    {Text::wait_ready_rebuilt, "Ab N{}: G, F, S, T aus den Sätzen davor übernommen; die Position bleibt, wie sie ist.",
     "From N{}: G, F, S, T taken from the blocks before; the position stays where it is."},
    {Text::wait_running, "Programm läuft: P{} N{}. STOP hält auf der Rampe an.",
     "Program runs: P{} N{}. STOP halts on the ramp."},
    {Text::wait_stopping, "Die Achsen bremsen bei P{} N{}.", "The axes brake at P{} N{}."},
    {Text::wait_stopped, "Angehalten in P{} N{}. START fährt weiter, MENU bricht ab.",
     "Stopped in P{} N{}. START goes on, MENU abandons the run."},
    {Text::wait_single, "Einzelsatz: START führt P{} N{} aus, MENU bricht ab.",
     "Single block: START executes P{} N{}, MENU abandons the run."},
    {Text::wait_halt, "Programmierter Halt in P{} N{}. START setzt fort, STOP hält an.",
     "Programmed halt in P{} N{}. START goes on, STOP stops."},
    {Text::wait_input, "P{} N{} wartet auf einen Eingang. START hebt das Warten auf.",
     "P{} N{} waits for an input. START ends the waiting."},
    {Text::wait_ended, "Programm beendet. START beginnt wieder bei N{}.", "Program ended. START begins again at N{}."},
    {Text::wait_hand, "Richtung(en) wählen, dann START: die Achsen fahren, so schnell wie das Potentiometer steht.",
     "Choose direction(s), then START: the axes move as fast as the potentiometer says."},
    {Text::wait_chosen, "Gewählt: {}. START verfährt, REFERENZ fährt bis zu den Endschaltern.",
     "Chosen: {}. START moves, REFERENZ drives to the limit switches."},
    {Text::wait_hand_moving,
     "Die Achsen fahren. STOP hält auf der Rampe an, das Potentiometer stellt die Geschwindigkeit.",
     "The axes move. STOP halts on the ramp, the potentiometer sets the speed."},
    {Text::wait_axes_brake, "Die Achsen bremsen.", "The axes brake."},
    {Text::wait_reference, "Referenzpunkt wird angefahren: bis zum Endschalter und 1 mm zurück. STOP bricht ab (Menü).",
     "Driving to the reference point: to the switch and 1 mm back. STOP abandons it (menu)."},
    {Text::wait_referenced, "Referenzpunkt erreicht: der Istwert der gefahrenen Achsen ist 0.",
     "Reference point reached: the actual value of the driven axes is 0."},
    {Text::wait_off_switch, "Endschalter aktiv: nur vom Schalter weg verfahren.",
     "Limit switch active: only moves away from the switch are possible."},
    {Text::wait_istwert_axis, "Istwert setzen: Achse mit einer Richtungstaste wählen, ISTWERT beendet.",
     "Set actual value: choose the axis with a direction key, ISTWERT ends."},
    {Text::wait_istwert_value, "Istwert {}: Wert tippen, C löscht, ISTWERT beendet.",
     "Actual value {}: type the value, C clears, ISTWERT ends."},
    {Text::wait_input_function, "G-Funktion tippen (zwei Ziffern) oder mit → zu den Wörtern; START führt den Satz aus.",
     "Type a G function (two figures) or go to its words with →; START executes the block."},
    {Text::wait_input_word, "Wort {} eingeben, → zum nächsten, START führt den Satz aus.",
     "Enter word {}, → for the next one, START executes the block."},
    {Text::wait_input_running, "Der Satz wird ausgeführt. STOP hält auf der Rampe an.",
     "The block is being executed. STOP halts on the ramp."},
    {Text::wait_input_waiting, "Der Satz wartet auf einen Eingang. START hebt das Warten auf.",
     "The block waits for an input. START ends the waiting."},
    {Text::wait_input_rest, "Angehalten: START fährt den Rest des Satzes, MENU bricht ihn ab.",
     "Stopped: START does the rest of the block, MENU abandons it."},
    {Text::wait_input_done, "Ausgeführt. START wiederholt den Satz, → wählt ein Wort, MENU beendet.",
     "Done. START repeats the block, → chooses a word, MENU ends."},
    {Text::wait_teach_program, "P{} wird im Teach In erstellt: → bestätigt, oder C und eine andere Nummer.",
     "P{} is to be made by Teach In: confirm with →, or C and another number."},
    {Text::wait_teach_empty,
     "Richtung(en) wählen und mit START verfahren; nach STOP steht der Weg im Satz. → wählt ein Wort.",
     "Choose direction(s) and move with START; after STOP the way stands in the block. → chooses a word."},
    {Text::wait_teach_filled, "EINGABE speichert den Satz; weiter verfahren ändert X, Y, Z; → ergänzt F, S, T, M.",
     "EINGABE stores the block; moving on changes X, Y, Z; → adds F, S, T, M."},
    {Text::wait_erase, "Nummer des Programms tippen, das gelöscht werden soll.",
     "Type the number of the program to be erased."},
    {Text::wait_erase_program, "→ löscht P{}. Eine andere Nummer einfach tippen, MENU beendet.",
     "→ erases P{}. Just type another number, MENU ends."},
    {Text::wait_erase_all,
     "Achtung: → löscht ALLE Programme und setzt die Maschinendaten zurück. Ziffern oder MENU: doch nicht.",
     "Attention: → erases ALL programs and resets the machine data. Figures or MENU: rather not."},
    {Text::wait_erasing, "Es wird gelöscht …", "Erasing …"},

    {Text::said_limit_switch, "Endschalter {} erreicht: Programm abgebrochen, Achse freigefahren, ihr Istwert ist 0.",
     "Limit switch {} reached: program abandoned, axis driven free, its actual value is 0."},
    {Text::said_power_off, "Die Antriebe wurden abgeschaltet: abgebrochen.",
     "The drives were switched off: abandoned."},
    {Text::said_machine_halt, "MASCHINE HALT wurde gedrückt: abgebrochen.", "MASCHINE HALT was pressed: abandoned."},
    {Text::said_lease, "Die Maschine wurde diesem Platz genommen: abgebrochen.",
     "The machine was taken from this seat: abandoned."},
    {Text::said_start_refused, "START wurde nicht angenommen: Maschine gesperrt oder abgeschaltet.",
     "START was not accepted: the machine is locked or switched off."},
    {Text::said_not_at_rest, "Die Maschine steht noch nicht: gleich noch einmal START.",
     "The machine does not stand still yet: press START again."},
    {Text::said_no_machine, "Es ist keine Maschine angeschlossen.", "No machine is connected."},
    {Text::said_failed_before, "{} Erst den Satz ändern (MENU, EINGABE) oder anders starten.",
     "{} First change the block (MENU, EINGABE) or start elsewhere."},
    {Text::said_not_stored, "Nicht gespeichert: {}", "Not stored: {}"},
    {Text::said_no_more_blocks, "Ab hier gibt es keine weiteren Sätze.", "There are no further blocks from here."},
    {Text::said_not_loaded, "Erst den Satz mit SATZ SUCHEN laden, dann löschen.",
     "First load the block with SATZ SUCHEN, then delete it."},
    {Text::said_tool_number, "Werkzeugnummern gehen von T001 bis T099.", "Tool numbers go from T001 to T099."},
    {Text::said_overflow_n999, "Kein Platz zum Einfügen: der letzte Satz würde N999 überschreiten.",
     "No room to insert: the last block would pass N999."},
    {Text::said_parameter_unfinished, "Im Wort {} fehlt die Parameternummer 00 bis 69.",
     "Word {} lacks its parameter number 00 to 69."},
    {Text::said_code_missing, "Die Funktion fehlt: zwei Ziffern tippen, dann → für ihre Wörter.",
     "The function is missing: type two figures, then → for its words."},
    {Text::said_block_number, "Satznummern gehen von N001 bis N999.", "Block numbers go from N001 to N999."},
    {Text::said_number_missing, "Es fehlt eine Nummer: Ziffern tippen, dann →.",
     "A number is missing: type figures, then →."},
    {Text::said_connected, "Die Maschine hat gewechselt: angefangene Läufe sind abgebrochen.",
     "The machine has changed: runs that had begun are abandoned."},
    {Text::said_not_on_lab_machine, "Das geht nicht, solange dieser Platz die Maschine im Raum hat.",
     "This is not possible while this seat has the lab's machine."},
    {Text::said_no_direction, "Erst mit den Tasten ±X ±Y ±Z eine Richtung wählen.",
     "First choose a direction with the keys ±X ±Y ±Z."},
    {Text::said_towards_switch, "Nicht auf den Endschalter zu: nur die Gegenrichtung ist frei.",
     "Not towards the limit switch: only the opposite direction is free."},
    {Text::said_switch_stuck, "Der Endschalter wurde nicht wieder frei: Referenzfahrt abgebrochen.",
     "The limit switch did not become free again: reference run abandoned."},
    {Text::said_unreferenced, "Die Maschine ist nicht referenziert: erst in HANDBETRIEB die Referenzpunkte anfahren.",
     "The machine is not referenced: first drive to the reference points in HANDBETRIEB."},
    {Text::said_barred, "G04, G20 bis G23, M00, M01 und M02 werden in der Handeingabe nicht ausgeführt.",
     "G04, G20 to G23, M00, M01 and M02 are not executed in manual data input."},
    {Text::said_number_for_teaching, "Teach In braucht eine Programmnummer von P0001 bis P9999.",
     "Teach In needs a program number from P0001 to P9999."},
    {Text::said_program_full, "Das Programm geht schon bis N999: eine andere Nummer nehmen.",
     "The program already reaches N999: use another number."},
    {Text::said_nothing_to_erase, "Erst eine Programmnummer tippen. Alle Programme: Taste C und danach →.",
     "First type a program number. All programs: key C and then →."},
    {Text::hint_running, "{} wirkt hier nicht: während des Laufs nur STOP und EINZELSATZ.",
     "{} has no effect here: during the run only STOP and EINZELSATZ."},
    {Text::hint_waiting, "{} wirkt hier nicht: das Programm wartet auf START oder STOP.",
     "{} has no effect here: the program waits for START or STOP."},
    {Text::hint_menu_first, "{} wirkt nur im Menü: erst MENU drücken.", "{} works in the menu only: press MENU first."},
    {Text::hint_no_effect, "{} hat hier keine Wirkung.", "{} has no effect here."},
    {Text::hint_storing, "{} wirkt nicht, solange gespeichert wird.",
     "{} has no effect while a block is being stored."},
    {Text::hint_coming, "{} ist in Vorbereitung: hier führt nur MENU zurück.",
     "{} is in preparation: only MENU leads back from here."},
    {Text::hint_single_off, "EINZELSATZ lässt sich erst nach STOP ausschalten.",
     "EINZELSATZ can be switched off only after STOP."},
    {Text::hint_moving, "{} wirkt hier nicht: während der Fahrt nur STOP.",
     "{} has no effect here: while the axes move only STOP."},
    {Text::hint_rest, "{} wirkt hier nicht: erst START (Rest des Satzes) oder MENU.",
     "{} has no effect here: first START (rest of the block) or MENU."},
}};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < kTexts; ++i)
    if (kTable[i].id != static_cast<Text>(i)) return false;
  return true;
}
static_assert(is_in_order(), "the rows stand in the order of Text");

struct ModeNames {
  std::string_view german, english;
};

constexpr std::array<ModeNames, kModes> kTitles{{
    {"", ""},
    {"HANDBETRIEB", "MANUAL OPERATION"},
    {"HANDEINGABE", "MANUAL INPUT"},
    {"TEACH IN", "TEACH IN"},
    {"AUTOMAT", "AUTOMATIC"},
    {"EXTERNE DATEN", "EXTERNAL DATA"},
    {"GRAFIK", "GRAPHICS"},
    {"SPEICHER LOESCHEN", "ERASE MEMORY"},
    {"EINGABEMODUS", "PROGRAM ENTRY"},
    {"MASCHINENDATEN", "MACHINE DATA"},
    {"SPEICHERTEST", "MEMORY TEST"},
}};

constexpr std::array<std::string_view, kKeys + 1> kLabels{"",
                                                          "HAND",
                                                          "START",
                                                          "STOP",
                                                          "+X",
                                                          "-X",
                                                          "+Y",
                                                          "-Y",
                                                          "+Z",
                                                          "-Z",
                                                          "ISTWERT",
                                                          "FRÄSER",
                                                          "KÜHLMITTEL",
                                                          "AUTOMAT",
                                                          "GRAFIK",
                                                          "MENU",
                                                          "EINZELSATZ",
                                                          "REFERENZ",
                                                          "EXTERNE DATEN",
                                                          "TEACH IN",
                                                          "SATZ SUCHEN",
                                                          "SPEICHER LÖSCHEN",
                                                          "EINGABE",
                                                          "HANDEINGABE",
                                                          "SATZ LÖSCHEN",
                                                          "0",
                                                          "1",
                                                          "2",
                                                          "3",
                                                          "4",
                                                          "5",
                                                          "6",
                                                          "7",
                                                          "8",
                                                          "9",
                                                          ".",
                                                          "+/-",
                                                          "↓",
                                                          "C",
                                                          "→",
                                                          "RESET",
                                                          "MELDUNG",
                                                          "MASCHINE HALT",
                                                          "LABOR"};

}  // namespace

const std::array<TextRow, kTexts>& text_table() { return kTable; }

std::string_view text(Text id, language::Tongue tongue) {
  const TextRow& row = kTable[static_cast<std::size_t>(id)];
  return tongue == language::Tongue::german ? row.german : row.english;
}

std::string text(Text id, language::Tongue tongue, std::initializer_list<std::string_view> values) {
  std::string filled;
  std::string_view rest = text(id, tongue);
  for (const std::string_view value : values) {
    const std::size_t place = rest.find("{}");
    if (place == std::string_view::npos) break;
    filled.append(rest.substr(0, place)).append(value);
    rest.remove_prefix(place + 2);
  }
  return filled.append(rest);
}

std::string_view title_of(Mode mode, language::Tongue tongue) {
  const ModeNames& names = kTitles[static_cast<std::size_t>(mode)];
  return tongue == language::Tongue::german ? names.german : names.english;
}

std::string_view name_of(Mode mode) {
  return mode == Mode::menu ? std::string_view("MENU") : kTitles[static_cast<std::size_t>(mode)].german;
}

std::string_view label_of(Key key) {
  const auto index = static_cast<std::size_t>(key);
  return index < kLabels.size() ? kLabels[index] : std::string_view();
}

}  // namespace cnclab::panel
