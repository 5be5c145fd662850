// The headless station over pipes against a scripted server: every command, reply and exit code (interfaces.md 3).
#include "station/headless.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <boost/asio/experimental/awaitable_operators.hpp>

#include "fake_server.hpp"
#include "station/headless_station.hpp"

namespace cnclab::station {
namespace {

using namespace std::chrono_literals;
using asio::experimental::awaitable_operators::operator&&;
using Lines = std::vector<std::string>;

struct Pipe {
  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    from = ends[0];
    to = ends[1];
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    ::close(from);
    close_writer();
  }
  void close_writer() {
    if (to >= 0) ::close(std::exchange(to, -1));
  }
  int from = -1, to = -1;
};

// The user's side of the two pipes.
class User {
 public:
  User(const asio::any_io_executor& executor, Pipe& commands, Pipe& replies)
      : commands_(commands), replies_(executor, replies.from) {}
  asio::awaitable<std::string> says(std::string command) {
    command += '\n';
    if (::write(commands_.to, command.data(), command.size()) < 0) throw std::runtime_error("write");
    co_return (co_await replies_.next()).value_or("(nothing)");
  }
  asio::awaitable<Lines> lists(std::string command) {
    Lines lines;
    lines.push_back(co_await says(command));
    while (lines.back() != "end") lines.push_back((co_await replies_.next()).value_or("end"));
    co_return lines;
  }
  void hangs_up() { commands_.close_writer(); }

 private:
  Pipe& commands_;
  LineReader replies_;
};

struct Outcome {
  Ending ending;
  std::size_t connections = 0;
};

using Play = std::function<asio::awaitable<void>(User&)>;

Outcome play(std::vector<FakeServer::Script> scripts, Play user_plays,
             const std::function<void(Options&)>& adjust = {}) {
  asio::io_context context;
  FakeServer server(context, std::move(scripts));
  const TemporaryFolder folder;
  Options options;
  options.server = server.address();
  options.trust.fingerprint = server.fingerprint();
  options.station = StationId::of(7);
  options.user = "anna";
  options.password_file = folder.write("password", "geheim\nzweite Zeile\n");
  options.new_password_file = folder.write("new", "viel-geheimer\n");
  options.is_headless = true;
  if (adjust) adjust(options);
  Pipe commands, replies;
  Outcome outcome;
  std::function<void()> leave;
  EXPECT_TRUE(run_to_end(context,
                         [&]() -> asio::awaitable<void> {
                           User user(context.get_executor(), commands, replies);
                           outcome.ending = co_await (run_headless(options, commands.from, replies.to, leave, kQuick) &&
                                                      user_plays(user));
                         }()))
      << "still not at its end after 20 s";
  for (const std::string& failure : server.failures()) ADD_FAILURE() << failure;
  outcome.connections = server.accepted();
  return outcome;
}

Play says_nothing() {
  return [](User&) -> asio::awaitable<void> { co_return; };
}

FakeServer::Script keys_server(std::vector<v1::ClientMessage>* seen = nullptr) {
  return [seen](FakeLine& line) -> asio::awaitable<void> {
    co_await line.admit();
    co_await line.serve_keys(seen);
  };
}

TEST(Headless, KeysAreOkWhenTheServerHasHandledThem) {
  std::vector<v1::ClientMessage> seen;
  std::string after;
  const Outcome outcome = play({keys_server(&seen)}, [&](User& user) -> asio::awaitable<void> {
    EXPECT_EQ(co_await user.says("key HAND ENTER+RESET"), "ok");
    after = (co_await user.lists("screen")).front();
    EXPECT_EQ(co_await user.says("type 1.-"), "ok");
    EXPECT_EQ(co_await user.says("pot 40"), "ok");
    EXPECT_EQ(co_await user.says("hold 1 3+6+9"), "ok");
    EXPECT_EQ(co_await user.says("quit"), "ok");
  });
  EXPECT_EQ(outcome.ending.code, ExitCode::ended_by_user);
  EXPECT_TRUE(after.starts_with("|handled 4 ")) << after << ": effects are in the next screen";
  ASSERT_EQ(seen.size(), 13U) << "two chords, three characters, the potentiometer, a hold";
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto& event = seen[i];
    const std::uint64_t number = event.has_key() ? event.key().number() : event.potentiometer().number();
    EXPECT_EQ(number, i + 1);
    if (event.has_key()) {
      EXPECT_EQ(event.key().pressed(), i < 10 ? i % 2 == 0 : i == 11) << i;
    }
  }
  EXPECT_EQ(seen[2].key().keys_size(), 2);
  EXPECT_EQ(seen[2].key().seen().state(), 3U) << "AUTH-008: the second key sees what the first one has made";
  EXPECT_EQ(seen[6].key().keys(0), v1::KEY_POINT);
  EXPECT_EQ(seen[8].key().keys(0), v1::KEY_SIGN);
  EXPECT_EQ(seen[10].potentiometer().percent(), 40U);
  EXPECT_EQ(seen[12].key().keys_size(), 3);
}

