// What each key does on each page.
#include "lab/labor/labor_menu.hpp"

#include <charconv>
#include <utility>

namespace cnclab::lab {

namespace {

constexpr std::size_t kProgramDigits = 4;
constexpr std::size_t kManyPages = 10;  ///< that → turns at once

/// ↓ one page on, → ten, +/- one back; behind the last page comes the first.
std::size_t turned(std::size_t first, std::size_t lines, Key key) {
  constexpr std::size_t kPage = LaborMenu::kLines;
  if (lines == 0) return 0;
  const std::size_t pages = (lines + kPage - 1) / kPage, page = first / kPage;
  if (key == Key::DOWN) return (page + 1) % pages * kPage;
  if (key == Key::SIGN) return (page + pages - 1) % pages * kPage;
  if (key == Key::ENTER) return (page + kManyPages < pages ? page + kManyPages : 0) * kPage;
  return first;
}

/// The line that a digit names: 1 to 4 from the top.
std::optional<std::size_t> line_of(Key key, std::size_t first, std::size_t lines) {
  const auto digit = static_cast<std::size_t>(digit_of(key).value_or(0));
  if (digit < 1 || digit > LaborMenu::kLines || first + digit > lines) return std::nullopt;
  return first + digit - 1;
}

std::uint16_t number_in(const std::string& digits) {
  std::uint16_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

/// One key on one page: the page becomes the next one, the order is filled in where there is one.
struct Press {
  LaborPage& page;
  LaborOrder& order;
  const LaborFacilities& facilities;
  Key key;

  void read(const Subject& of) const {
    page = ReadingPage{of};
    order = ReadVersions{of};
  }

  void operator()(const StartPage& /*here*/) const {
    const int choice = digit_of(key).value_or(0);
    if (choice == 1) page = SubjectPage{};
    if (choice == 2) order = AskForPassword{};
    if (choice == 3) page = LanguagePage{};
    if (choice == 4 && facilities.can_print_screen) order = PrintScreen{};
    if (choice == 5 && facilities.has_cassettes) order = ReadList{LaborList::cassettes};
    if (choice == 6) order = ReadList{LaborList::messages};
    if (choice == 7) order = LogOut{};
  }

  void operator()(const SubjectPage& /*here*/) const {
    if (key == Key::D1) page = ProgramPage{};
    if (key == Key::D2) read(std::uint16_t{0});
    if (key == Key::D3) read(MachineDataSet{});
  }

  void operator()(ProgramPage& here) const {
    const auto digit = digit_of(key);
    if (digit && here.digits.size() < kProgramDigits) here.digits += static_cast<char>('0' + *digit);
    if (key == Key::ENTER && !here.digits.empty()) read(number_in(here.digits));
  }

  void operator()(const ReadingPage& /*here*/) const {}

  void operator()(VersionsPage& here) const {
    here.first = turned(here.first, here.versions.size(), key);
    if (const auto line = line_of(key, here.first, here.versions.size())) {
      RestorePage question{std::move(here), *line};
      page = std::move(question);
    }
  }

  void operator()(const RestorePage& here) const {
    if (key == Key::ENTER) order = RestoreVersion{here.list.of, here.list.versions.at(here.chosen).number};
  }

  void operator()(const LanguagePage& /*here*/) const {
    if (key == Key::D1) order = ChooseLanguage{language::Tongue::german};
    if (key == Key::D2) order = ChooseLanguage{language::Tongue::english};
  }

  void operator()(ListPage& here) const {
    here.first = turned(here.first, here.lines.size(), key);
    const auto line = line_of(key, here.first, here.lines.size());
    if (here.list == LaborList::cassettes && line) order = ChooseCassette{*line};
    if (here.list == LaborList::cassettes && key == Key::EINGABE) order = MakeCassette{};
  }

  void operator()(CassettePage& here) const {
    const auto act = lab::press(here, key);
    if (!act) return;
    order = ActOnCassette{here.index, *act, number_in(here.digits)};
    if (act == CassetteAct::rename || act == CassetteAct::remove) page = ListPage{LaborList::cassettes};
  }
};

}  // namespace

LaborOrder LaborMenu::press(Key key) {
  if (key == Key::LABOR || key == Key::MENU) return CloseMenu{};
  if (key == Key::CLEAR) return go_back();
  LaborOrder order;
  std::visit(Press{page_, order, facilities_, key}, page_);
  return order;
}

LaborOrder LaborMenu::go_back() {
  if (std::holds_alternative<StartPage>(page_)) return CloseMenu{};
  if (auto* program = std::get_if<ProgramPage>(&page_); program != nullptr && !program->digits.empty()) {
    program->digits.pop_back();
  } else if (auto* question = std::get_if<RestorePage>(&page_)) {
    VersionsPage list = std::move(question->list);
    page_ = std::move(list);
  } else if (auto* cassette = std::get_if<CassettePage>(&page_)) {
    if (step_back(*cassette)) return {};
    page_ = ListPage{LaborList::cassettes};
    return ReadList{LaborList::cassettes};
  } else if (std::holds_alternative<SubjectPage>(page_) || std::holds_alternative<LanguagePage>(page_) ||
             std::holds_alternative<ListPage>(page_)) {
    page_ = StartPage{};
  } else {
    page_ = SubjectPage{};
  }
  return {};
}

void LaborMenu::show_versions(const Subject& of, std::vector<LaborVersion> newest_first) {
  const auto* reading = std::get_if<ReadingPage>(&page_);
  if (reading == nullptr || reading->of != of) return;
  page_ = VersionsPage{of, std::move(newest_first), 0};
}

void LaborMenu::show_list(LaborList list, std::vector<std::string> lines) {
  const auto* shown = std::get_if<ListPage>(&page_);
  const bool is_awaited = std::holds_alternative<StartPage>(page_) || (shown != nullptr && shown->list == list);
  if (!is_awaited) return;
  const std::size_t first = shown != nullptr && shown->first < lines.size() ? shown->first : 0;
  page_ = ListPage{list, std::move(lines), first};
}

void LaborMenu::show_cassette(std::size_t index, std::string line, bool is_inserted) {
  const auto* list = std::get_if<ListPage>(&page_);
  if (list != nullptr && list->list == LaborList::cassettes) page_ = CassettePage{index, {}, false};
  auto* page = std::get_if<CassettePage>(&page_);
  if (page == nullptr || page->index != index) return;
  page->line = std::move(line);
  page->is_inserted = is_inserted;
}

}  // namespace cnclab::lab
