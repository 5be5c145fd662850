// Key names and chords (interfaces.md section 3), and the same numbers on the wire.
#include "shared/key.hpp"

#include <cnclab/v1/keys.pb.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace cnclab {
namespace {

std::vector<Key> every_key() {
  std::vector<Key> keys;
  for (int number = 1; number <= kKeys; ++number) keys.push_back(static_cast<Key>(number));
  return keys;
}

TEST(Key, EveryKeyHasItsOwnNameAndIsFoundByIt) {
  std::set<std::string_view> names;
  for (const Key key : every_key()) {
    EXPECT_TRUE(names.insert(name_of(key)).second) << name_of(key);
    EXPECT_EQ(key_of(name_of(key)), key) << name_of(key);
  }
  EXPECT_EQ(names.size(), 43U);
}

TEST(Key, NamesAndNumbersAreThoseOfTheWire) {
  for (const Key key : every_key()) {
    const int number = static_cast<int>(key);
    ASSERT_TRUE(v1::Key_IsValid(number)) << number;
    EXPECT_EQ(v1::Key_Name(static_cast<v1::Key>(number)), "KEY_" + std::string(name_of(key)));
  }
  EXPECT_EQ(static_cast<int>(v1::Key_MAX), kKeys);
}

TEST(Key, UnknownNamesAreNoKeys) {
  for (const char* const name : {"", "none", "hand", "START ", "10", "+X", "->"}) {
    EXPECT_FALSE(key_of(name)) << name;
  }
  EXPECT_TRUE(name_of(Key::none).empty());
  EXPECT_TRUE(name_of(static_cast<Key>(200)).empty());
}

TEST(Key, Chords) {
  struct Row {
    const char* chord;
    std::vector<Key> keys;
  };
  const Row rows[] = {
      {"ENTER+RESET", {Key::ENTER, Key::RESET}},
      {"3+6+9", {Key::D3, Key::D6, Key::D9}},
      {"EINGABE", {Key::EINGABE}},
      {"", {}},
      {"ENTER+", {}},
      {"+ENTER", {}},
      {"ENTER++RESET", {}},
      {"ENTER+FOO", {}},
      {"3+3", {}},
  };
  for (const Row& row : rows) EXPECT_EQ(keys_of(row.chord), row.keys) << row.chord;
}

TEST(Key, DigitsOfDigitKeysOnly) {
  EXPECT_EQ(digit_of(Key::D0), 0);
  EXPECT_EQ(digit_of(Key::D9), 9);
  EXPECT_FALSE(digit_of(Key::POINT));
  EXPECT_FALSE(digit_of(Key::SATZ_LOESCHEN));
}

}  // namespace
}  // namespace cnclab
