// Files and standard input, bounded and checked.
#include "tool/text_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

namespace cnclab::tool {

namespace {

using language::Tongue;

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::expected<std::string, std::string> read_all(std::FILE* file, Tongue tongue) {
  std::string text;
  std::array<char, 65536> part{};
  for (std::size_t count = part.size(); count == part.size();) {
    count = std::fread(part.data(), 1, part.size(), file);
    text.append(part.data(), count);
    if (text.size() > kLargestFile_bytes)
      return std::unexpected(say(tongue, "Datei größer als 64 MiB. Programme auf mehrere Dateien verteilen.",
                                 "file larger than 64 MiB. Spread the programs over several files."));
  }
  if (std::ferror(file) != 0)
    return std::unexpected(
        say(tongue, "Lesefehler. Datei und Datenträger prüfen.", "read error. Check the file and its medium."));
  return text;
}

/// Tapes use NUL as separator, DC1 and DC3 as commands, tabs and line ends as layout (EXT-049 to EXT-054).
bool is_tape_control(unsigned char byte) {
  return byte == 0 || (byte >= '\t' && byte <= '\r') || byte == 0x11 || byte == 0x13 || byte == 0x1A;
}

/// Length of the UTF-8 sequence at `at`, 0 where there is none.
std::size_t sequence_length(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((static_cast<unsigned char>(text[at + i]) & 0xC0U) != 0x80U) return 0;
  return length;
}

/// Position of the first byte that no text has.
std::optional<std::size_t> first_foreign_byte(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const std::size_t length = sequence_length(text, at);
    if (length == 0 || (byte < ' ' && !is_tape_control(byte))) return at;
    at += length;
  }
  return std::nullopt;
}

}  // namespace

std::expected<std::string, std::string> read_file(const std::string& name, Tongue tongue) {
  if (name == "-") return read_all(stdin, tongue);
  std::error_code ignored;
  if (std::filesystem::is_directory(name, ignored))
    return std::unexpected(
        say(tongue, "ist ein Verzeichnis. Eine Programmdatei angeben.", "is a directory. Name a program file."));
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(name.c_str(), "rb"));
  if (file == nullptr) {
    const std::string reason = std::error_code(errno, std::generic_category()).message();
    return std::unexpected(fmt::format(fmt::runtime(say(tongue, "nicht lesbar ({}). Name und Rechte prüfen.",
                                                        "cannot be read ({}). Check name and permissions.")),
                                       reason));
  }
  return read_all(file.get(), tongue);
}

std::expected<std::string, std::string> read_text_file(const std::string& name, Tongue tongue) {
  auto text = read_file(name, tongue);
  if (!text) return text;
  if (text->find_first_not_of(" \t\r\n") == std::string::npos)
    return std::unexpected(say(tongue, "ist leer. Erwartet wird ein Programm, z. B. P0001N001G00X+1000%.",
                               "is empty. A program is expected, e.g. P0001N001G00X+1000%."));
  if (const auto foreign = first_foreign_byte(*text))
    return std::unexpected(fmt::format(
        fmt::runtime(say(tongue, "ist keine Textdatei (Byte {:02X}H an Stelle {}). Erwartet wird ein Lochstreifentext.",
                         "is no text file (byte {:02X}H at position {}). A tape text is expected.")),
        static_cast<unsigned char>((*text)[*foreign]), *foreign));
  return text;
}

void print_problem(const std::string& file, const std::string& message) {
  fmt::print(stderr, "{}: {}\n", file, message);
}

}  // namespace cnclab::tool
