// Runs the real cnclab-tool as a process and keeps what it said.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace cnclab::tool {

struct Said {
  int exit_code = -1;
  std::string out, err;
};

/// A folder of its own for every test, gone afterwards.
class ToolTest : public testing::Test {
 protected:
  ToolTest() {
    std::string name = (std::filesystem::temp_directory_path() / "cnclab-tool-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
  }
  ~ToolTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  /// Path of a file in the test's folder.
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(at(name), std::ios::binary) << text;
    return at(name);
  }

  [[nodiscard]] static std::string read(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }

  /// `arguments` as typed in a shell; `input` is standard input.
  [[nodiscard]] Said tool(const std::string& arguments, const std::string& input = {}) const {
    const std::string in = write("stdin", input);
    std::ostringstream command;
    command << "LC_ALL=C '" << CNCLAB_BIN << "/cnclab-tool' " << arguments << " < '" << in << "' > '" << at("stdout")
            << "' 2> '" << at("stderr") << "'";
    const int status = std::system(command.str().c_str());
    Said said{.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
              .out = read(at("stdout")),
              .err = read(at("stderr"))};
    return said;
  }

 private:
  std::filesystem::path folder_;
};

inline const std::string kPicture7 =
    "P0001\nN001G00X+50000Y+50000Z+50000\nN002G04H0010\nN003G01X+25000Y+10000Z+4000F1000M03\n"
    "N004G02X+10000Y+0I+5000J+0\nN005G20P0001N001\n%\n";

}  // namespace cnclab::tool
