// Starting lp, without a shell, and waiting for it with a limit.
#include "lab/media/print_queue.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

extern "C" {
#include <sys/pidfd.h>  // glibc 2.36 declares it for C only
}

namespace cnclab::lab {

namespace {

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

/// Memory that a child can read as its input: no pipe that could fill, no file on disk.
bool fill(const Descriptor& memory, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(memory.number(), bytes.data() + done, bytes.size() - done);
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return ::lseek(memory.number(), 0, SEEK_SET) == 0;
}

/// The first line of what the child has said.
std::string first_line(const Descriptor& memory) {
  std::array<char, 200> buffer{};
  const ssize_t count = ::pread(memory.number(), buffer.data(), buffer.size(), 0);
  std::string text(buffer.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  text = text.substr(0, text.find('\n'));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return text;
}

std::string reason_of(int number) { return std::string("lp: ") + std::strerror(number); }

/// 0 or errno.
int start(pid_t& child, const std::string& queue, const std::string& title, int input, int output) {
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
  std::array<std::string, 5> words{"lp", "-d", queue, "-t", title};
  std::array<char*, 6> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  const int result = ::posix_spawnp(&child, "lp", &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  return result;
}

/// False when the limit has passed; then the child has been ended. It is waited for in either case.
bool wait_for(pid_t child, std::chrono::milliseconds patience, int& status) {
  const Descriptor handle(::pidfd_open(child, 0));
  pollfd ended{handle.number(), POLLIN, 0};
  const bool has_ended = handle.number() >= 0 && ::poll(&ended, 1, static_cast<int>(patience.count())) == 1;
  if (!has_ended) ::kill(child, SIGKILL);
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return has_ended;
}

}  // namespace

std::expected<void, std::string> print_pages(const std::string& queue, const std::string& title, const std::string& pdf,
                                             std::chrono::milliseconds patience) {
  const Descriptor pages(::memfd_create("pages", MFD_CLOEXEC)), said(::memfd_create("said", MFD_CLOEXEC));
  if (pages.number() < 0 || said.number() < 0 || !fill(pages, pdf)) return std::unexpected(reason_of(errno));
  pid_t child = 0;
  if (const int number = start(child, queue, title, pages.number(), said.number()))
    return std::unexpected(reason_of(number));
  int status = 0;
  if (!wait_for(child, patience, status)) return std::unexpected("lp: " + std::string(std::strerror(ETIMEDOUT)));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  const std::string text = first_line(said);
  return std::unexpected(text.empty() ? "lp: exit " + std::to_string(status) : text);
}

}  // namespace cnclab::lab
