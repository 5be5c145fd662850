// Blocks as key presses and as tape text.
#include "keying.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace cnclab::lesson {

namespace {

constexpr std::string_view kMillimetres = "XYZIJKURLQ";

struct Order {
  std::string_view function;
  std::array<std::string_view, 3> words;  ///< under G17, G18, G19
};

constexpr std::string_view kMotion = "XYZFSTM";
constexpr auto kOrders = std::to_array<Order>({
    {"00", {"XYZ", "XYZ", "XYZ"}},
    {"01", {kMotion, kMotion, kMotion}},
    {"02", {"XYIJ", "XZIK", "YZJK"}},
    {"03", {"XYIJ", "XZIK", "YZJK"}},
    {"04", {"H", "H", "H"}},
    {"11", {"FSTM", "FSTM", "FSTM"}},
    {"17", {"", "", ""}},
    {"18", {"", "", ""}},
    {"19", {"", "", ""}},
    {"20", {"PN", "PN", "PN"}},
    {"22", {"PNW", "PNW", "PNW"}},
    {"68", {"XYZ", "XYZ", "XYZ"}},
    {"90", {"", "", ""}},
    {"91", {"", "", ""}},
});

int digits_of(char address) {
  switch (address) {
    case 'N':
      return 3;
    case 'T':
    case 'M':
    case 'W':
      return 2;
    default:
      return 4;
  }
}

std::string tape_value(char address, const std::string& value) {
  if (!kMillimetres.contains(address)) {
    return fmt::format("{:0{}}", std::atoi(value.c_str()), digits_of(address));
  }
  const long micrometres = std::lround(std::strtod(value.c_str(), nullptr) * 1000);
  return fmt::format("{:+}", micrometres);
}

}  // namespace

WrittenBlock parse_block(std::string_view text) {
  std::istringstream words{std::string(text)};
  WrittenBlock block;
  std::string word;
  if (!(words >> word) || word.size() != 3 || word[0] != 'G') {
    throw std::invalid_argument("no block: " + std::string(text));
  }
  block.function = word.substr(1);
  while (words >> word) block.words[word[0]] = word.substr(1);
  return block;
}

std::string word_order(const std::string& function, int plane) {
  const auto order = std::ranges::find(kOrders, function, &Order::function);
  if (order == kOrders.end() || plane < 17 || plane > 19) throw std::invalid_argument("no word list for G" + function);
  return std::string(order->words[static_cast<std::size_t>(plane - 17)]);
}

int plane_after(const WrittenBlock& block, int plane) {
  return block.function >= "17" && block.function <= "19" ? std::atoi(block.function.c_str()) : plane;
}

std::vector<std::string> key_commands(const WrittenBlock& block, int plane) {
  std::vector<std::string> commands{"key ENTER", "type " + block.function, "key ENTER"};
  std::size_t left = block.words.size();
  for (const char address : word_order(block.function, plane)) {
    if (left == 0) break;
    if (const auto word = block.words.find(address); word != block.words.end()) {
      commands.push_back("type " + word->second);
      --left;
    }
    if (left > 0) commands.emplace_back("key ENTER");
  }
  if (left > 0) throw std::invalid_argument("G" + block.function + " has a word that it cannot take");
  commands.emplace_back("key EINGABE");
  return commands;
}

std::string tape_text(const WrittenBlock& block, int number, int plane) {
  std::string text = fmt::format("N{:03}G{}", number, block.function);
  for (const char address : word_order(block.function, plane)) {
    if (const auto word = block.words.find(address); word != block.words.end()) {
      text += address + tape_value(address, word->second);
    }
  }
  return text;
}

std::string tape_text(const WrittenProgram& program) {
  std::string text = fmt::format("P{:04}", program.number);
  int plane = 17;
  int number = 0;
  for (const std::string& line : program.blocks) {
    const WrittenBlock block = parse_block(line);
    plane = plane_after(block, plane);
    text += tape_text(block, ++number, plane);
  }
  return text;
}

std::string bare_tape(std::string_view text) {
  std::string bare;
  std::ranges::copy_if(text, std::back_inserter(bare), [](char c) { return c > ' ' && c != '%'; });
  return bare;
}

}  // namespace cnclab::lesson
