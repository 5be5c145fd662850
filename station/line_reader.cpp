// Splitting what arrives into lines, with a bound for each.
#include "station/line_reader.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <boost/asio/error.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/system/error_code.hpp>

namespace cnclab::station {

namespace asio = boost::asio;

LineReader::LineReader(const asio::any_io_executor& executor, int descriptor) : stream_(executor) {
  const int own = ::dup(descriptor);
  struct stat kind{};
  boost::system::error_code error;
  // epoll takes pipes, sockets and terminals, but no files; Asio tells so only when it is too late.
  if (own < 0 || ::fstat(own, &kind) != 0 || !S_ISREG(kind.st_mode)) stream_.assign(own, error);
  if (!stream_.is_open()) file_ = own;
}

LineReader::~LineReader() {
  if (file_ >= 0) ::close(file_);
}

// Waits and then reads itself: an asynchronous read would make the open file non-blocking for everybody who shares it.
asio::awaitable<bool> LineReader::read_more() {
  boost::system::error_code error;
  if (file_ < 0) {
    co_await stream_.async_wait(asio::posix::stream_descriptor::wait_read,
                                asio::redirect_error(asio::use_awaitable, error));
  }
  if (error == asio::error::operation_not_supported) error.clear();  // /dev/null: no waiting, no blocking either
  if (error) co_return false;
  std::array<char, kLongestLine> bytes{};
  const ssize_t count = ::read(file_ < 0 ? stream_.native_handle() : file_, bytes.data(), bytes.size());
  if (count > 0) pending_.append(bytes.data(), static_cast<std::size_t>(count));
  co_return count > 0;
}

asio::awaitable<std::optional<std::string>> LineReader::next() {
  std::string line;
  for (;;) {
    const std::size_t end = pending_.find('\n');
    line.append(pending_, 0, end);
    if (line.size() > kLongestLine) line.resize(kLongestLine);
    if (end != std::string::npos) {
      pending_.erase(0, end + 1);
      break;
    }
    pending_.clear();
    if (!co_await read_more()) {
      if (line.empty()) co_return std::nullopt;
      break;
    }
  }
  if (line.ends_with('\r')) line.pop_back();
  co_return line;
}

}  // namespace cnclab::station
