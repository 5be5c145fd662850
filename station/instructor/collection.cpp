// Line by line: a name begins the next file.
#include "instructor/collection.hpp"

#include <fstream>
#include <optional>
#include <string>
#include <system_error>

namespace cnclab::instructor {
namespace {

/// "(anna)" names the student whose programs follow.
std::optional<std::string> name_in(const std::string& line) {
  if (line.size() < 3 || line.front() != '(' || line.back() != ')') return std::nullopt;
  return line.substr(1, line.size() - 2);
}

bool is_file_name(const std::string& name) { return name.find('/') == std::string::npos && name.front() != '.'; }

std::expected<void, Failure> write_file(const std::filesystem::path& file, const std::string& content) {
  const std::filesystem::path part = file.string() + ".part";
  std::ofstream stream(part, std::ios::binary | std::ios::trunc);
  stream << content;
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(part, file, error);
  if (stream && !error) return {};
  std::filesystem::remove(part, error);
  return std::unexpected(
      Failure{kRefused, file.string() + own_words({": nicht zu schreiben. Ist Platz da, darf man schreiben?",
                                                   ": cannot be written. Is there space, may you write?"})});
}

}  // namespace

std::expected<std::vector<std::filesystem::path>, Failure> split_collection(const std::filesystem::path& collection,
                                                                            const std::filesystem::path& folder) {
  std::ifstream stream(collection, std::ios::binary);
  std::vector<std::pair<std::string, std::string>> parts;  // name and text
  for (std::string line; std::getline(stream, line);) {
    if (const auto name = name_in(line)) {
      if (!is_file_name(*name))
        return std::unexpected(
            Failure{kRefused, *name + own_words({": kein Name für eine Datei", ": no name for a file"})});
      parts.emplace_back(*name, "");
    } else if (!parts.empty()) {
      parts.back().second += line + "\n";
    }
  }
  std::vector<std::filesystem::path> files;
  for (const auto& [name, text] : parts) {
    const auto file = folder / (name + ".tape");
    if (const auto written = write_file(file, text); !written) return std::unexpected(written.error());
    files.push_back(file);
  }
  std::error_code ignored;
  std::filesystem::remove(collection, ignored);
  return files;
}

}  // namespace cnclab::instructor
