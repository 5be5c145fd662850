// The serial device ([dnc] device): opened, opened again when it has disappeared, bound to [dnc] station.
//
// The control makes the parity itself (D-103), so the device is set to 8 data bits without one: on the wire that is 7
// data bits with even parity and 1 stop bit, and a received parity is not checked (EXT-043, EXT-044).
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/serial_port.hpp>
#include <boost/asio/steady_timer.hpp>
#include <memory>
#include <string>

#include "lab/media/serial_lines.hpp"
#include "net/serial_stream.hpp"

namespace cnclab::net {

class SerialDevice final : public lab::LinePeer, public std::enable_shared_from_this<SerialDevice> {
 public:
  SerialDevice(boost::asio::io_context& loop, std::string path, lab::SerialLines& lines);

  /// Opens it now, and every second again until it is there.
  void start();
  void stop();

  void send(std::string bytes) override { output_.put(std::move(bytes)); }
  [[nodiscard]] std::size_t unsent() const override { return output_.unsent; }
  void set_baud(int baud) override;
  void hang_up(const std::string&) override {}  // it stays for whoever sits down next
  [[nodiscard]] std::string address() const override { return path_; }

 private:
  boost::asio::awaitable<void> keep_open();
  /// Until the device is gone.
  boost::asio::awaitable<void> converse();
  [[nodiscard]] bool open();
  void close();

  std::string path_;
  lab::SerialLines& lines_;
  boost::asio::serial_port port_;
  SerialOutput output_;
  boost::asio::steady_timer retry_;
  int baud_ = 1200;
  bool is_stopped_ = false;
  bool is_missed_ = false;  ///< its absence was logged
};

}  // namespace cnclab::net
