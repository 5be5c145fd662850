// Programs that must be refused: the comments at the top of each file in bad/ are exactly the errors, as `check` has
// them. A file that is accepted fails the test.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "language/check_block.hpp"
#include "language/tape.hpp"

namespace cnclab::language {
namespace {

namespace fs = std::filesystem;

std::string file_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The lines "(…)" before the first other one, without their parentheses.
std::string expected_of(const std::string& text) {
  std::string expected;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line) && line.starts_with('(') && line.ends_with(')');)
    expected += line.substr(1, line.size() - 2) + '\n';
  return expected;
}

/// "3: P0001 N002: sentence", first what the reader says, then what the checks say.
std::string errors_of(const Tape& tape) {
  std::vector<Error> errors = tape.errors;
  for (const ReadProgram& read : tape.programs) {
    for (Error error : check_program(read.program, {}, nullptr)) {
      error.line = read.lines.at(*read.program.find(error.block));
      errors.push_back(std::move(error));
    }
  }
  std::string text;
  for (const Error& error : errors) text += std::to_string(error.line) + ": " + explain(error, Tongue::german) + '\n';
  return text;
}

TEST(BadFile, IsRefusedWithTheErrorsOfItsFirstLines) {
  int files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(CNCLAB_TEST_DATA) / "bad")) {
    if (entry.path().extension() != ".cnc") continue;
    ++files;
    SCOPED_TRACE(entry.path().filename());
    const std::string text = file_text(entry.path());
    const std::string expected = expected_of(text);
    EXPECT_FALSE(expected.empty()) << "the file names no error";
    EXPECT_EQ(errors_of(read_tape(text, Reading::file)), expected);
  }
  EXPECT_GE(files, 20);
}

}  // namespace
}  // namespace cnclab::language
