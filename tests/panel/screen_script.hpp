// Scripts of keys and pictures: tests/panel/screens/*.txt.
//
//   # comment                                 what the script shows, with requirement IDs
//   english | hints off | model 3250 | memory 16384 | data 3 60000 | lab | load P0001N001…%     before the first key
//   clock 11:41:27 02/03/82                   time in the header
//   keys AUTOMAT ENTER ENTER+RESET            pressed one after the other
//   type 25.5                                 digits, point, - for the sign key
//   pot 50 · damage P0001 N003 · store fails SENTENCE · input on|off
//   media on | cassette                        a place for files at the station; an empty cassette in the recorder
//   hold 6000 ENTER                           a key held so long, milliseconds
//   run 250                                   virtual milliseconds
//   rest                                      until the control is in STOP state
//   until TEXT                                until TEXT stands somewhere on the screen
//   monitor 13 □006                           that line of the 64×16 monitor, from 0
//   row 18 TEXT                               that row of the 24×80 screen
//   marks 3 1 5, 4 1 4                        exactly these cells are inverse: row column length
//   beeps 1                                   tones since the last look
//   screen                                    then 24 lines: the whole picture
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cnclab::panel {

/// Runs a script; differences are test failures. With `redraw` pictures are replaced by what is drawn, and the new text
/// of the script is returned for review (CNCLAB_REDRAW=1).
std::string run_screen_script(const std::filesystem::path& file, bool redraw);

}  // namespace cnclab::panel
