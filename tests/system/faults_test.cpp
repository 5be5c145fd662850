// What fails in a real lab, made to fail: discs, locks, processes and lines. The table in docs/administration.md says
// what the lab does about each; its rows name these tests.
#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <csignal>
#include <utility>

#include "harness/classroom.hpp"
#include "harness/failure.hpp"
#include "harness/raw_client.hpp"
#include "programs.hpp"

namespace cnclab::harness {
namespace {

using testing::HasSubstr;

/// While it lives, no file of the process can be written: as on a full disk, for that process alone.
class NoRoom {
 public:
  explicit NoRoom(pid_t process) : process_(process) {
    const rlimit none{0, RLIM_INFINITY};
    if (::prlimit(process_, RLIMIT_FSIZE, &none, &former_) != 0) throw Failure("prlimit");
  }
  ~NoRoom() { ::prlimit(process_, RLIMIT_FSIZE, &former_, nullptr); }
  NoRoom(const NoRoom&) = delete;
  NoRoom& operator=(const NoRoom&) = delete;

 private:
  pid_t process_;
  rlimit former_{};
};

/// Another program that writes to the lab's database.
class Outsider {
 public:
  explicit Outsider(const std::filesystem::path& data)
      : database_((data / "cnclab.db").string(), SQLite::OPEN_READWRITE, kPatience_ms) {
    database_.exec("BEGIN EXCLUSIVE");
  }
  void let_go() { database_.exec("ROLLBACK"); }

 private:
  static constexpr int kPatience_ms = 5000;
  SQLite::Database database_;
};

/// anna keys in at station 1, otto's endless program has the machine at station 2.
class Faults : public testing::Test {
 protected:
  Faults() {
    room_.add_student("anna");
    room_.add_student("otto", {kEndless});
    anna_.emplace(room_.seat(1, "anna"));
    otto_.emplace(room_.seat(2, "otto"));
  }
  nlohmann::json machine() { return room_.instructor().status()["machine"]; }
  void run_on_machine() {
    room_.give_machine(2, *otto_);
    otto_->key("AUTOMAT ENTER ENTER START");
    ASSERT_TRUE(eventually(kLimit, [&] { return machine()["x"] > 1; })) << otto_->text();
  }
  bool stands_with_nobody() {
    return eventually(kLimit, [&] {
      const auto status = room_.instructor().status();
      return status["selected"] == 0 && status["machine"]["state"] == "standstill" && status["machine"]["spindle"] == 0;
    });
  }
  /// Everything but EINGABE for block `number`.
  void key_in(int number) {
    anna_->key(number == 1 ? "EINGABE ENTER ENTER ENTER" : "ENTER ENTER");
    anna_->type(std::to_string(number));
  }
  std::string program() { return room_.instructor().must({"program", "show", "anna", "P0001"}).output; }

