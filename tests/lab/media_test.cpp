// Files and the lab around them: a station that is silent, one that gets the machine meanwhile, hardcopies
// (interfaces.md section 7, SYS-013).
#include <gmock/gmock.h>

#include "language/tape.hpp"
#include "shared/digest.hpp"
#include "small_lab.hpp"

namespace cnclab::lab {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class LabMedia : public testing::Test, protected SmallLab {
 protected:
  LabMedia() {
    with_database([](db::Database& database) {
      const db::Author eva{.name = "eva", .station = kSeat, .time_ms = 1};
      const auto put = [&](std::uint16_t program, std::uint16_t number) {
        const std::string block = "N" + std::to_string(1000 + number).substr(1) + "G04H9999";
        database.put_block(database.person("eva")->id, program, {number, block, language::check_code(program, block)},
                           eva);
      };
      put(1, 1);
      for (std::uint16_t number = 1; number <= 700; ++number) put(2, number);
    });
    v1::ClientMessage message;
    message.mutable_login()->set_user("eva");
    message.mutable_login()->set_password("geheim123");
    message.mutable_login()->set_station(kSeat);
    message.mutable_login()->set_has_media(true);
    lab().receive(eva_.visit, message);
    settle_until([this] { return eva_.visit->desk != nullptr; });
    look();
  }

  /// As SmallLab::look, but keeps what concerns files.
  void look() {
    for (const v1::ServerMessage& message : eva_.peer->sent)
      if (message.has_put_media() || message.has_get_media() || message.has_chunk() || message.has_chunk_ack())
        files_.push_back(message);
    SmallLab::look(eva_);
  }
  void pass_ms(std::int64_t milliseconds) {
    constexpr std::int64_t kPoll_ms = 20;
    for (std::int64_t passed = 0; passed < milliseconds; passed += kPoll_ms) {
      advance_ms(kPoll_ms);
      poll();
      look();
    }
  }
  /// Keys going down, in view of what there is to see.
  void strike_all(std::initializer_list<Key> keys) {
    for (const Key key : keys) {
      for (const bool pressed : {true, false}) {
        v1::ClientMessage message;
        auto& event = *message.mutable_key();
        event.set_number(++eva_.number);
        event.add_keys(static_cast<v1::Key>(key));
        event.set_pressed(pressed);
        event.mutable_seen()->set_beat(eva_.beat);
        event.mutable_seen()->set_state(eva_.state);
        lab().receive(eva_.visit, message);
      }
      look();
    }
  }
  void acknowledge(std::uint32_t transfer, std::uint64_t next_offset) {
    v1::ClientMessage message;
    message.mutable_chunk_ack()->set_transfer(transfer);
    message.mutable_chunk_ack()->set_next_offset(next_offset);
    lab().receive(eva_.visit, message);
    look();
  }
  /// The line is cut, and the station comes back with its ticket.
  void cut_and_resume() {
    v1::ClientMessage resume;
    resume.mutable_resume()->set_ticket(eva_.visit->desk->ticket);
    resume.mutable_resume()->set_has_media(true);
    lab().lost(eva_.visit);
    eva_ = call();
    lab().receive(eva_.visit, resume);
    look();
  }
  [[nodiscard]] std::string row(int index) const { return eva_.visit->desk->view.screen.text(index); }
  [[nodiscard]] const v1::ServerMessage& newest() const { return files_.at(files_.size() - 1); }
  /// Takes a file as a station does that has `bytes` of it already, and gives them all.
  std::string take_file(std::string bytes = "") {
    const v1::PutMedia put = newest().put_media();
    acknowledge(put.transfer(), bytes.size());
    while (bytes.size() < put.size()) {
      bytes += newest().chunk().data();
      acknowledge(put.transfer(), bytes.size());
    }
    return bytes;
  }

