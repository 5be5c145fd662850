// The command line of cnclab-station (interfaces.md section 3, SEAT-001).
#include "station/options.hpp"

#include <gtest/gtest.h>

namespace cnclab::station {
namespace {

std::expected<Options, Ending> parsed(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "cnclab-station");
  return parse_options(static_cast<int>(arguments.size()), arguments.data());
}

const std::string kFingerprint = "SHA256:" + std::string(43, 'A');

TEST(Options, EverythingGiven) {
  const auto options = parsed({"--server", "[::1]:3300", "--station", "15", "--user", "anna", "--password-file", "p",
                               "--new-password-file", "n", "--fingerprint", kFingerprint.c_str(), "--media", "/tmp",
                               "--look-on", "--ascii", "--headless"});
  ASSERT_TRUE(options) << options.error().text;
  EXPECT_EQ(options->server.host, "::1");
  EXPECT_EQ(options->seat(), 15U);
  EXPECT_EQ(options->user, "anna");
  EXPECT_EQ(options->password_file, "p");
  EXPECT_EQ(options->new_password_file, "n");
  EXPECT_EQ(options->trust.fingerprint, kFingerprint);
  EXPECT_EQ(options->elsewhere, v1::ELSEWHERE_LOOK_ON);
  EXPECT_TRUE(options->is_ascii);
  EXPECT_TRUE(options->is_headless);
  EXPECT_EQ(options->door().kind, v1::CLIENT_KIND_STATION);
  ASSERT_TRUE(options->door().media);
  EXPECT_EQ(options->door().media->folder, "/tmp");
  EXPECT_FALSE(options->door().media->is_default);
}

TEST(Options, OnlyTheServerIsNeeded) {
  const auto options = parsed({"--server", "lab:3300"});
  ASSERT_TRUE(options) << options.error().text;
  EXPECT_EQ(options->seat(), 0U);
  EXPECT_FALSE(options->trust.fingerprint);
}

TEST(Options, AnObserverLooksAtAStation) {
  const auto options = parsed({"--server", "lab:3300", "--observe", "3"});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->seat(), 3U);
  EXPECT_EQ(options->door().kind, v1::CLIENT_KIND_OBSERVER);
}

TEST(Options, WrongOnesAreExitCode2AndNameTheOption) {
  struct Row {
    std::vector<const char*> arguments;
    const char* named;
  };
  const std::string short_fingerprint = "SHA256:abc", long_name(33, 'x');
  const Row rows[] = {
      {{}, "--server"},
      {{"--server", "lab"}, "--server"},
      {{"--server", "lab:0"}, "--server"},
      {{"--server", "lab:1", "--station", "0"}, "--station"},
      {{"--server", "lab:1", "--station", "16"}, "--station"},
      {{"--server", "lab:1", "--station", "x"}, "--station"},
      {{"--server", "lab:1", "--observe", "16"}, "--observe"},
      {{"--server", "lab:1", "--observe", "1", "--station", "1"}, "--observe"},
      {{"--server", "lab:1", "--take-over", "--look-on"}, "--look-on"},
      {{"--server", "lab:1", "--fingerprint", short_fingerprint.c_str()}, "--fingerprint"},
      {{"--server", "lab:1", "--media", "/no/such/folder"}, "--media"},
      {{"--server", "lab:1", "--user", long_name.c_str()}, "--user"},
      {{"--server", "lab:1", "--headless"}, "--headless"},
      {{"--server", "lab:1", "--headless", "--user", "a"}, "--station"},
      {{"--server", "lab:1", "--frobnicate"}, "--frobnicate"},
      {{"--server", "lab:1", "stray"}, "stray"},
  };
  for (const Row& row : rows) {
    const auto options = parsed(row.arguments);
    ASSERT_FALSE(options) << row.named;
    EXPECT_EQ(options.error().code, ExitCode::usage) << row.named;
    EXPECT_NE(options.error().text.find(row.named), std::string::npos) << row.named << ": " << options.error().text;
  }
}

TEST(Options, WrongOnesAreToldInTheLanguageOfTheLocale) {
  struct Row {
    std::vector<const char*> arguments;
    const char *german, *english;
  };
  const std::string long_name = "ü" + std::string(31, 'x');
  const Row rows[] = {
      {{},
       "--server fehlt, oder sein Wert: --server HOST:PORT.",
       "--server is missing, or its value: --server HOST:PORT."},
      {{"--server", "lab:1", "--station", "16"},
       "--station: „16“ passt nicht zu 1-15.",
       "--station: \"16\" does not fit 1-15."},
      {{"--server", "lab:1", "--station", "x"},
       "--station: „x“ passt nicht zu 1-15.",
       "--station: \"x\" does not fit 1-15."},
      {{"--server", "lab:1", "--media", "/nix"},
       "--media: Den Ordner „/nix“ gibt es nicht.",
       "--media: There is no folder \"/nix\"."},
      {{"--server", "lab:1", "--take-over", "--look-on"}, "schließen einander aus.", "exclude each other."},
      {{"--server", "lab:1", "--user", long_name.c_str()},
       "höchstens 32 Bytes; ein Umlaut hat zwei",
       "at most 32 bytes"},
      {{"--server", "lab:1", "--frobnicate"}, "„--frobnicate“ ist zu viel.", "\"--frobnicate\" is too much."},
  };
  for (const Row& row : rows)
    for (const bool is_german : {true, false}) {
      setenv("LC_ALL", is_german ? "de_DE.UTF-8" : "en_GB.UTF-8", 1);
      const auto options = parsed(row.arguments);
      ASSERT_FALSE(options) << row.english;
      EXPECT_NE(options.error().text.find(is_german ? row.german : row.english), std::string::npos)
          << options.error().text;
    }
  unsetenv("LC_ALL");
}

TEST(Options, HelpEndsWell) {
  const auto options = parsed({"--help"});
  ASSERT_FALSE(options);
  EXPECT_EQ(options.error().code, ExitCode::ended_by_user);
  for (const char* const option :
       {"--server", "--station", "--user", "--password-file", "--new-password-file", "--fingerprint", "--media",
        "--observe", "--take-over", "--look-on", "--ascii", "--headless"}) {
    EXPECT_NE(options.error().text.find(option), std::string::npos) << option;
  }
}

}  // namespace
}  // namespace cnclab::station
