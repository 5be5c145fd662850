// One connection: its first line, then its bytes.
#include "net/serial_listener.hpp"

#include <spdlog/spdlog.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/ssl/stream.hpp>

#include "net/listen.hpp"
#include "net/serial_stream.hpp"

namespace cnclab::net {

namespace asio = boost::asio;
using asio::use_awaitable;
using asio::ip::tcp;
using TlsStream = asio::ssl::stream<tcp::socket>;

namespace {

constexpr std::chrono::seconds kBindingLimit{10};
constexpr std::chrono::seconds kBeforeClosing{1};  ///< guessing takes its time
constexpr std::chrono::milliseconds kBetweenLooks{10};
constexpr int kMostUnbound = 16;

/// Counts itself for as long as its first line is to come.
class Unbound {
 public:
  explicit Unbound(std::shared_ptr<int> count) : count_(std::move(count)) { ++*count_; }
  ~Unbound() { leave(); }
  Unbound(const Unbound&) = delete;
  Unbound& operator=(const Unbound&) = delete;
  void leave() {
    if (count_) --*count_;
    count_.reset();
  }

 private:
  std::shared_ptr<int> count_;
};

/// Lives as long as its coroutines run; the lab holds it as the far end of a line.
template <class Stream>
class TcpLine final : public lab::LinePeer, public std::enable_shared_from_this<TcpLine<Stream>> {
 public:
  TcpLine(Stream stream, lab::SerialLines& lines, std::shared_ptr<int> unbound)
      : stream_(std::move(stream)),
        lines_(lines),
        unbound_(std::move(unbound)),
        output_(stream_.get_executor()),
        deadline_(stream_.get_executor()) {
    boost::system::error_code ignored;
    const auto remote = socket().remote_endpoint(ignored);
    address_ = remote.address().to_string() + ":" + std::to_string(remote.port());
    socket().set_option(tcp::no_delay(true), ignored);
  }

  void start() {
    asio::co_spawn(
        stream_.get_executor(), [self = this->shared_from_this()] { return self->converse(); },
        [self = this->shared_from_this()](const std::exception_ptr& failure) {
          try {
            if (failure) std::rethrow_exception(failure);
          } catch (const boost::system::system_error& error) {
            self->tell_end(error.code().message());
          } catch (const std::exception& error) {
            self->tell_end(error.what());
          }
          self->close();
          if (self->line_) self->lines_.lost(std::exchange(self->line_, nullptr));
        });
  }

  void send(std::string bytes) override { output_.put(std::move(bytes)); }
  [[nodiscard]] std::size_t unsent() const override { return output_.unsent; }
  void set_baud(int) override {}  // the control keeps the pace
  void hang_up(const std::string& reason) override {
    tell_end(reason);
    close();
  }
  [[nodiscard]] std::string address() const override { return address_; }

 private:
  tcp::socket& socket() {
    if constexpr (std::is_same_v<Stream, tcp::socket>)
      return stream_;
    else
      return stream_.next_layer();
  }

  asio::awaitable<void> converse() {
    deadline_.expires_after(kBindingLimit);
    deadline_.async_wait([weak = this->weak_from_this()](const boost::system::error_code& cancelled) {
      if (const auto self = weak.lock(); self && !cancelled) self->give_up("no STATION line in time");
    });
    if constexpr (!std::is_same_v<Stream, tcp::socket>)
      co_await stream_.async_handshake(asio::ssl::stream_base::server, use_awaitable);
    std::string read;  // the first line, and what came with it
    if (!co_await bind(read)) co_return;
    co_await bring(lines_, line_, read);
    asio::co_spawn(
        stream_.get_executor(),
        [self = this->shared_from_this()] {
          return write_line_bytes(self->stream_, self->output_, [self] { return self->is_open_; });
        },
        [self = this->shared_from_this()](const std::exception_ptr&) { self->close(); });  // the reader ends with it
    co_await read_line_bytes(stream_, lines_, line_);
    // The sender has said all; what is on its way still arrives, and is answered.
    while (is_open_ && (output_.unsent > 0 || !lines_.is_idle(line_))) co_await pause(kBetweenLooks);
    tell_end("the sender has ended");
  }

  /// True where it is a line of the lab now; `read` is what came behind the first line then. The answer to anything
  /// else is silence, for a while: guesses and noise come no faster.
  asio::awaitable<bool> bind(std::string& read) {
    boost::system::error_code error;
    const std::size_t length =
        co_await asio::async_read_until(stream_, asio::dynamic_buffer(read, transfer::kLongestBinding + 2), '\n',
                                        asio::redirect_error(use_awaitable, error));
    deadline_.cancel();
    if (!is_open_) co_return false;
    if (const auto refusal = error ? std::optional(why_not(error)) : claim(read, length)) {
      spdlog::warn("dnc {}: refused: {}", address_, *refusal);
      co_await pause(kBeforeClosing);
      co_return false;
    }
    unbound_.leave();
    read.erase(0, length);
    co_return true;
  }

