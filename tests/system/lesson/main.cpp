// cnclab-lesson: plays the demo lesson without a terminal and says whether every part came out as drawn.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>

#include "lesson.hpp"

namespace {

void on_signal(int) { cnclab::lesson::interrupt_lesson(); }

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Plays the demo lesson: a real server, fifteen real stations, one machine.\n"
      "Exits 0 only if every part came out as drawn.");
  std::string bin, out = "var/lesson";
  app.add_option("--bin", bin, "folder with the programs (default: where this program was built)");
  app.add_option("--out", out, "folder for database, traces, tapes, pictures and logs")->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    constexpr int kUsage = 2;  // as of the other programs
    return app.exit(error) == 0 ? 0 : kUsage;
  }
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  if (!bin.empty()) setenv("CNCLAB_PROGRAMS", std::filesystem::absolute(bin).c_str(), 1);
  try {
    out = std::filesystem::absolute(out);
    std::filesystem::create_directories(out + "/tmp");
    setenv("TMPDIR", (out + "/tmp").c_str(), 1);
  } catch (const std::filesystem::filesystem_error& error) {
    fmt::print(stderr, "error: --out {}: {}; name a folder that you may write to\n", out, error.code().message());
    return 1;
  }
  cnclab::lesson::Lesson lesson(out);
  try {
    return lesson.play() ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "\nThe lesson failed after: {}\n{}\nLogs of all programs: {}/logs\n", lesson.step(),
               error.what(), out);
    return 1;
  }
}
