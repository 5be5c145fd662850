// Files and the lab around them: a station that is silent, one that gets the machine meanwhile, hardcopies
// (interfaces.md section 7, SYS-013).
#include <gmock/gmock.h>

#include "language/tape.hpp"
#include "small_lab.hpp"

namespace cnclab::lab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr std::uint32_t kSeat = 7;

class LabMedia : public testing::Test, protected SmallLab {
 protected:
  LabMedia() {
    with_database([](db::Database& database) {
      const std::string block = "N001G04H9999";
      database.put_block(database.person("eva")->id, 1, {1, block, language::check_code(1, block)},
                         {.name = "eva", .station = kSeat, .time_ms = 1});
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
      if (message.has_put_media() || message.has_chunk() || message.has_chunk_ack()) files_.push_back(message);
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
  [[nodiscard]] std::string row(int index) const { return eva_.visit->desk->view.screen.text(index); }
  [[nodiscard]] const v1::ServerMessage& newest() const { return files_.at(files_.size() - 1); }
  /// Takes a file as a station does, and gives its bytes.
  std::string take_file() {
    const v1::PutMedia put = newest().put_media();
    std::string bytes;
    acknowledge(put.transfer(), 0);
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