  /// Asks the lab for the line that the first line names; the reason where it is refused.
  std::optional<std::string> claim(const std::string& read, std::size_t length) {
    const auto binding = transfer::parse_binding(std::string_view(read).substr(0, length - 1));
    if (!binding) {
      lines_.refuse(address_, std::string(binding.error()));
      return std::string(binding.error());
    }
    auto line = lines_.bind(this->shared_from_this(), *binding);
    if (!line) return line.error();
    line_ = *line;
    return std::nullopt;
  }

  std::string why_not(const boost::system::error_code& error) {
    std::string why = error == asio::error::not_found ? "line too long" : error.message();
    lines_.refuse(address_, why);
    return why;
  }

  asio::awaitable<void> pause(std::chrono::milliseconds time) {
    asio::steady_timer timer(stream_.get_executor(), time);
    co_await timer.async_wait(use_awaitable);
  }

  void give_up(const std::string& why) {
    if (!is_open_) return;
    lines_.refuse(address_, why);
    spdlog::warn("dnc {}: refused: {}", address_, why);
    close();
  }

  void tell_end(const std::string& why) const {
    if (is_open_) spdlog::info("dnc {}: line ended: {}", address_, why);
  }

  void close() {
    if (!is_open_) return;
    is_open_ = false;
    boost::system::error_code ignored;
    socket().shutdown(tcp::socket::shutdown_both, ignored);
    socket().close(ignored);
    deadline_.cancel();
    output_.wake.cancel();
  }

  Stream stream_;
  lab::SerialLines& lines_;
  Unbound unbound_;
  std::string address_;
  lab::SerialLines::LinePtr line_;
  SerialOutput output_;
  asio::steady_timer deadline_;  ///< of handshake and first line
  bool is_open_ = true;
};

}  // namespace

std::expected<std::unique_ptr<SerialListener>, std::string> SerialListener::listen(asio::io_context& loop,
                                                                                   const std::string& address,
                                                                                   const Certificate& certificate) {
  auto acceptor = listen_on(loop, address, "[dnc] listen in lab.toml");
  if (!acceptor) return std::unexpected("[dnc] listen: " + acceptor.error());
  return std::make_unique<SerialListener>(std::move(*acceptor), certificate);
}

SerialListener::SerialListener(tcp::acceptor acceptor, const Certificate& certificate)
    : acceptor_(std::move(acceptor)),
      tls_(server_context(certificate)),
      is_plain_(acceptor_.local_endpoint().address().is_loopback()) {}

void SerialListener::serve(lab::SerialLines& lines) {
  asio::co_spawn(acceptor_.get_executor(), accept(lines), [](const std::exception_ptr& failure) {
    try {
      if (failure) std::rethrow_exception(failure);
    } catch (const std::exception& error) {  // the lab goes on without
      spdlog::error("dnc: the listener ended: {}", error.what());
    }
  });
}

void SerialListener::stop() {
  boost::system::error_code ignored;
  acceptor_.close(ignored);
}

std::string SerialListener::address() const {
  const auto endpoint = acceptor_.local_endpoint();
  const std::string host = endpoint.address().to_string();
  return (endpoint.address().is_v6() ? "[" + host + "]" : host) + ":" + std::to_string(endpoint.port());
}

asio::awaitable<void> SerialListener::accept(lab::SerialLines& lines) {
  while (acceptor_.is_open()) {
    boost::system::error_code error;
    tcp::socket socket = co_await acceptor_.async_accept(asio::redirect_error(use_awaitable, error));
    if (error || *unbound_ >= kMostUnbound) {  // out of descriptors, or a flood: newcomers wait
      if (!acceptor_.is_open()) co_return;
      spdlog::warn("dnc: a connection was not accepted: {}", error ? error.message() : "too many unbound");
      asio::steady_timer pause(acceptor_.get_executor(), std::chrono::milliseconds(100));
      co_await pause.async_wait(use_awaitable);
    } else if (is_plain_) {
      std::make_shared<TcpLine<tcp::socket>>(std::move(socket), lines, unbound_)->start();
    } else {
      std::make_shared<TcpLine<TlsStream>>(TlsStream(std::move(socket), tls_), lines, unbound_)->start();
    }
  }
}

}  // namespace cnclab::net
