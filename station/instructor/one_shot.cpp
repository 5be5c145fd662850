// One command, its answer on stdout, and an exit code.
#include "instructor/one_shot.hpp"

#include <optional>

#include "instructor/bulk_file.hpp"
#include "instructor/collection.hpp"
#include "instructor/item_text.hpp"
#include "instructor/prompts.hpp"

namespace cnclab::instructor {
namespace {

using boost::asio::awaitable;
template <class T>
using Result = std::expected<T, Failure>;

constexpr int kUsage = static_cast<int>(station::ExitCode::usage);

void print(const v1::InstructorItem& item, std::FILE* out) {
  const std::string text = text_of(item);
  std::fwrite(text.data(), 1, text.size(), out);
  std::fflush(out);
}

void print_done(std::FILE* out, const std::string& detail = {}) {
  v1::InstructorItem done;
  done.mutable_done()->set_ok(true);
  done.mutable_done()->set_detail(detail);
  print(done, out);
}

/// False when nobody reads the output any more.
bool print(const Screen& screen, std::FILE* out) {
  v1::InstructorItem item;
  for (int row = 0; row < Screen::kRows; ++row) item.mutable_screen()->add_rows(screen.text(row));
  print(item, out);
  return std::ferror(out) == 0;
}

Result<void> split(const std::filesystem::path& collection, std::FILE* out) {
  const auto files = split_collection(collection, collection.parent_path());
  if (!files) return std::unexpected(files.error());
  for (const auto& file : *files) print_done(out, file.string());
  return {};
}

/// `passwd`: a forced change has already done it.
awaitable<Result<void>> change_own_password(Entry& entry, const std::string& password, std::FILE* out) {
  if (!entry.changed_password) {
    v1::InstructorRequest request;
    request.mutable_passwd()->set_new_password(password);
    Sink nothing_to_print = [](const v1::InstructorItem&) {};
    auto changed = co_await ask(entry.client, std::move(request), std::move(nothing_to_print), nullptr);
    if (!changed) co_return changed;
  }
  print_done(out);
  co_return Result<void>();
}

std::expected<std::string, Failure> asked_password() {
  const auto password = ask_secret("Passwort / password: ");
  if (!password)
    return std::unexpected(Failure{kUsage, own_words({"ohne Terminal ist --password-file FILE nötig",
                                                      "--password-file FILE is needed where there is no terminal"})});
  return *password;
}

awaitable<Result<void>> carry_out(station::Client& client, Command& command, std::FILE* out) {
  if (command.request.has_watch()) {
    ScreenSink to_screen = [out](const Screen& screen) { return print(screen, out); };
    co_return co_await follow_screen(client, std::move(command.request), std::move(to_screen));
  }
  std::optional<BulkFile> file;
  if (!command.content_file.empty()) file.emplace(command.content_file);
  Sink to_output = [out](const v1::InstructorItem& item) { print(item, out); };
  auto done = co_await ask(client, std::move(command.request), std::move(to_output), file ? &*file : nullptr);
  if (!done) done.error().text = with_sent_file(command, done.error().text);
  if (done && command.is_collection) co_return split(command.content_file, out);
  if (done && file) print_done(out, command.content_file.string());
  co_return done;
}

}  // namespace

Result<Credentials> credentials_for(Access& access) {
  if (access.user.empty()) access.user = ask("Name: ").value_or("");
  if (access.user.empty())
    return std::unexpected(Failure{kUsage, own_words({"ohne Terminal ist --user NAME nötig",
                                                      "--user NAME is needed where there is no terminal"})});
  Credentials credentials{.user = access.user, .password = {}, .new_password = {}, .may_ask = true};
  auto password = access.password_file.empty() ? asked_password() : password_in(access.password_file);
  if (!password) return std::unexpected(password.error());
  credentials.password = std::move(*password);
  if (!access.new_password_file.empty()) {
    auto new_password = password_in(access.new_password_file);
    if (!new_password) return std::unexpected(new_password.error());
    credentials.new_password = std::move(*new_password);
    credentials.may_ask = false;
  }
  return credentials;
}

awaitable<Result<void>> run_one_shot(Access access, Command command, std::FILE* out) {
  auto credentials = credentials_for(access);
  if (!credentials) co_return std::unexpected(credentials.error());
  if (command.changes_own_password && !credentials->new_password) credentials->new_password = ask_new_password();
  if (command.changes_own_password && !credentials->new_password) {
    co_return std::unexpected(
        Failure{kUsage, own_words({"passwd: ohne Terminal ist --new-password-file FILE nötig",
                                   "passwd: --new-password-file FILE is needed where there is no terminal"})});
  }
  auto entry = co_await enter(access, *credentials);
  if (!entry) co_return std::unexpected(entry.error());
  Result<void> result;
  if (command.changes_own_password) {
    result = co_await change_own_password(*entry, *credentials->new_password, out);
  } else {
    result = co_await carry_out(entry->client, command, out);
  }
  co_await log_out(entry->client);
  co_return result;
}

}  // namespace cnclab::instructor
