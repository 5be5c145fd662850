// Files on a line that breaks, beside the machine, and with a station that does not keep to the rules (interfaces.md
// section 7).
#include <gmock/gmock.h>

#include "harness/raw_client.hpp"
#include "media_seat.hpp"
#include "shared/frame.hpp"

namespace cnclab::harness {
namespace {

using testing::HasSubstr;

class MediaLine : public testing::Test, public MediaSeat {};

/// A program whose diskette file takes several chunks.
std::string long_tape() {
  std::string tape = "P0008";
  for (int block = 1; block <= 600; ++block)
    tape += "N" + std::to_string(1000 + block).substr(1) + "G01X+" + std::to_string(block) + "000Y-123456\n";
  return tape + "%";
}

TEST_F(MediaLine, SEAT_004_AFileIsRepeatedCleanlyAfterACutLine) {
  room().add_student("berta");
  room().instructor().must({"program", "send", room().folder().write("tape", long_tape()).string(), "anna"});
  TcpProxy line(room().server().port());
  StationProcess anna = sit_down(line.address());
  anna.type("4");
  anna.type("8");
  anna.wait_for("0008");
  lay("P0008.nc", "old");
  line.limit(10'000);  // 17 KB take a while
  anna.press("ENTER");
  // The file is being written aside: neither the old nor the new one is touched by the cut.
  ASSERT_TRUE(eventually(8s, [&] {
    for (const auto& entry : std::filesystem::directory_iterator(folder()))
      if (entry.path().filename().string().starts_with(".cnclab-") && entry.file_size() > 0) return true;
    return false;
  }));
  line.cut();
  EXPECT_EQ(content("P0008.nc"), "old");
  line.limit(0);
  line.mend();
  ASSERT_TRUE(eventually(10s, [&] { return content("P0008.nc") != "old"; }));
  EXPECT_THAT(content("P0008.nc"), HasSubstr("\nN600G01X+600000Y-123456\n%\n"));
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    EXPECT_EQ(entry.path().filename().string().find(".part"), std::string::npos) << entry.path();
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