TEST(Headless, ScreenAndMarks) {
  Lines screen, marks;
  play({[](FakeLine& line) -> asio::awaitable<void> {
         co_await line.admit();
         Screen drawn;
         drawn.write(0, 0, "┌─ Prüfen →");
         drawn.write(5, 10, "P0001", Attribute::inverse);
         drawn.write(5, 76, "ende", Attribute::inverse);
         drawn.write(23, 0, "fett", Attribute::bold);
         co_await line.show(drawn);
         co_await line.read(v1::ClientMessage::kLogout);
         co_await line.say_bye(0, "");
       }},
       [&](User& user) -> asio::awaitable<void> {
         screen = co_await user.lists("screen");
         marks = co_await user.lists("marks");
         co_await user.says("quit");
       });
  ASSERT_EQ(screen.size(), 25U);
  EXPECT_EQ(screen[0], "|┌─ Prüfen →" + std::string(69, ' ') + "|");
  for (std::size_t row = 0; row < 24; ++row) EXPECT_EQ(from_utf8(screen[row]).size(), 82U) << row;
  EXPECT_EQ(screen[24], "end");
  EXPECT_EQ(marks, (Lines{"5 10 5", "5 76 4", "end"}));
}

TEST(Headless, WaitAndGone) {
  play({[](FakeLine& line) -> asio::awaitable<void> {
         co_await line.admit();
         co_await line.show_text("eins");
         co_await line.read(v1::ClientMessage::kPotentiometer);
         co_await line.show_text("zwei", 1);
         co_await line.read(v1::ClientMessage::kLogout);
         co_await line.say_bye(0, "");
       }},
       [](User& user) -> asio::awaitable<void> {
         EXPECT_EQ(co_await user.says("wait 0 eins"), "ok");
         EXPECT_EQ(co_await user.says("gone 0 drei"), "ok");
         EXPECT_EQ(co_await user.says("wait 1 zwei"), "timeout");
         EXPECT_EQ(co_await user.says("gone 1 eins"), "timeout");
         EXPECT_EQ(co_await user.says("pot 10"), "ok");
         EXPECT_EQ(co_await user.says("wait 5000 zwei"), "ok");
         EXPECT_EQ(co_await user.says("gone 5000 eins"), "ok");
         co_await user.says("quit");
       });
}

