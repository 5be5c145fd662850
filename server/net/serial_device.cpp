// Opening, reading and writing a serial device.
#include "net/serial_device.hpp"

#include <spdlog/spdlog.h>

#include <boost/asio/co_spawn.hpp>
#include <utility>

namespace cnclab::net {

namespace asio = boost::asio;
using asio::use_awaitable;

namespace {
constexpr std::chrono::seconds kBetweenTries{1};
}  // namespace

SerialDevice::SerialDevice(asio::io_context& loop, std::string path, lab::SerialLines& lines)
    : path_(std::move(path)), lines_(lines), port_(loop), output_(loop.get_executor()), retry_(loop) {}

void SerialDevice::start() {
  asio::co_spawn(
      port_.get_executor(), [self = shared_from_this()] { return self->keep_open(); },
      [self = shared_from_this()](const std::exception_ptr& failure) {
        try {
          if (failure) std::rethrow_exception(failure);
        } catch (const std::exception& error) {  // the lab goes on without
          spdlog::error("dnc {}: {}", self->path_, error.what());
        }
      });
}

void SerialDevice::stop() {
  is_stopped_ = true;
  retry_.cancel();
  close();
}

void SerialDevice::set_baud(int baud) {
  baud_ = baud;
  boost::system::error_code error;
  if (port_.is_open()) port_.set_option(asio::serial_port::baud_rate(static_cast<unsigned>(baud)), error);
  if (error) spdlog::warn("dnc {}: {} baud: {}", path_, baud, error.message());
}

bool SerialDevice::open() {
  using Port = asio::serial_port;
  boost::system::error_code error;
  port_.open(path_, error);
  if (!error) port_.set_option(Port::baud_rate(static_cast<unsigned>(baud_)), error);
  if (!error) port_.set_option(Port::character_size(8), error);
  if (!error) port_.set_option(Port::parity(Port::parity::none), error);
  if (!error) port_.set_option(Port::stop_bits(Port::stop_bits::one), error);
  if (!error) port_.set_option(Port::flow_control(Port::flow_control::none), error);
  if (!error) return true;
  if (!std::exchange(is_missed_, true)) spdlog::warn("dnc {}: {}: waiting for it", path_, error.message());
  close();
  return false;
}

void SerialDevice::close() {
  boost::system::error_code ignored;
  port_.close(ignored);
  output_.clear();
  output_.wake.cancel();
}

asio::awaitable<void> SerialDevice::keep_open() {
  while (!is_stopped_) {
    if (open()) {
      is_missed_ = false;
      spdlog::info("dnc {}: open", path_);
      co_await converse();
    }
    if (is_stopped_) co_return;
    retry_.expires_after(kBetweenTries);
    boost::system::error_code cancelled;
    co_await retry_.async_wait(asio::redirect_error(use_awaitable, cancelled));
  }
}

asio::awaitable<void> SerialDevice::converse() {
  const lab::SerialLines::LinePtr line = lines_.attach_device(shared_from_this());
  asio::co_spawn(
      port_.get_executor(),
      [self = shared_from_this()] {
        return write_line_bytes(self->port_, self->output_, [self] { return self->port_.is_open(); });
      },
      [self = shared_from_this()](const std::exception_ptr& failure) {
        if (failure) self->close();  // the reader ends with it
      });
  try {
    co_await read_line_bytes(port_, lines_, line);
  } catch (const boost::system::system_error& error) {
    if (!is_stopped_) spdlog::warn("dnc {}: {}: opened again when it is back", path_, error.code().message());
  }
  is_missed_ = true;
  close();
  lines_.lost(line);
}

}  // namespace cnclab::net
