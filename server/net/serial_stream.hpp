// Bytes between a stream and the lab, whatever the stream is: a socket, TLS, a serial device.
#pragma once

#include <array>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <string>
#include <string_view>

#include "lab/media/serial_lines.hpp"

namespace cnclab::net {

/// What waits to be written, and the timer that rings when there is something. The lab keeps what is more (DncLine).
struct SerialOutput {
  explicit SerialOutput(const boost::asio::any_io_executor& executor) : wake(executor) {
    wake.expires_at(boost::asio::steady_timer::time_point::max());
  }
  void put(std::string bytes) {
    unsent += bytes.size();
    waiting += bytes;
    wake.cancel();
  }
  void clear() {
    waiting.clear();
    unsent = 0;
  }

  std::string waiting;
  std::size_t unsent = 0;  ///< with those that are being written
  boost::asio::steady_timer wake;
};

/// Hands the lab what was read. What it does not take yet is kept and brought again every 10 ms; meanwhile nothing more
/// is read, so that the sender is held back.
inline boost::asio::awaitable<void> bring(lab::SerialLines& lines, const lab::SerialLines::LinePtr& line,
                                          std::string_view bytes) {
  constexpr std::chrono::milliseconds kPause{10};
  while (true) {
    bytes.remove_prefix(lines.received(line, bytes));
    if (bytes.empty()) co_return;
    boost::asio::steady_timer pause(co_await boost::asio::this_coro::executor, kPause);
    co_await pause.async_wait(boost::asio::use_awaitable);
  }
}

/// Reads until the other end says that nothing more will come; every other end is an exception.
template <class Stream>
boost::asio::awaitable<void> read_line_bytes(Stream& stream, lab::SerialLines& lines, lab::SerialLines::LinePtr line) {
  std::array<char, 512> buffer{};
  while (true) {
    boost::system::error_code error;
    const std::size_t count = co_await stream.async_read_some(
        boost::asio::buffer(buffer), boost::asio::redirect_error(boost::asio::use_awaitable, error));
    if (error == boost::asio::error::eof) co_return;
    if (error) throw boost::system::system_error(error);
    co_await bring(lines, line, std::string_view(buffer.data(), count));
  }
}

/// Writes what is put until `is_open` no longer holds.
template <class Stream, class IsOpen>
boost::asio::awaitable<void> write_line_bytes(Stream& stream, SerialOutput& output, IsOpen is_open) {
  while (is_open()) {
    if (output.waiting.empty()) {
      boost::system::error_code woken;
      co_await output.wake.async_wait(boost::asio::redirect_error(boost::asio::use_awaitable, woken));
      output.wake.expires_at(boost::asio::steady_timer::time_point::max());
      continue;
    }
    std::string bytes;
    bytes.swap(output.waiting);
    co_await boost::asio::async_write(stream, boost::asio::buffer(bytes), boost::asio::use_awaitable);
    output.unsent -= std::min(output.unsent, bytes.size());
  }
}

}  // namespace cnclab::net