TEST(Headless, WrongCommandsAreErrorsAndHarmNothing) {
  std::vector<v1::ClientMessage> seen;
  const Outcome outcome = play({keys_server(&seen)}, [](User& user) -> asio::awaitable<void> {
    for (const char* const line : {"", "dance", "key HAND NOKEY", "pot 101", "type x"}) {
      EXPECT_TRUE((co_await user.says(line)).starts_with("error ")) << line;
    }
    EXPECT_TRUE((co_await user.says(std::string(20'000, 'x'))).starts_with("error "));
    EXPECT_EQ(co_await user.says("key MENU"), "ok");
    EXPECT_EQ(co_await user.says("quit"), "ok");
  });
  EXPECT_EQ(outcome.ending.code, ExitCode::ended_by_user);
  EXPECT_EQ(seen.size(), 2U) << "only MENU was sent";
}

TEST(Headless, TheEndOfTheInputLogsOut) {
  bool has_logged_out = false;
  const Outcome outcome = play({[&](FakeLine& line) -> asio::awaitable<void> {
                                 co_await line.admit();
                                 co_await line.show_text("da");
                                 co_await line.read(v1::ClientMessage::kLogout);
                                 has_logged_out = true;
                                 co_await line.say_bye(0, "");
                               }},
                               [](User& user) -> asio::awaitable<void> {
                                 user.hangs_up();
                                 co_return;
                               });
  EXPECT_TRUE(has_logged_out);
  EXPECT_EQ(outcome.ending.code, ExitCode::ended_by_user);
}

TEST(Headless, OfflineIsSaidUntilTheStationHasComeBack) {  // SEAT-005
  std::vector<std::string> replies;
  const Outcome outcome = play({[](FakeLine& line) -> asio::awaitable<void> {
                                  co_await line.admit();
                                  co_await line.show_text("da");
                                  co_await line.read(v1::ClientMessage::kKey);
                                  line.cut();
                                },
                                [&](FakeLine& line) -> asio::awaitable<void> {
                                  co_await line.greet();
                                  co_await line.read(v1::ClientMessage::kResume);
                                  while (replies.size() < 3) {  // lets the user speak meanwhile
                                    asio::steady_timer turn(co_await asio::this_coro::executor, 1ms);
                                    co_await turn.async_wait(asio::use_awaitable);
                                  }
                                  v1::LoginAnswer answer;
                                  answer.set_result(v1::LOGIN_RESULT_OK);
                                  answer.set_ticket("neu");
                                  co_await line.answer_login(answer);
                                  co_await line.serve_keys();
                                }},
                               [&](User& user) -> asio::awaitable<void> {
                                 for (const char* const command : {"key START", "screen", "wait 1000 da"}) {
                                   replies.push_back(co_await user.says(command));
                                 }
                                 std::string first;
                                 while (!first.starts_with("|")) {
                                   first = co_await user.says("screen");
                                   if (first.starts_with("|"))
                                     co_await user.lists("marks");  // takes the rest of the screen and its own end
                                 }
                                 EXPECT_EQ(first.substr(0, 10), "|handled 0");
                                 co_await user.says("quit");
                               });
  EXPECT_EQ(replies, Lines(3, "error VERBINDUNG VERLOREN"));
  EXPECT_EQ(outcome.connections, 2U);
}

TEST(Headless, AByeInTheMiddleAnswersTheOpenCommandAndEnds) {
  const Outcome outcome = play({[](FakeLine& line) -> asio::awaitable<void> {
                                 co_await line.admit();
                                 co_await line.show_text("da");
                                 co_await line.read(v1::ClientMessage::kKey);
                                 co_await line.say_bye(6, "Anderswo angemeldet.\n(Platz 4)");
                               }},
                               [](User& user) -> asio::awaitable<void> {
                                 EXPECT_EQ(co_await user.says("key MENU"), "error Anderswo angemeldet. (Platz 4)");
                               });
  EXPECT_EQ(outcome.ending.code, ExitCode::replaced);
}

TEST(Headless, RefusedLoginsHaveTheirExitCodes) {
  struct Row {
    const char* name;
    v1::LoginResult result;
    ExitCode code;
  };
  const Row rows[] = {
      {"SEC-003 wrong password", v1::LOGIN_RESULT_REFUSED, ExitCode::login_refused},
      {"SEC-003 delayed", v1::LOGIN_RESULT_WAIT, ExitCode::login_refused},
      {"SEAT-001 taken", v1::LOGIN_RESULT_SEAT_TAKEN, ExitCode::seat_taken},
      {"SEAT-003 elsewhere", v1::LOGIN_RESULT_ELSEWHERE, ExitCode::login_refused},
      {"SEAT-006 role", v1::LOGIN_RESULT_NOT_ALLOWED, ExitCode::login_refused},
      {"unknown result", static_cast<v1::LoginResult>(77), ExitCode::login_refused},
  };
  for (const Row& row : rows) {
    for (const bool has_text : {true, false}) {
      const Outcome outcome = play({[&](FakeLine& line) -> asio::awaitable<void> {
                                     co_await line.greet();
                                     co_await line.read(v1::ClientMessage::kLogin);
                                     v1::LoginAnswer answer;
                                     answer.set_result(row.result);
                                     answer.set_occupant("bert");
                                     answer.set_other_station(4);
                                     if (has_text) answer.set_text("Satz des Servers.");
                                     co_await line.answer_login(answer);
                                     co_await line.read();
                                   }},
                                   says_nothing());
      EXPECT_EQ(outcome.ending.code, row.code) << row.name;
      EXPECT_FALSE(outcome.ending.text.empty()) << row.name;
      const bool names_options = row.result == v1::LOGIN_RESULT_ELSEWHERE;  // of which the server knows nothing
      EXPECT_EQ(outcome.ending.text == "Satz des Servers.", has_text && !names_options) << row.name;
    }
  }
}

TEST(Headless, ATakenSeatSaysWhoSitsThere) {  // SEAT-001
  v1::LoginAnswer answer;
  answer.set_result(v1::LOGIN_RESULT_SEAT_TAKEN);
  answer.set_occupant("bert");
  EXPECT_NE(ending_of(answer, Language::german).text.find("bert"), std::string::npos);
}

TEST(Headless, SEAT_003_where_no_form_can_ask_the_options_that_help_are_named) {
  v1::LoginAnswer answer;
  answer.set_text("Schon angemeldet an Platz 13.");
  answer.set_other_station(13);
  answer.set_result(v1::LOGIN_RESULT_ELSEWHERE);
  EXPECT_EQ(ending_of(answer, Language::german).text,
            "Schon angemeldet an Platz 13: --take-over übernimmt, --look-on sieht zu.");
  EXPECT_EQ(refusal_text(answer, Language::german), "Schon angemeldet an Platz 13.") << "the form asks itself";
  answer.set_result(v1::LOGIN_RESULT_PASSWORD_EXPIRED);
  EXPECT_NE(ending_of(answer, Language::english).text.find("--new-password-file"), std::string::npos);
}

TEST(Headless, TheLoginCarriesWhatTheCommandLineSays) {
  struct Row {
    const char* name;
    std::function<void(Options&)> adjust;
    v1::ClientKind kind;
    std::uint32_t station;
    v1::Elsewhere elsewhere;
  };
  const Row rows[] = {
      {"plain", [](Options&) {}, v1::CLIENT_KIND_STATION, 7, v1::ELSEWHERE_UNSPECIFIED},
      {"--take-over", [](Options& o) { o.elsewhere = v1::ELSEWHERE_TAKE_OVER; }, v1::CLIENT_KIND_STATION, 7,
       v1::ELSEWHERE_TAKE_OVER},
      {"--observe 12",
       [](Options& o) {
         o.station.reset();
         o.observe = StationId::of(12);
       },
       v1::CLIENT_KIND_OBSERVER, 12, v1::ELSEWHERE_UNSPECIFIED},
  };
  for (const Row& row : rows) {
    v1::Hello hello;
    v1::Login login;
    play({[&](FakeLine& line) -> asio::awaitable<void> {
           hello = co_await line.greet();
           login = (co_await line.read(v1::ClientMessage::kLogin)).login();
           v1::LoginAnswer answer;
           answer.set_result(v1::LOGIN_RESULT_REFUSED);
           co_await line.answer_login(answer);
           co_await line.read();
         }},
         says_nothing(), row.adjust);
    EXPECT_EQ(hello.kind(), row.kind) << row.name;
    EXPECT_EQ(login.user(), "anna") << row.name;
    EXPECT_EQ(login.password(), "geheim") << row.name << ": the file's first line";
    EXPECT_EQ(login.station(), row.station) << row.name;
    EXPECT_EQ(login.elsewhere(), row.elsewhere) << row.name;
  }
}

TEST(Headless, AForcedChangeTakesTheNewPasswordFile) {  // SEC-002
  std::string changed_to;
  const Outcome outcome =
      play({[&](FakeLine& line) -> asio::awaitable<void> {
             co_await line.greet();
             co_await line.read(v1::ClientMessage::kLogin);
             v1::LoginAnswer answer;
             answer.set_result(v1::LOGIN_RESULT_PASSWORD_EXPIRED);
             co_await line.answer_login(answer);
             changed_to = (co_await line.read(v1::ClientMessage::kChangePassword)).change_password().new_password();
             answer.set_result(v1::LOGIN_RESULT_OK);
             answer.set_ticket("t");
             co_await line.answer_login(answer);
             co_await line.serve_keys();
           }},
           [](User& user) -> asio::awaitable<void> { co_await user.says("quit"); });
  EXPECT_EQ(changed_to, "viel-geheimer");
  EXPECT_EQ(outcome.ending.code, ExitCode::ended_by_user);
}

TEST(Headless, AForcedChangeWithoutAFileIsRefusedWithTheRemedy) {
  const Outcome outcome = play({[](FakeLine& line) -> asio::awaitable<void> {
                                 co_await line.greet();
                                 co_await line.read(v1::ClientMessage::kLogin);
                                 v1::LoginAnswer answer;
                                 answer.set_result(v1::LOGIN_RESULT_PASSWORD_EXPIRED);
                                 co_await line.answer_login(answer);
                                 co_await line.read();
                               }},
                               says_nothing(), [](Options& options) { options.new_password_file.reset(); });
  EXPECT_EQ(outcome.ending.code, ExitCode::login_refused);
  EXPECT_NE(outcome.ending.text.find("--new-password-file"), std::string::npos);
}

TEST(Headless, PasswordFilesThatCannotServeAreUsageErrors) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_password(folder.write("crlf", "abc\r\n")), "abc");
  EXPECT_EQ(read_password(folder.write("no_end", "abc")), "abc");
  for (const auto& file : {folder.path() / "missing", folder.write("empty", "\n"),
                           folder.write("long", std::string(257, 'x')), folder.path()}) {
    const auto password = read_password(file);
    ASSERT_FALSE(password) << file;
    EXPECT_EQ(password.error().code, ExitCode::usage);
    EXPECT_NE(password.error().text.find(file.string()), std::string::npos);
  }
}

TEST(LineReader, ReadsRegularFilesAndLinesWithoutEnd) {
  asio::io_context context;
  const TemporaryFolder folder;
  const int file = ::open(folder.write("script", "eins\r\n\nzwei").c_str(), O_RDONLY | O_CLOEXEC);
  Lines lines;
  ASSERT_TRUE(run_to_end(context, [&]() -> asio::awaitable<void> {
    LineReader reader(context.get_executor(), file);
    while (const auto line = co_await reader.next()) lines.push_back(*line);
  }()));
  ::close(file);
  EXPECT_EQ(lines, (Lines{"eins", "", "zwei"}));
}

}  // namespace
}  // namespace cnclab::station
