// Lines from a file descriptor without blocking the event loop: pipes and terminals by waiting, files by reading.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <optional>
#include <string>

namespace cnclab::station {

class LineReader {
 public:
  static constexpr std::size_t kLongestLine = 4096;

  /// Reads from a duplicate of `descriptor`; the original stays open and the caller's.
  LineReader(const boost::asio::any_io_executor& executor, int descriptor);
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;
  ~LineReader();

  /// The next line without its end (LF or CR LF); nothing at the end of the input. A longer line is cut.
  [[nodiscard]] boost::asio::awaitable<std::optional<std::string>> next();

 private:
  boost::asio::awaitable<bool> read_more();

  int file_ = -1;  // where the descriptor cannot be waited for: a regular file never blocks
  boost::asio::posix::stream_descriptor stream_;
  std::string pending_;
};

}  // namespace cnclab::station
