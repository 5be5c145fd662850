// cnclab-server: reads the configuration, opens the data folder, wires the parts together, runs until told to stop.
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <iostream>
#include <memory>

#include "configuration_file.hpp"
#include "data_folder.hpp"
#include "db/store.hpp"
#include "lab/lab.hpp"
#include "machine/tick_thread.hpp"
#include "net/listen.hpp"
#include "net/metrics.hpp"
#include "net/serial_device.hpp"
#include "net/serial_listener.hpp"
#include "net/server.hpp"

namespace cnclab {
namespace {

namespace asio = boost::asio;

struct CommandLine {
  std::string config_file;
  std::string listen, data, model, language, log_level = "info", restore;
  bool print_config = false, new_instructor_password = false;
};

int fail(const std::string& text) {
  std::cerr << "cnclab-server: " << text << '\n';
  return 1;
}

std::expected<lab::Configuration, std::string> configuration_for(const CommandLine& line) {
  lab::Configuration configuration;
  if (!line.config_file.empty()) {
    auto read = read_configuration(line.config_file);
    if (!read) return read;
    configuration = *read;
  }
  if (!line.listen.empty()) configuration.listen = line.listen;
  if (!line.data.empty()) configuration.data = line.data;
  if (line.model == "3250") configuration.model = language::Model::cnc3250;
  if (line.model == "3300") configuration.model = language::Model::cnc3300;
  if (line.language == "de") configuration.tongue = language::Tongue::german;
  if (line.language == "en") configuration.tongue = language::Tongue::english;
  return configuration;
}

void log_to_stderr(const std::string& level) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("cnclab"));
  spdlog::set_pattern("%Y-%m-%dT%H:%M:%S.%e %l %v");
  spdlog::set_level(spdlog::level::from_str(level));
}

/// Without them the beat may come late: the instructor is to know before a machine moves.
void log_privileges(const machine::TickThread& ticks) {
  if (ticks.is_real_time() && ticks.has_locked_memory()) return spdlog::info("tick: {}", ticks.privileges());
  spdlog::warn("tick: {}: ticks may come late on a busy computer; see docs/administration.md, real-time",
               ticks.privileges());
}

/// Ends the loop once the machine rests, at latest after 4 s (the promise is 5 s).
void stop_when_at_rest(asio::io_context& loop, net::Server& server, lab::Lab& lab, asio::steady_timer& timer,
                       int tries) {
  if (tries > 0 && !lab.at_rest()) {
    timer.expires_after(std::chrono::milliseconds(10));
    timer.async_wait([&loop, &server, &lab, &timer, tries](const boost::system::error_code&) {
      stop_when_at_rest(loop, server, lab, timer, tries - 1);
    });
    return;
  }
  server.stop();
  lab.close();
  timer.expires_after(std::chrono::milliseconds(200));  // the farewells go out
  timer.async_wait([&loop](const boost::system::error_code&) { loop.stop(); });
}

/// The serial lines of [dnc], where there are any.
struct SerialLines {
  std::unique_ptr<net::SerialListener> listener;
  std::shared_ptr<net::SerialDevice> device;

  void stop() const {
    if (listener) listener->stop();
    if (device) device->stop();
  }
};

/// Binds the listener, before there is a lab to serve.
std::expected<SerialLines, std::string> listen_for_lines(asio::io_context& loop,
                                                         const lab::Configuration& configuration,
                                                         const Certificate& certificate) {
  SerialLines lines;
  if (configuration.dnc_listen.empty()) return lines;
  auto listener = net::SerialListener::listen(loop, configuration.dnc_listen, certificate);
  if (!listener) return std::unexpected(listener.error());
  lines.listener = std::move(*listener);
  return lines;
}

void serve_lines(SerialLines& lines, asio::io_context& loop, const std::string& device, lab::Lab& lab) {
  if (lines.listener) {
    lines.listener->serve(lab.lines());
    spdlog::info("dnc: listening {} {}", lines.listener->address(), lines.listener->is_plain() ? "plain" : "TLS");
  }
  if (device.empty()) return;
  lines.device = std::make_shared<net::SerialDevice>(loop, device, lab.lines());
  lines.device->start();
}

/// Everything at which somebody may knock; bound before there is a lab to serve, so that a wrong address ends the
/// start.
struct Doors {
  std::unique_ptr<net::Server> server;
  SerialLines lines;
  std::unique_ptr<net::Metrics> metrics;
};

