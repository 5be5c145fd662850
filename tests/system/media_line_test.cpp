// Files on a line that breaks, beside the machine, and with a station that does not keep to the rules (interfaces.md
// section 7).
#include <gmock/gmock.h>

#include "harness/raw_client.hpp"
#include "media_seat.hpp"
#include "shared/frame.hpp"

namespace cnclab::harness {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class MediaLine : public testing::Test, public MediaSeat {};

/// A program whose diskette file, as long as this text, takes four chunks.
std::string long_tape(const std::string& y) {
  std::string tape = "P0008\n";
  for (int block = 1; block <= 600; ++block)
    tape += "N" + std::to_string(1000 + block).substr(1) + "G01X+" + std::to_string(block) + "000Y" + y + "\n";
  return tape + "%\n";
}

/// A student with a long program 8, at a station whose line can be cut where it shall be.
class MediaCut : public MediaLine {
 protected:
  using Way = TcpProxy::Direction;
  MediaCut() {
    room().instructor().must({"program", "send", room().folder().write("tape", long_tape("-123456")).string(), "anna"});
  }
  /// Chooses program 8 on the device and presses →; returns when the line has broken in the midst of the file:
  /// in its third chunk.
  void cut_in_the_midst(const std::string& device, Way way) {
    anna_.type(device);
    anna_.type("8");
    anna_.wait_for("0008");
    line_.cut_after(way, 10'000);
    anna_.press("ENTER");
    ASSERT_TRUE(eventually(5s, [&] { return line_.is_cut(); }));
    static_cast<void>(anna_.reply(5s));  // of the →, which the cut may have taken with it
    before_ = line_.forwarded(way);
  }
  void mend_and_wait_for(const std::string& text) {
    line_.mend();
    // An error as long as the station has not come back.
    ASSERT_TRUE(eventually(8s, [&] { return anna_.send("wait 8000 " + text) == "ok"; }));
  }
  /// Bytes on the wire since the cut, with the new connection's greeting and its first screens.
  [[nodiscard]] std::uint64_t forwarded_since(Way way) const { return line_.forwarded(way) - before_; }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder())) names.push_back(entry.path().filename());
    return names;
  }

  TcpProxy line_{room().server().port()};
  StationProcess anna_ = sit_down(line_.address());
  std::uint64_t before_ = 0;
};

TEST_F(MediaCut, SEAT_004_AFileIsWrittenOnWhereTheLineWasCut) {
  lay("P0008.nc", "old");
  cut_in_the_midst("4", Way::to_client);
  EXPECT_EQ(content("P0008.nc"), "old");
  EXPECT_THAT(files(), ElementsAre("P0008.nc")) << "nothing half is to be seen";
  mend_and_wait_for("Ausgabe beendet");
  EXPECT_TRUE(content("P0008.nc") == long_tape("-123456")) << content("P0008.nc").size();
  EXPECT_THAT(files(), ElementsAre("P0008.nc"));
  EXPECT_LT(forwarded_since(Way::to_client), long_tape("-123456").size()) << "the rest only";
}

TEST_F(MediaCut, SEAT_004_AFileIsReadOnWhereTheLineWasCut) {
  lay("P0008.nc", long_tape("-999999"));
  cut_in_the_midst("8", Way::to_server);
  EXPECT_THAT(stored("P0008"), HasSubstr("N600G01X+600000Y-123456"));
  mend_and_wait_for("Gelesen und gespeichert");
  EXPECT_TRUE(stored("P0008") == long_tape("-999999")) << stored("P0008").substr(0, 100);
  EXPECT_LT(forwarded_since(Way::to_server), long_tape("-999999").size()) << "the rest only";
}

TEST_F(MediaCut, SEAT_004_AFileThatWasReplacedMeanwhileIsReadAsItIsNow) {
  lay("P0008.nc", long_tape("-999999"));
  cut_in_the_midst("8", Way::to_server);
  lay("P0008.nc", long_tape("-777777"));
  mend_and_wait_for("Gelesen und gespeichert");
  EXPECT_TRUE(stored("P0008") == long_tape("-777777")) << stored("P0008").substr(0, 100);
  EXPECT_GT(forwarded_since(Way::to_server), long_tape("-777777").size()) << "from its beginning";
}

TEST_F(MediaCut, SEAT_004_AKilledStationLeavesNothingHalfAndTheNextOneTakesTheFile) {
  lay("P0008.nc", "old");
  cut_in_the_midst("4", Way::to_client);
  anna_.kill_hard();
  EXPECT_EQ(content("P0008.nc"), "old");
  EXPECT_THAT(files(), ElementsAre("P0008.nc"));
  anna_ = sit_down();
  ASSERT_TRUE(eventually(8s, [&] { return content("P0008.nc") == long_tape("-123456"); }));
  EXPECT_THAT(files(), ElementsAre("P0008.nc"));
}

