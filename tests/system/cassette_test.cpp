// A cassette at a real station: made and put in behind key LABOR, written, and read again after the server was killed
// (DEC-33, EXT-010 to EXT-026, SYS-019). It takes as long as the tape does: a dozen seconds are wound, written and
// played.
#include <gmock/gmock.h>

#include "harness/monitor.hpp"
#include "media_seat.hpp"

namespace cnclab::harness {
namespace {

using testing::HasSubstr;

class CassetteSeat : public testing::Test, public MediaSeat {
 protected:
  static void labor(StationProcess& station, const std::vector<std::string>& keys) {
    station.key("LABOR");
    station.wait_for("Kassetten");
    station.key("5");
    station.wait_for("EINGABE neue");
    for (const std::string& key : keys) station.key(key);
  }
};

TEST_F(CassetteSeat, DEC_33_STO_002_ARecordingSurvivesAKilledServer) {
  StationProcess anna = sit_down();
  labor(anna, {"EINGABE"});
  anna.wait_for("1  K01");
  anna.key("1");
  anna.wait_for("1 in den Rekorder einlegen");
  anna.key("1");
  anna.wait_for("im Rekorder, Zähler 000");
  anna.key("3");
  anna.wait_for("Zähler 01");  // past the transparent part: winding is 20 times as fast as holding →
  anna.key("4");
  anna.key("LABOR");
  anna.type("2");
  anna.type("7");
  anna.expect_ok("hold 100 ENTER");
  anna.wait_for("Ausgabe beendet");
  // What is stored later is on disk later: with this block the tape is, too.
  for (const char* const key : {"MENU", "EINGABE", "9", "ENTER", "ENTER", "9", "0", "ENTER", "EINGABE"}) anna.key(key);
  room().crash_and_restart();
  ASSERT_TRUE(eventually(10s, [&] { return anna.send("key MENU") == "ok"; }));
  anna.key("SPEICHER_LOESCHEN");
  anna.type("7");
  anna.key("ENTER");
  anna.wait_for("GELOESCHT");
  anna.key("MENU");
  labor(anna, {"1", "2"});
  anna.wait_for("Zähler 000");
  anna.key("3");
  anna.wait_for("Zähler 00", 2s);
  anna.key("4");
  anna.key("LABOR");
  anna.key("EXTERNE_DATEN");
  anna.type("6");
  anna.type("7");
  anna.key("ENTER");
  anna.wait_for("Gelesen und gespeichert, Programme: 1.", 25s);
  EXPECT_THAT(stored("P0007"), HasSubstr("N003G00Z+5000"));
}

}  // namespace
}  // namespace cnclab::harness