  Classroom room_;
  std::optional<StationProcess> anna_, otto_;
};

TEST_F(Faults, STO_009_a_full_disk_is_told_on_the_screen_that_stores_and_the_machine_runs_on) {
  run_on_machine();
  key_in(1);
  anna_->key("EINGABE");
  key_in(2);
  {
    const NoRoom full(room_.server().pid());
    anna_->key("EINGABE");
    EXPECT_THAT(anna_->text(), HasSubstr("Platte des Servers voll"));
    const double before = machine()["x"];
    EXPECT_TRUE(eventually(kLimit, [&] { return machine()["x"] != before; }));
    EXPECT_FALSE(otto_->shows("Nicht gespeichert"));
  }
  EXPECT_THAT(program(), testing::Not(HasSubstr("N002")));
  anna_->key("EINGABE");
  EXPECT_EQ(program(), "P0001\nN001G00X+1000\nN002G00X+2000\n%\n");
  EXPECT_EQ(room_.instructor().status()["selected"], 2);
  EXPECT_TRUE(eventually(kLimit, [&] {  // the journal, too, wrote what it had kept meanwhile
    const auto entries = room_.instructor().must({"journal", "anna"}).objects;
    return std::ranges::count_if(entries, [](const auto& entry) { return entry["detail"] == "EINGABE"; }) == 4;
  }));
}

TEST_F(Faults, STO_009_a_lock_that_is_let_go_delays_EINGABE_and_nobody_else) {
  run_on_machine();
  key_in(1);
  Outsider outsider(room_.data());
  anna_->press("EINGABE");
  otto_->key("STOP");
  otto_->wait_for("START    ○");
  EXPECT_EQ(anna_->reply(0ms), std::nullopt) << "acknowledged before it was stored";
  outsider.let_go();
  EXPECT_EQ(anna_->reply(kLimit), "ok");
  EXPECT_EQ(program(), "P0001\nN001G00X+1000\n%\n");
}

// Waits for the busy time-out of 5 s.
TEST_F(Faults, STO_009_a_lock_that_lasts_is_told_and_EINGABE_works_again_afterwards) {
  key_in(1);
  Outsider outsider(room_.data());
  anna_->key("EINGABE");
  EXPECT_THAT(anna_->text(), HasSubstr("Datenbank belegt"));
  outsider.let_go();
  anna_->key("EINGABE");
  EXPECT_EQ(program(), "P0001\nN001G00X+1000\n%\n");
}

TEST_F(Faults, AUTH_007_a_server_that_stood_still_finds_its_lease_expired_and_the_machine_stops) {
  run_on_machine();
  ::kill(room_.server().pid(), SIGSTOP);
  EXPECT_EQ(otto_->send("wait 1200 no such text"), "timeout");  // longer than the lease lives without a sign of life
  ::kill(room_.server().pid(), SIGCONT);
  EXPECT_TRUE(stands_with_nobody());
  otto_->wait_for("TRAINING");
  EXPECT_GT(room_.instructor().status()["ticks"]["very_late"], 0);
  EXPECT_THAT(room_.server().log(), testing::HasSubstr("began more than 5 ms late"));
}

TEST_F(Faults, AUTH_012_a_server_killed_in_motion_comes_back_with_nobody_and_nothing_moving) {
  run_on_machine();
  const double before = room_.instructor().status()["lease"];
  room_.crash_and_restart();
  EXPECT_TRUE(stands_with_nobody());
  const auto status = room_.instructor().status();
  EXPECT_EQ(status["machine"]["referenced"], false);
  EXPECT_GE(status["lease"], before);
  ASSERT_TRUE(eventually(10s, [&] { return otto_->send("wait 500 TRAINING") == "ok"; }));
  otto_->key("START");
  EXPECT_TRUE(stands_with_nobody());
}

TEST_F(Faults, SEAT_005_a_server_killed_in_motion_is_told_on_every_station) {
  run_on_machine();
  room_.server().kill_hard();
  for (StationProcess* station : {&*anna_, &*otto_})
    EXPECT_TRUE(eventually(kLimit, [&] { return station->send("key STOP") == "error VERBINDUNG VERLOREN"; }));
}

TEST_F(Faults, LOAD_002_a_station_that_reads_again_gets_the_newest_screen_at_once) {
  TcpProxy line(room_.server().port());
  anna_->quit();
  anna_.emplace(room_.seat_behind(line, 1, "anna"));
  line.stall_answers();
  for (const char* text : {"eins", "zwei", "drei"}) room_.instructor().must({"message", "1", text});
  line.mend();
  anna_->wait_for("drei", 2s);
  EXPECT_FALSE(anna_->shows("zwei"));
}

TEST_F(Faults, AUTH_007_a_line_too_slow_for_the_beats_stops_the_machine) {
  TcpProxy line(room_.server().port());
  otto_->quit();
  otto_.emplace(room_.seat_behind(line, 2, "otto"));
  run_on_machine();
  constexpr std::uint32_t kBytesPerSecond = 200;
  line.limit(kBytesPerSecond);
  EXPECT_TRUE(stands_with_nobody());
}

TEST_F(Faults, SEC_005_a_frame_that_does_not_go_on_ends_its_connection_after_5_s) {
  anna_->quit();
  RawClient slow(room_.server().port());
  ASSERT_TRUE(slow.greet(v1::CLIENT_KIND_STATION));
  ASSERT_EQ(slow.log_in("anna", room_.passwords().password_of("anna"), 1)->result(), v1::LOGIN_RESULT_OK);
  slow.send_bytes(std::string("\0\0\1\0half", 8));
  EXPECT_TRUE(slow.is_closed_within(7s));
}

TEST_F(Faults, SEC_005_who_does_not_finish_the_TLS_handshake_is_ended_after_10_s) {
  namespace asio = boost::asio;
  asio::io_context context;
  asio::ip::tcp::socket socket(context);
  socket.connect({asio::ip::address_v4::loopback(), room_.server().port()});
  bool is_closed = false;
  char byte = 0;
  socket.async_read_some(asio::buffer(&byte, 1), [&](const boost::system::error_code& error, std::size_t) {
    is_closed = static_cast<bool>(error);
  });
  context.run_for(12s);
  EXPECT_TRUE(is_closed);
}

}  // namespace
}  // namespace cnclab::harness