TEST_F(MediaLine, AUTH_007_NoFileTravelsToTheStationThatHasTheMachine) {
  StationProcess anna = sit_down();
  room().give_machine(1, anna);
  anna.key("EXTERNE_DATEN");
  anna.type("4");
  anna.type("7");
  anna.key("ENTER");
  anna.wait_for("keine Dateien, solange dieser Platz die Maschine hat");
  EXPECT_EQ(content("P0007.nc"), "");
  room().instructor().must({"release"});
  anna.wait_for("TRAINING");
  anna.type("4");
  anna.type("7");
  anna.key("ENTER");
  anna.wait_for("Ausgabe beendet");
  EXPECT_NE(content("P0007.nc"), "");
}

/// A station of our own that has a folder and answers as the test wants.
class RawStation {
 public:
  RawStation(MediaSeat& seat, bool has_media) : client_(seat.room().server().port()) {
    if (!client_.greet(v1::CLIENT_KIND_STATION)) throw std::runtime_error("no Welcome");
    v1::ClientMessage login;
    login.mutable_login()->set_user("anna");
    login.mutable_login()->set_password(seat.room().passwords().password_of("anna"));
    login.mutable_login()->set_station(1);
    login.mutable_login()->set_has_media(has_media);
    client_.send(login);
    if (!client_.read_until(v1::ServerMessage::kLogin)) throw std::runtime_error("no login");
  }
  void key(v1::Key key) {
    v1::ClientMessage message;
    message.mutable_key()->set_number(++keys_);
    message.mutable_key()->add_keys(key);
    message.mutable_key()->set_pressed(true);
    client_.send(message);
  }
  void send_off(v1::Key device, v1::Key program) {
    for (const v1::Key each : {v1::KEY_EXTERNE_DATEN, device, program, v1::KEY_ENTER}) key(each);
  }
  [[nodiscard]] RawClient& client() { return client_; }
  void send_chunk(std::uint32_t transfer, std::uint64_t offset, const std::string& data, bool is_last) {
    v1::ClientMessage message;
    message.mutable_chunk()->set_transfer(transfer);
    message.mutable_chunk()->set_offset(offset);
    message.mutable_chunk()->set_data(data);
    message.mutable_chunk()->set_is_last(is_last);
    client_.send(message);
  }

 private:
  RawClient client_;
  std::uint64_t keys_ = 0;
};

TEST_F(MediaLine, SEC_006_AStationThatSendsUnaskedIsHungUpAndNothingIsStored) {
  const std::string before = stored("P0007");
  {
    RawStation station(*this, true);
    station.send_off(v1::KEY_8, v1::KEY_7);
    const auto asked = station.client().read_until(v1::ServerMessage::kGetMedia);
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked->get_media().names(0), "P0007.nc");
    station.send_chunk(asked->get_media().transfer(), 7, "P0007N001G00X+1%", true);
    EXPECT_TRUE(station.client().is_closed_within(5s));
  }
  EXPECT_EQ(stored("P0007"), before);
  EXPECT_TRUE(room().server().is_running());
}

TEST_F(MediaLine, D_107_StopBreaksATransferOffAndTheStationIsTold) {
  RawStation station(*this, true);
  station.send_off(v1::KEY_4, v1::KEY_7);
  const auto asked = station.client().read_until(v1::ServerMessage::kPutMedia);
  ASSERT_TRUE(asked);
  station.key(v1::KEY_STOP);
  const auto cancelled = station.client().read_until(v1::ServerMessage::kChunkAck);
  ASSERT_TRUE(cancelled);
  EXPECT_EQ(cancelled->chunk_ack().transfer(), asked->put_media().transfer());
  EXPECT_TRUE(cancelled->chunk_ack().abort());
  for (const v1::Key key : {v1::KEY_4, v1::KEY_7, v1::KEY_ENTER}) station.key(key);
  const auto again = station.client().read_until(v1::ServerMessage::kPutMedia);
  ASSERT_TRUE(again) << "and the next transfer begins at once";
  EXPECT_GT(again->put_media().transfer(), asked->put_media().transfer());
}

TEST_F(MediaLine, D_109_WithoutAFolderTheDeviceIsNotFitted) {
  RawStation station(*this, false);
  station.send_off(v1::KEY_4, v1::KEY_7);
  EXPECT_FALSE(station.client().read_until(v1::ServerMessage::kPutMedia, 300ms));
}

}  // namespace
}  // namespace cnclab::harness
