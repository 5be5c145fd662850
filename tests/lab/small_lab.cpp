// A lab in one process for tests: messages in, messages out, with a database in memory and a clock of our own.
#include "small_lab.hpp"

#include <sodium.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ranges>
#include <stdexcept>
#include <string_view>

#include "shared/screen_wire.hpp"

namespace cnclab::lab {

const v1::LoginAnswer* Caller::login() const {
  for (const v1::ServerMessage& message : std::views::reverse(peer->sent))
    if (message.has_login()) return &message.login();
  return nullptr;
}

// As weak as it gets: tests log in often, and how long a hash takes is a matter of the hash itself.
const std::string& SmallLab::password_hash() {
  static const std::string kHash = [] {
    constexpr std::string_view kPassword = "geheim123";
    std::array<char, crypto_pwhash_STRBYTES> text{};
    if (sodium_init() < 0 ||
        crypto_pwhash_str_alg(text.data(), kPassword.data(), kPassword.size(), crypto_pwhash_OPSLIMIT_MIN,
                              crypto_pwhash_MEMLIMIT_MIN, crypto_pwhash_ALG_ARGON2ID13) != 0)
      throw std::runtime_error("no password hash");
    return std::string(text.data());
  }();
  return kHash;
}

SmallLab::SmallLab(Configuration configuration) {
  auto database = db::Database::open(":memory:").value();
  for (const char* name : {"eva", "udo", "lehrer"}) {
    db::Person person;
    person.name = name;
    person.role = std::string(name) == "lehrer" ? "instructor" : "student";
    person.password_hash = password_hash();
    database.add_person(person, 1);
  }
  store_ = std::make_unique<db::Store>(std::move(database), post());
  const Clock clock{[this] { return now_ns_; }, [this] { return unix_ms_; }};
  lab_ = std::make_unique<Lab>(std::move(configuration), *store_, ticks_, post(), clock, Inheritance{});
}

SmallLab::~SmallLab() {
  lab_.reset();
  store_.reset();
}

db::Post SmallLab::post() {
  return [this](std::function<void()> job) {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
    came_.notify_one();
  };
}

void SmallLab::settle_until(const std::function<bool()>& done) {
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!done()) {
    std::unique_lock lock(mutex_);
    if (!came_.wait_until(lock, limit, [this] { return !jobs_.empty(); })) throw std::runtime_error("no answer came");
    auto job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
  }
}

void SmallLab::with_database(std::function<void(db::Database&)> work) {
  bool is_done = false;
  store_->run(std::move(work), [&is_done](const std::expected<void, db::StoreError>&) { is_done = true; });
  settle_until([&is_done] { return is_done; });
}

Caller SmallLab::call(v1::ClientKind kind, std::uint32_t version) {
  Caller caller;
  caller.visit = lab_->welcome(caller.peer);
  v1::ClientMessage hello;
  hello.mutable_hello()->set_version(version);
  hello.mutable_hello()->set_kind(kind);
  lab_->receive(caller.visit, hello);
  return caller;
}

void SmallLab::log_in(Caller& caller, const std::string& user, std::uint32_t station, const std::string& password,
                      v1::Elsewhere elsewhere) {
  v1::ClientMessage message;
  message.mutable_login()->set_user(user);
  message.mutable_login()->set_password(password);
  message.mutable_login()->set_station(station);
  message.mutable_login()->set_elsewhere(elsewhere);
  const std::size_t before = caller.peer->sent.size();
  lab_->receive(caller.visit, message);
  settle_until([&] { return caller.peer->sent.size() > before; });
}

void SmallLab::press(Caller& caller, Key key, std::uint64_t number) {
  v1::ClientMessage message;
  message.mutable_key()->set_number(number);
  message.mutable_key()->add_keys(static_cast<v1::Key>(key));
  message.mutable_key()->set_pressed(true);
  lab_->receive(caller.visit, message);
}

void SmallLab::strike(Caller& caller, Key key) {
  for (const bool pressed : {true, false}) {
    v1::ClientMessage message;
    auto& event = *message.mutable_key();
    event.set_number(++caller.number);
    event.add_keys(static_cast<v1::Key>(key));
    event.set_pressed(pressed);
    event.mutable_seen()->set_beat(caller.beat);
    event.mutable_seen()->set_state(caller.state);
    lab_->receive(caller.visit, message);
  }
  look(caller);
}

void SmallLab::look(Caller& caller) {
  for (; !caller.peer->sent.empty(); caller.peer->sent.pop_front()) {
    const v1::ServerMessage message = caller.peer->sent.front();
    v1::ClientMessage reply;
    if (message.has_beat()) {
      caller.beat = message.beat().number();
      reply.mutable_alive()->set_beat(caller.beat);
      lab_->receive(caller.visit, reply);
    } else if (message.has_screen()) {
      caller.state = message.screen().state();
      caller.screen = apply_rows(caller.screen, message.screen()).value();
      caller.handled = std::max(caller.handled, message.screen().handled_key());
      reply.mutable_screen_ack()->set_number(message.screen().number());
      lab_->receive(caller.visit, reply);
    }
  }
}

v1::InstructorAnswer SmallLab::ask(Caller& console, v1::InstructorRequest request) {
  v1::ClientMessage message;
  static std::uint32_t number = 0;
  request.set_number(++number);
  *message.mutable_request() = std::move(request);
  const std::uint32_t asked = number;
  lab_->receive(console.visit, message);
  const auto answered = [&](const v1::ServerMessage& reply) {
    return reply.has_answer() && reply.answer().number() == asked;
  };
  settle_until([&] { return std::ranges::any_of(console.peer->sent, answered); });
  return std::ranges::find_if(console.peer->sent, answered)->answer();
}

}  // namespace cnclab::lab
