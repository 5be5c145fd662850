// Reading the command line with CLI11; every value is checked here, before anything is connected.
#include "station/options.hpp"

#include <CLI/CLI.hpp>
#include <string_view>

#include "shared/credential_limits.hpp"
#include "station/command_fault.hpp"
#include "station/utf8.hpp"

namespace cnclab::station {
namespace {

// "SHA256:" and the 43 base64 digits of 32 bytes.
bool is_fingerprint(const std::string& text) {
  constexpr std::string_view kPrefix = "SHA256:";
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  return text.size() == kPrefix.size() + 43 && text.starts_with(kPrefix) &&
         text.find_first_not_of(kDigits, kPrefix.size()) == std::string::npos;
}

struct Raw {
  std::string server, user, password_file, new_password_file, fingerprint, media;
  int station = 0, observe = 0;
  bool take_over = false, look_on = false, ascii = false, headless = false;
};

void declare(CLI::App& app, Raw& raw) {
  app.add_option("--server", raw.server, "lab server")->type_name("HOST:PORT")->required();
  auto* const station =
      app.add_option("--station", raw.station, "seat, 1 to 15")->type_name("1-15")->check(CLI::Range(1, 15));
  app.add_option("--user", raw.user, "name; without --station or --user a form shows the free seats");
  app.add_option("--password-file", raw.password_file, "first line is the password; otherwise asked for");
  app.add_option("--new-password-file", raw.new_password_file, "answers a forced password change");
  app.add_option("--fingerprint", raw.fingerprint, "the server's certificate, SHA256:…; otherwise pinned on first use");
  app.add_option("--media", raw.media,
                 "folder of the tapes, diskettes and printed pages; by default one of each student's own below\n"
                 "$XDG_DATA_HOME/cnclab/media (~/.local/share/cnclab/media)")
      ->type_name("FOLDER")
      ->check(CLI::ExistingDirectory);
  app.add_option("--observe", raw.observe, "look at station N (instructors and observers)")
      ->type_name("1-15")
      ->check(CLI::Range(1, 15))
      ->excludes(station);
  auto* const take_over = app.add_flag("--take-over", raw.take_over, "end this student's login elsewhere");
  app.add_flag("--look-on", raw.look_on, "look on at this student's login elsewhere")->excludes(take_over);
  app.add_flag("--ascii", raw.ascii, "no characters beyond ASCII");
  app.add_flag("--headless", raw.headless, "commands on stdin, replies on stdout");
  app.set_version_flag("--version", "cnclab-station " CNCLAB_VERSION);
}

std::unexpected<Ending> usage(const std::string& text) {
  return std::unexpected(Ending{ExitCode::usage, text + "\ncnclab-station --help"});
}

std::unexpected<Ending> usage(std::string_view german, std::string_view english) {
  return usage(in_language_of_locale(german, english));
}

std::optional<std::filesystem::path> path_or_none(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional<std::filesystem::path>(text);
}

std::expected<Options, Ending> checked(const Raw& raw) {
  Options options;
  const auto server = parse_address(raw.server);
  if (!server)
    return usage(in_language_of_locale("--server: HOST:PORT, z. B. 127.0.0.1:3300 oder [::1]:3300, nicht ",
                                       "--server: HOST:PORT, e.g. 127.0.0.1:3300 or [::1]:3300, not ") +
                 raw.server);
  options.server = *server;
  options.station = StationId::of(raw.station);
  options.observe = StationId::of(raw.observe);
  options.user = raw.user;
  if (raw.user.size() > kLongestName)
    return usage("--user: höchstens 32 Bytes; ein Umlaut hat zwei", "--user: at most 32 bytes; an umlaut has two");
  if (line_not_utf8(raw.user)) return usage("--user: " + std::string(kNotUtf8Typed.in(language_of_locale())));
  options.password_file = path_or_none(raw.password_file);
  options.new_password_file = path_or_none(raw.new_password_file);
  if (!raw.media.empty())
    options.media = MediaPlace{raw.media, false};
  else if (const auto folder = default_media_folder(); !folder.empty())
    options.media = MediaPlace{folder, true};
  if (!raw.fingerprint.empty()) {
    if (!is_fingerprint(raw.fingerprint)) {
      return usage("--fingerprint: SHA256: und 43 Zeichen, wie der Server ihn beim Start ausgibt",
                   "--fingerprint: SHA256: and 43 characters, as the server prints it at its start");
    }
    options.trust.fingerprint = raw.fingerprint;
  }
  if (raw.take_over) options.elsewhere = v1::ELSEWHERE_TAKE_OVER;
  if (raw.look_on) options.elsewhere = v1::ELSEWHERE_LOOK_ON;
  options.is_ascii = raw.ascii;
  options.is_headless = raw.headless;
  if (raw.headless && (raw.user.empty() || options.seat() == 0)) {
    return usage("--headless braucht --user und --station (oder --observe)",
                 "--headless needs --user and --station (or --observe)");
  }
  return options;
}

}  // namespace

Door Options::door() const {
  if (observe) return {server, trust, v1::CLIENT_KIND_OBSERVER};
  return {server, trust, v1::CLIENT_KIND_STATION, media};
}

std::uint32_t Options::seat() const {
  const auto& named = observe ? observe : station;
  return named ? static_cast<std::uint32_t>(named->number()) : 0;
}

std::expected<Options, Ending> parse_options(int count, const char* const* arguments) {
  CLI::App app("A station of the CNC 3300 training lab", "cnclab-station");
  Raw raw;
  declare(app, raw);
  try {
    app.parse(count, arguments);
  } catch (const CLI::CallForHelp&) {
    return std::unexpected(Ending{ExitCode::ended_by_user, app.help()});
  } catch (const CLI::CallForVersion& version) {
    return std::unexpected(Ending{ExitCode::ended_by_user, std::string(version.what()) + "\n"});
  } catch (const CLI::ParseError& error) {
    return usage(fault_text(app, error, language_of_locale()));
  }
  return checked(raw);
}

}  // namespace cnclab::station
