// One program started by a test: its standard streams, its end, and the promise that it does not outlive the test.
#include "harness/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "harness/failure.hpp"

namespace cnclab::harness {
namespace {

constexpr auto kPatienceAfterTerm = 2s;

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }
  void close() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
  }
  [[nodiscard]] int get() const { return number_; }

 private:
  int number_ = -1;
};

struct Pipe {
  Descriptor read_end, write_end;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw Failure("pipe: " + std::generic_category().message(errno));
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

bool is_readable(int descriptor, const Deadline& deadline) {
  pollfd question{.fd = descriptor, .events = POLLIN, .revents = 0};
  return poll(&question, 1, deadline.remaining_ms()) > 0;
}

/// Only calls that are allowed between fork and exec in a program with threads.
[[noreturn]] void become(const char* program, char** argv, char** envp, int in, int out, int err) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  if (err >= 0) dup2(err, STDERR_FILENO);
  execve(program, argv, envp);
  constexpr int kNotFound = 127;
  _exit(kNotFound);
}

int exit_code_of(int status) {
  constexpr int kSignalBase = 128;
  return WIFEXITED(status) ? WEXITSTATUS(status) : kSignalBase + WTERMSIG(status);
}

}  // namespace

std::filesystem::path programs_folder() {
  const char* chosen = std::getenv("CNCLAB_PROGRAMS");
  return chosen != nullptr ? chosen : CNCLAB_BIN;
}

std::vector<char*> pointers_to(std::vector<std::string>& strings) {
  std::vector<char*> pointers;
  std::ranges::transform(strings, std::back_inserter(pointers), [](std::string& text) { return text.data(); });
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> environment_with(const std::vector<std::pair<std::string, std::string>>& added) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text(*entry);
    const auto is_replaced = [&](const auto& pair) { return text.starts_with(pair.first + "="); };
    if (std::ranges::none_of(added, is_replaced)) all.emplace_back(text);
  }
  for (const auto& [name, value] : added) all.push_back(std::string(name).append("=").append(value));
  return all;
}

std::optional<int> wait_for_exit(pid_t pid, Milliseconds limit) {
  // glibc 2.36 declares pidfd_open without C linkage, so a C++ program cannot link it.
  const Descriptor process(static_cast<int>(syscall(SYS_pidfd_open, pid, 0)));
  if (process.get() < 0 || !is_readable(process.get(), Deadline(limit))) return std::nullopt;
  int status = 0;
  if (waitpid(pid, &status, 0) != pid) return std::nullopt;
  return exit_code_of(status);
}

struct ChildProcess::Impl {
  pid_t pid = -1;
  Descriptor input, output;
  std::string unread;
  std::optional<int> exit_code;

  /// Reads what is there into `unread`; false at the end of the output or of the time.
  bool fill(const Deadline& deadline) {
    if (output.get() < 0 || !is_readable(output.get(), deadline)) return false;
    std::array<char, 4096> bytes{};
    const auto count = read(output.get(), bytes.data(), bytes.size());
    if (count <= 0) return false;
    unread.append(bytes.data(), static_cast<std::size_t>(count));
    return true;
  }
};

ChildProcess::ChildProcess(const Launch& launch) : impl_(std::make_unique<Impl>()) {
  std::signal(SIGPIPE, SIG_IGN);  // a program that has ended is an answer, not the end of the test
  Pipe in = make_pipe();
  Pipe out = make_pipe();
  Descriptor err;
  if (!launch.stderr_file.empty()) {
    constexpr mode_t kOwnerOnly = 0600;
    err = Descriptor(open(launch.stderr_file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, kOwnerOnly));
  }
  std::vector<std::string> arguments{launch.program.string()};
  arguments.insert(arguments.end(), launch.arguments.begin(), launch.arguments.end());
  std::vector<std::string> environment = environment_with(launch.environment);
  const auto argv = pointers_to(arguments);
  const auto envp = pointers_to(environment);
  impl_->pid = fork();
  if (impl_->pid < 0) throw Failure("fork: " + std::generic_category().message(errno));
  if (impl_->pid == 0) {
    become(launch.program.c_str(), const_cast<char**>(argv.data()), const_cast<char**>(envp.data()), in.read_end.get(),
           out.write_end.get(), err.get());
  }
  impl_->input = std::move(in.write_end);
  impl_->output = std::move(out.read_end);
}

ChildProcess::ChildProcess(ChildProcess&&) noexcept = default;

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(impl_, other.impl_);  // the former process ends with `other`
  return *this;
}

ChildProcess::~ChildProcess() {
  if (!impl_ || impl_->pid < 0 || impl_->exit_code) return;
  impl_->input.close();
  send_signal(SIGTERM);
  if (wait(kPatienceAfterTerm)) return;
  send_signal(SIGKILL);
  int status = 0;
  waitpid(impl_->pid, &status, 0);
}

pid_t ChildProcess::pid() const { return impl_->pid; }

bool ChildProcess::write(std::string_view text) {
  while (!text.empty()) {
    const auto count = ::write(impl_->input.get(), text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void ChildProcess::close_input() { impl_->input.close(); }

std::optional<std::string> ChildProcess::read_line(const Deadline& deadline) {
  std::size_t end = impl_->unread.find('\n');
  while (end == std::string::npos) {
    if (!impl_->fill(deadline)) return std::nullopt;
    end = impl_->unread.find('\n');
  }
  std::string line = impl_->unread.substr(0, end);
  impl_->unread.erase(0, end + 1);
  return line;
}

std::string ChildProcess::read_rest(const Deadline& deadline) {
  while (impl_->fill(deadline)) {
  }
  return std::exchange(impl_->unread, {});
}

void ChildProcess::send_signal(int signal) {
  if (impl_->pid > 0 && !impl_->exit_code) ::kill(impl_->pid, signal);
}

std::optional<int> ChildProcess::wait(Milliseconds limit) {
  if (!impl_->exit_code) impl_->exit_code = wait_for_exit(impl_->pid, limit);
  return impl_->exit_code;
}

}  // namespace cnclab::harness