std::expected<Doors, std::string> open_doors(asio::io_context& loop, const lab::Configuration& configuration,
                                             const Certificate& certificate) {
  Doors doors;
  auto server = net::Server::listen(loop, configuration.listen, certificate);
  if (!server) return std::unexpected(server.error());
  doors.server = std::move(*server);
  auto lines = listen_for_lines(loop, configuration, certificate);
  if (!lines) return std::unexpected(lines.error());
  doors.lines = std::move(*lines);
  if (configuration.metrics.empty()) return doors;
  auto metrics = net::Metrics::listen(loop, configuration.metrics);
  if (!metrics) return std::unexpected(metrics.error());
  doors.metrics = std::move(*metrics);
  return doors;
}

void serve_at(Doors& doors, asio::io_context& loop, const lab::Configuration& configuration, lab::Lab& lab) {
  doors.server->serve(lab);
  serve_lines(doors.lines, loop, configuration.dnc_device, lab);
  if (!doors.metrics) return;
  doors.metrics->serve([&lab] { return lab.metrics(); });
  spdlog::info("metrics: http://{}/metrics", doors.metrics->address());
}

int serve(const lab::Configuration& configuration) {
  auto folder = open_data_folder(configuration.data);
  if (!folder) return fail(folder.error());
  // Before anything else can fail: it is shown this one time only.
  if (folder->first_password)
    std::cout << "instructor lehrer one-time-password " << *folder->first_password << std::endl;
  const auto fingerprint = fingerprint_of(folder->certificate.certificate_pem);
  if (!fingerprint) return fail(fingerprint.error());
  asio::io_context loop(1);
  auto doors = open_doors(loop, configuration, folder->certificate);
  if (!doors) return fail(doors.error());

  const db::Post post = [&loop](std::function<void()> job) { asio::post(loop, std::move(job)); };
  machine::TickThread ticks;
  log_privileges(ticks);
  db::Store store(std::move(folder->database), post);
  lab::Lab lab(configuration, store, ticks, post, lab::system_clock(), folder->inheritance);
  serve_at(*doors, loop, configuration, lab);
  asio::steady_timer stopping(loop);
  asio::signal_set signals(loop, SIGINT, SIGTERM);
  signals.async_wait([&](const boost::system::error_code& error, int signal) {
    if (error) return;
    spdlog::info("signal {}: the machine comes to rest, then the server ends", signal);
    lab.release_machine();
    doors->lines.stop();
    stop_when_at_rest(loop, *doors->server, lab, stopping, 400);
  });
  // Last of all: whoever has read it may already send a signal.
  std::cout << "listening " << doors->server->address() << " fingerprint " << *fingerprint << std::endl;
  loop.run();
  return 0;
}

int run(const CommandLine& line) {
  const auto configuration = configuration_for(line);
  if (!configuration) return fail(configuration.error());
  if (line.print_config) {
    std::cout << print_configuration(*configuration);
    return 0;
  }
  if (line.new_instructor_password) {
    const auto password = renew_instructor_password(configuration->data);
    if (!password) return fail(password.error());
    std::cout << "instructor lehrer one-time-password " << *password << std::endl;
    return 0;
  }
  if (!line.restore.empty()) {
    const auto done = restore_backup(configuration->data, line.restore);
    if (!done) return fail(done.error());
    std::cout << *done << std::endl;
    return 0;
  }
  log_to_stderr(line.log_level);
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is an error of that write (STO-009), not the lab's end
  return serve(*configuration);
}

}  // namespace
}  // namespace cnclab

int main(int argc, char** argv) {
  cnclab::CommandLine line;
  CLI::App app("The server of the CNC 3300 training lab: owns the machine, the students' programs and the selector.");
  app.set_version_flag("--version", "cnclab-server " CNCLAB_VERSION);
  app.add_option("--config", line.config_file, "configuration file (lab.toml)");
  app.add_option("--listen", line.listen, "address and port, default 127.0.0.1:3300; port 0 takes any")
      ->check([](const std::string& address) -> std::string {
        if (cnclab::net::endpoint_of(address)) return {};
        return "an address and a port is wanted, such as 127.0.0.1:3300";
      });
  app.add_option("--data", line.data, "data folder, default var");
  app.add_option("--model", line.model, "3300 or 3250")->check(CLI::IsMember({"3300", "3250"}));
  app.add_option("--language", line.language, "de or en")->check(CLI::IsMember({"de", "en"}));
  app.add_option("--log-level", line.log_level, "trace, debug, info, warn, error")
      ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "critical", "off"}));
  auto* restore = app.add_option("--restore", line.restore, "put this backup in the place of the database, then end");
  app.add_flag("--new-instructor-password", line.new_instructor_password, "print a new one-time password, then end")
      ->excludes(restore);  // each ends the program: one of the two would be left undone
  app.add_flag("--print-config", line.print_config, "print all keys of lab.toml with comments, then end");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? 0 : 2;
  }
  try {
    return cnclab::run(line);
  } catch (const std::exception& error) {
    std::cerr << "cnclab-server: " << error.what() << '\n';
    return 1;
  }
}
