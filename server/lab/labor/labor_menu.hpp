// The lab's own menu behind key LABOR: pages in rows 18 to 23, from the key pressed to what the lab is to do.
//
//   LABOR ─▶ StartPage ─▶ SubjectPage ─▶ ProgramPage ─▶ ReadingPage ─▶ VersionsPage ─▶ RestorePage ─▶ RestoreVersion
//                ├─▶ LanguagePage ─▶ ChooseLanguage
//                ├─▶ ListPage (messages, cassettes) ─▶ CassettePage ─▶ ActOnCassette
//                └─▶ AskForPassword, PrintScreen, LogOut
//
// Digits choose, ↓ +/- and → turn pages, C goes one page back, LABOR and MENU leave. A value without I/O: what a page
// needs is asked for by an order and handed in by `show_…`; what comes too late for its page is dropped.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lab/labor/cassette_page.hpp"
#include "language/units.hpp"
#include "shared/key.hpp"

namespace cnclab::lab {

/// Of what there are versions: a program, P0000 the tool table, or the machine data.
struct MachineDataSet {
  friend bool operator==(const MachineDataSet&, const MachineDataSet&) = default;
};
using Subject = std::variant<std::uint16_t, MachineDataSet>;

/// A version as a line of the menu.
struct LaborVersion {
  int number = 0;
  std::int64_t time_ms = 0;  ///< 0: of the delivery, by nobody
  std::string by{};
  int station = 0;     ///< 0: not from a station
  std::string kind{};  ///< as `db::ProgramVersion::kind`; machine data: the numbers that changed
  int block = 0;       ///< 0: no single block
};

/// The lists whose lines the lab writes itself.
enum class LaborList : std::uint8_t { messages, cassettes };

// The pages
struct StartPage {};
struct SubjectPage {};
struct ProgramPage {
  std::string digits{};  ///< of the program's number, at most four
};
struct ReadingPage {
  Subject of;
};
struct VersionsPage {
  Subject of;
  std::vector<LaborVersion> versions{};  ///< newest first
  std::size_t first = 0;                 ///< that is shown
};
struct RestorePage {
  VersionsPage list;
  std::size_t chosen = 0;
};
struct LanguagePage {};
struct ListPage {
  LaborList list{};
  std::vector<std::string> lines{};
  std::size_t first = 0;
};
using LaborPage = std::variant<StartPage, SubjectPage, ProgramPage, ReadingPage, VersionsPage, RestorePage,
                               LanguagePage, ListPage, CassettePage>;

// The orders
struct CloseMenu {};
struct ReadVersions {
  Subject of;
};
struct RestoreVersion {
  Subject of;
  int version = 0;
};
struct AskForPassword {};
struct ChooseLanguage {
  language::Tongue tongue{};
};
struct PrintScreen {};
struct ReadList {
  LaborList list{};
};
/// A digit on a list of cassettes.
struct ChooseCassette {
  std::size_t index = 0;  ///< in the lines that `show_list` was given
};
/// EINGABE on the list of cassettes.
struct MakeCassette {};
struct ActOnCassette {
  std::size_t index = 0;  ///< as ChooseCassette
  CassetteAct act{};
  int number = 0;  ///< 0..99, for `rename`
};
struct LogOut {};
/// What the lab is to do; nothing where the key only moved within the menu.
using LaborOrder = std::variant<std::monostate, CloseMenu, ReadVersions, RestoreVersion, AskForPassword, ChooseLanguage,
                                PrintScreen, ReadList, ChooseCassette, MakeCassette, ActOnCassette, LogOut>;

/// What this lab offers; what it does not is not on the start page.
struct LaborFacilities {
  bool can_print_screen = false;
  bool has_cassettes = false;
};

class LaborMenu {
 public:
  /// Lines of a list on one page: rows 19 to 22.
  static constexpr std::size_t kLines = 4;

  explicit LaborMenu(LaborFacilities facilities) : facilities_(facilities) {}

  /// A key without a meaning on the present page does nothing.
  [[nodiscard]] LaborOrder press(Key key);
  /// For the page that waits for them.
  void show_versions(const Subject& of, std::vector<LaborVersion> newest_first);
  /// For the start page, where the list was chosen, or in place of the list's former lines.
  void show_list(LaborList list, std::vector<std::string> lines);
  /// For the list of cassettes, where this one was chosen, or in place of what its page has shown so far.
  void show_cassette(std::size_t index, std::string line, bool is_inserted);

  [[nodiscard]] const LaborPage& page() const { return page_; }
  [[nodiscard]] const LaborFacilities& facilities() const { return facilities_; }

 private:
  LaborOrder go_back();
  LaborFacilities facilities_;
  LaborPage page_ = StartPage{};
};

}  // namespace cnclab::lab
