// The inputs of the fuzzers, read here at every run: what was read is written, and written again it is the same.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "language/listing.hpp"
#include "language/program_text.hpp"

namespace cnclab::language {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> corpus(const std::string& name) {
  std::vector<std::string> texts;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(fs::path(CNCLAB_TEST_DATA).parent_path() / "fuzz" / "corpus" / name)) {
    std::ostringstream text;
    text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    texts.push_back(text.str());
  }
  return texts;
}

std::string as_tape(const Tape& tape) {
  std::string text;
  for (const ReadProgram& read : tape.programs) text += write_program(read.program);
  return text + write_machine_data(tape.machine_data);
}

std::string as_listing(const Tape& tape) {
  std::string text;
  for (const ReadProgram& read : tape.programs)
    text += write_listing(read.program, "09:00:00 16/06/83", Tongue::german);
  return text;
}

TEST(Corpus, WritingAndReadingIsAFixedPoint_D_101_EXT_005) {
  std::size_t programs = 0;
  for (const char* name : {"tape", "listing"}) {
    const bool is_tape = name == std::string_view("tape");
    for (const std::string& text : corpus(name)) {
      const Tape read = is_tape ? read_tape(text, Reading::file) : read_listing(text);
      const Tape printed = read_programs_text(as_listing(read), Reading::file);
      EXPECT_TRUE(printed.errors.empty()) << text;
      EXPECT_EQ(as_listing(printed), as_listing(read)) << text;
      const Tape punched = read_programs_text(as_tape(read), Reading::file);
      EXPECT_TRUE(punched.errors.empty()) << text;
      EXPECT_EQ(as_tape(punched), as_tape(read)) << text;
      programs += read.programs.size();
    }
  }
  EXPECT_GE(programs, 15U) << "the corpus was not found";
}

}  // namespace
}  // namespace cnclab::language