  Caller eva_ = call();
  std::vector<v1::ServerMessage> files_;
};

TEST_F(LabMedia, AStationThatDoesNotAnswerIsGivenUp) {
  strike_all({Key::EXTERNE_DATEN, Key::D4, Key::D1, Key::ENTER});
  ASSERT_TRUE(newest().has_put_media());
  pass_ms(9'900);
  EXPECT_THAT(row(18), HasSubstr("Die Übertragung läuft"));
  pass_ms(200);
  EXPECT_THAT(row(18), HasSubstr("P0001.nc: der Platz antwortet nicht"));
  EXPECT_TRUE(newest().chunk_ack().abort());
}

TEST_F(LabMedia, SEAT_004_AFileGoesOnAfterACutAndItsRowStands) {
  strike_all({Key::EXTERNE_DATEN, Key::D4, Key::D2, Key::ENTER});
  const v1::PutMedia put = newest().put_media();
  ASSERT_GT(put.size(), 8192U);
  EXPECT_EQ(put.offset(), 0U);
  acknowledge(put.transfer(), 0);
  std::string bytes = newest().chunk().data();
  acknowledge(put.transfer(), bytes.size());  // the second chunk is lost
  cut_and_resume();
  EXPECT_THAT(row(18), HasSubstr("Die Übertragung läuft"));
  const v1::PutMedia again = newest().put_media();
  EXPECT_EQ(again.name(), "P0002.nc");
  EXPECT_EQ(again.offset(), bytes.size());
  EXPECT_EQ(again.digest(), sha256(bytes));
  bytes = take_file(std::move(bytes));
  EXPECT_EQ(bytes.size(), put.size());
  EXPECT_THAT(bytes, StartsWith("P0002\nN001G04H9999\nN002"));
  EXPECT_THAT(bytes, EndsWith("N700G04H9999\n%\n"));
  poll();
  look();
  EXPECT_THAT(row(18), HasSubstr("Ausgabe beendet"));
}

TEST_F(LabMedia, SEAT_004_AStationThatIsSilentAfterACutIsGivenUp) {
  strike_all({Key::EXTERNE_DATEN, Key::D4, Key::D2, Key::ENTER});
  acknowledge(newest().put_media().transfer(), 0);
  acknowledge(1, 4096);
  cut_and_resume();
  ASSERT_EQ(newest().put_media().offset(), 4096U);
  pass_ms(9'900);
  EXPECT_THAT(row(18), HasSubstr("Die Übertragung läuft"));
  pass_ms(200);
  EXPECT_THAT(row(18), HasSubstr("P0002.nc: der Platz antwortet nicht"));
  EXPECT_TRUE(newest().chunk_ack().abort()) << "the station may forget what it has";
}

TEST_F(LabMedia, AUTH_007_TheMachineBreaksATransferOff) {
  Caller console = call(v1::CLIENT_KIND_INSTRUCTOR);
  log_in(console, "lehrer", 0);
  strike_all({Key::EXTERNE_DATEN, Key::D4, Key::D1, Key::ENTER});
  ASSERT_TRUE(newest().has_put_media());
  v1::InstructorRequest request;
  request.mutable_select()->set_station(kSeat);
  ASSERT_TRUE(ask(console, request).error().empty());
  poll();
  look();
  strike_all({Key::START});
  pass_ms(100);
  ASSERT_TRUE(eva_.visit->desk->on_lab_machine);
  EXPECT_TRUE(newest().chunk_ack().abort());
  EXPECT_THAT(row(18), HasSubstr("solange dieser Platz die Maschine hat"));
}

TEST_F(LabMedia, SYS_013_TheScreenIsPrintedInEveryMode) {
  strike_all({Key::EINGABE, Key::LABOR, Key::D4});
  settle_until([this] {
    look();
    return !files_.empty();
  });
  const std::string name = newest().put_media().name();
  EXPECT_THAT(name, testing::MatchesRegex("BILD-[0-9]{8}-[0-9]{6}\\.txt"));
  const std::string text = take_file();
  EXPECT_THAT(text, StartsWith("Platz 7  eva  "));
  EXPECT_THAT(text, HasSubstr("EINGABEMODUS"));
  EXPECT_THAT(text, testing::Not(HasSubstr("LABOR"))) << "the control's screen, not the menu";
  EXPECT_THAT(newest().put_media().name(), HasSubstr(".pdf"));
  EXPECT_THAT(take_file(), StartsWith("%PDF-"));
  poll();
  EXPECT_THAT(row(18), HasSubstr("Der Bildschirm ist gedruckt."));
}

}  // namespace
}  // namespace cnclab::lab
