// A network line with faults: a loopback proxy that can be cut, stalled and slowed down.
#include "harness/tcp_proxy.hpp"

#include <array>
#include <atomic>
#include <boost/asio/as_tuple.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <cstdint>
#include <exception>
#include <list>
#include <memory>
#include <thread>

namespace cnclab::harness {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::uint64_t kNever = UINT64_MAX;

/// Both ends of one connection.
struct Line {
  explicit Line(tcp::socket from_client) : client(std::move(from_client)), server(client.get_executor()) {}
  tcp::socket client, server;
  void end() {
    error_code ignored;
    client.close(ignored);
    server.close(ignored);
  }
};

/// An exception that leaves a coroutine is an error of the harness, not of the line: it ends the test program.
void must_not_throw(const std::exception_ptr& error) {
  if (error) std::rethrow_exception(error);
}

}  // namespace

struct TcpProxy::Impl {
  using Direction = TcpProxy::Direction;

  explicit Impl(std::uint16_t target_port)
      : target(asio::ip::address_v4::loopback(), target_port),
        acceptor(context, tcp::endpoint(asio::ip::address_v4::loopback(), 0)),
        gate(context, asio::steady_timer::time_point::max()),
        port(acceptor.local_endpoint().port()) {}

  asio::io_context context;
  tcp::endpoint target;
  tcp::acceptor acceptor;
  asio::steady_timer gate;  ///< waited for while a direction stands still; cancelled at every change
  std::uint16_t port;
  // Only the proxy's thread touches these.
  bool holds_requests = false, holds_answers = false;
  std::uint32_t bytes_per_s = 0;
  std::array<std::uint64_t, 2> cuts_at{kNever, kNever};  ///< `forwarded` of each direction
  std::list<std::weak_ptr<Line>> lines;
  // Anybody reads these.
  std::atomic<bool> refuses = false;
  std::atomic<int> accepted = 0;
  std::array<std::atomic<std::uint64_t>, 2> forwarded{};  ///< bytes in each direction
  std::thread thread;

  [[nodiscard]] bool holds(Direction direction) const {
    return direction == Direction::to_server ? holds_requests : holds_answers;
  }

  asio::awaitable<void> listen() {
    for (;;) {
      auto [error, socket] = co_await acceptor.async_accept(asio::as_tuple(asio::use_awaitable));
      if (error) co_return;
      ++accepted;
      if (refuses) continue;
      auto line = std::make_shared<Line>(std::move(socket));
      lines.emplace_back(line);
      asio::co_spawn(context, connect(line), must_not_throw);
    }
  }

  asio::awaitable<void> connect(std::shared_ptr<Line> line) {
    const auto [error] = co_await line->server.async_connect(target, asio::as_tuple(asio::use_awaitable));
    if (error) {
      line->end();
      co_return;
    }
    line->client.set_option(tcp::no_delay(true));
    line->server.set_option(tcp::no_delay(true));
    asio::co_spawn(context, pump(line, Direction::to_server), must_not_throw);
    asio::co_spawn(context, pump(line, Direction::to_client), must_not_throw);
  }

  asio::awaitable<void> pump(std::shared_ptr<Line> line, Direction direction) {
    const bool is_request = direction == Direction::to_server;
    tcp::socket& from = is_request ? line->client : line->server;
    tcp::socket& to = is_request ? line->server : line->client;
    std::array<char, 4096> bytes{};
    for (;;) {
      const auto [read_error, count] =
          co_await from.async_read_some(asio::buffer(bytes), asio::as_tuple(asio::use_awaitable));
      if (read_error) break;
      co_await pass_gate(direction);
      co_await slow_down(count);
      const auto [write_error, written] =
          co_await asio::async_write(to, asio::buffer(bytes.data(), count), asio::as_tuple(asio::use_awaitable));
      if (write_error) break;
      count_forwarded(direction, written);
    }
    line->end();
  }

  void count_forwarded(Direction direction, std::size_t bytes) {
    const auto way = static_cast<std::size_t>(direction);
    forwarded[way] += bytes;
    if (forwarded[way] < cuts_at[way]) return;
    cuts_at[way] = kNever;
    cut();
  }

  void cut() {
    end_lines();
    refuses = true;
  }

  asio::awaitable<void> pass_gate(Direction direction) {
    while (holds(direction)) co_await gate.async_wait(asio::as_tuple(asio::use_awaitable));
  }

  asio::awaitable<void> slow_down(std::size_t count) {
    if (bytes_per_s == 0) co_return;
    constexpr std::size_t kMicrosecondsPerSecond = 1'000'000;
    asio::steady_timer timer(context, std::chrono::microseconds(count * kMicrosecondsPerSecond / bytes_per_s));
    co_await timer.async_wait(asio::as_tuple(asio::use_awaitable));
  }

  void end_lines() {
    for (const auto& weak : lines) {
      if (const auto line = weak.lock()) line->end();
    }
    lines.clear();
  }

  /// Runs `change` on the proxy's thread and returns when it has been done.
  template <class Change>
  void apply(Change change) {
    std::atomic<bool> is_done = false;
    asio::post(context, [&] {
      change();
      gate.cancel();
      is_done = true;
      is_done.notify_one();
    });
    is_done.wait(false);
  }
};

TcpProxy::TcpProxy(std::uint16_t target_port) : impl_(std::make_unique<Impl>(target_port)) {
  asio::co_spawn(impl_->context, impl_->listen(), must_not_throw);
  impl_->thread = std::thread([this] { impl_->context.run(); });
}

TcpProxy::~TcpProxy() {
  impl_->context.stop();
  impl_->thread.join();
}

std::uint16_t TcpProxy::port() const { return impl_->port; }

std::string TcpProxy::address() const { return "127.0.0.1:" + std::to_string(port()); }

void TcpProxy::cut() {
  impl_->apply([this] { impl_->cut(); });
}

void TcpProxy::cut_after(Direction direction, std::uint64_t bytes) {
  const auto way = static_cast<std::size_t>(direction);
  impl_->apply([this, way, bytes] { impl_->cuts_at[way] = impl_->forwarded[way] + bytes; });
}

bool TcpProxy::is_cut() const { return impl_->refuses; }

void TcpProxy::stall() {
  impl_->apply([this] { impl_->holds_requests = impl_->holds_answers = true; });
}

void TcpProxy::stall_answers() {
  impl_->apply([this] { impl_->holds_answers = true; });
}

void TcpProxy::limit(std::uint32_t bytes_per_s) {
  impl_->apply([this, bytes_per_s] { impl_->bytes_per_s = bytes_per_s; });
}

void TcpProxy::mend() {
  impl_->apply([this] {
    impl_->refuses = false;
    impl_->holds_requests = impl_->holds_answers = false;
    impl_->bytes_per_s = 0;
  });
}

int TcpProxy::accepted() const { return impl_->accepted; }

std::uint64_t TcpProxy::forwarded(Direction direction) const {
  return impl_->forwarded[static_cast<std::size_t>(direction)];
}

}  // namespace cnclab::harness
