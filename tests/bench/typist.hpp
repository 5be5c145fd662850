// A station that types, and the floor that it is compared with.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "cnclab/v1/envelope.pb.h"
#include "echo_server.hpp"
#include "line.hpp"
#include "shared/frame.hpp"
#include "shared/key.hpp"

namespace cnclab::bench {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr int kStations = 15;
constexpr int kKeys = 200;            ///< per station
constexpr auto kBetweenKeys = 100ms;  ///< 10 keys/s

/// What one station measured, µs each.
using Times = std::vector<double>;

inline std::string student_name(int station) { return fmt::format("schueler{:02}", station); }

/// A station that types: keeps its screen acknowledged and times each key until the screen that contains it.
class Typist {
 public:
  Typist(std::uint16_t port, int station) : line_(port), station_(station) {}

  bool log_in(const std::string& user, const std::string& password) {
    v1::ClientMessage hello, login;
    hello.mutable_hello()->set_version(kProtocolVersion);
    hello.mutable_hello()->set_kind(v1::CLIENT_KIND_STATION);
    hello.mutable_hello()->set_takes_parts(true);
    line_.send(hello);
    login.mutable_login()->set_user(user);
    login.mutable_login()->set_password(password);
    login.mutable_login()->set_station(static_cast<std::uint32_t>(station_));
    line_.send(login);
    while (const auto message = line_.read(10s))
      if (message->has_login()) return message->login().result() == v1::LOGIN_RESULT_OK;
    return false;
  }

  /// Presses one key and waits for its effect.
  double press(Key key) {
    const auto start = Clock::now();
    v1::ClientMessage message;
    auto& event = *message.mutable_key();
    event.set_number(++number_);
    event.add_keys(static_cast<v1::Key>(key));
    event.set_pressed(true);
    event.mutable_seen()->set_beat(beat_);
    event.mutable_seen()->set_state(state_);
    line_.send(message);
    return until_handled(start);
  }

  /// As `press`, for a turn of the potentiometer.
  double turn(std::uint32_t percent) {
    const auto start = Clock::now();
    v1::ClientMessage message;
    message.mutable_potentiometer()->set_number(++number_);
    message.mutable_potentiometer()->set_percent(percent);
    message.mutable_potentiometer()->mutable_seen()->set_beat(beat_);
    message.mutable_potentiometer()->mutable_seen()->set_state(state_);
    line_.send(message);
    return until_handled(start);
  }

  /// Reads and acknowledges what comes until the time is over.
  void idle_until(Clock::time_point end) {
    while (Clock::now() < end) {
      const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
      if (rest <= 0ms || !follow(rest)) return;
    }
  }

  [[nodiscard]] std::uint64_t received_tls_bytes() { return line_.received_tls_bytes(); }

 private:
  double until_handled(Clock::time_point start) {
    while (handled_ < number_)
      if (!follow(5s)) throw std::runtime_error("no screen came within 5 s");
    return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
  }

  bool follow(std::chrono::milliseconds limit) {
    const auto message = line_.read(limit);
    if (!message) return false;
    v1::ClientMessage answer;
    if (message->has_beat()) {
      beat_ = message->beat().number();
      answer.mutable_alive()->set_beat(beat_);
    } else if (message->has_screen()) {
      handled_ = std::max(handled_, message->screen().handled_key());
      state_ = message->screen().state();
      answer.mutable_screen_ack()->set_number(message->screen().number());
    } else {
      return true;
    }
    line_.send(answer);
    return true;
  }

  Line line_;
  int station_;
  std::uint64_t number_ = 0, handled_ = 0, beat_ = 0, state_ = 0;
};

/// What the echo server answers: a frame with one row of a screen.
inline std::string screen_sized_frame() {
  v1::ServerMessage screen;
  auto& row = *screen.mutable_screen()->add_rows();
  row.add_spans()->set_text(std::string(80, 'x'));
  return frame(screen);
}

inline v1::ClientMessage one_key() {
  v1::ClientMessage key;
  key.mutable_key()->set_number(1);
  key.mutable_key()->add_keys(v1::KEY_1);
  key.mutable_key()->set_pressed(true);
  key.mutable_key()->mutable_seen()->set_beat(123'456);
  return key;
}

/// The same load on the echo server: a key-sized frame there, a screen-sized one back.
inline Times ping_pong() {
  const EchoServer server(screen_sized_frame());
  std::mutex mutex;
  Times all;
  {
    std::vector<std::jthread> threads;
    for (int station = 1; station <= kStations; ++station) {
      threads.emplace_back([&, station] {
        Line line(server.port());
        const v1::ClientMessage key = one_key();
        Times mine;
        auto next = Clock::now() + station * kBetweenKeys / kStations;
        for (int i = 0; i < kKeys; ++i) {
          std::this_thread::sleep_until(next);
          next += kBetweenKeys;
          const auto start = Clock::now();
          line.send(key);
          if (!line.read(5s)) throw std::runtime_error("the echo ended");
          mine.push_back(std::chrono::duration<double, std::micro>(Clock::now() - start).count());
        }
        const std::lock_guard lock(mutex);
        all.insert(all.end(), mine.begin(), mine.end());
      });
    }
  }
  return all;
}

}  // namespace cnclab::bench
