// What lies in the data folder and what is made there at the first start.
#include "data_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <chrono>
#include <sstream>

#include "db/backup.hpp"
#include "lab/passwords.hpp"
#include "lab/stored_control.hpp"

namespace cnclab {

namespace {

namespace fs = std::filesystem;

constexpr const char* kDatabase = "cnclab.db";
constexpr const char* kInstructor = "lehrer";

std::int64_t unix_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

/// One server per folder: the lock lasts as long as the process.
std::expected<void, std::string> lock_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    return std::unexpected("cannot make the data folder " + folder.string() + ": " + error.message() +
                           ". Choose another with --data DIR");
  fs::permissions(folder, fs::perms::owner_all,
                  error);  // passwords and keys are inside; on a foreign folder it is as it is
  const fs::path file = folder / "lock";
  const int handle = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (handle < 0)
    return std::unexpected("cannot write to the data folder " + folder.string() + ": " +
                           std::error_code(errno, std::generic_category()).message() +
                           ". Choose another with --data DIR, or give this user the right to write there");
  if (flock(handle, LOCK_EX | LOCK_NB) != 0) {
    close(handle);
    return std::unexpected("the data folder " + folder.string() +
                           " is in use by another server: stop it first, or choose another folder with --data DIR");
  }
  return {};
}

/// A lab is not begun anew because its file was cut off; what is written already may stand in the -wal file alone.
bool is_emptied(const fs::path& database) {
  std::error_code error;
  const auto size = fs::file_size(database, error);
  return !error && size == 0 && !fs::exists(database.string() + "-wal");
}

std::expected<db::Database, std::string> open_database(const fs::path& folder) {
  if (const auto locked = lock_folder(folder); !locked) return std::unexpected(locked.error());
  if (is_emptied(folder / kDatabase))
    return std::unexpected((folder / kDatabase).string() +
                           ": is empty: the lab that was in it is gone. Restore a backup with --restore BACKUP, or "
                           "remove the file for a new lab");
  auto database = db::Database::open(folder / kDatabase);
  if (!database) return std::unexpected(database.error().text);
  return std::move(*database);
}

std::expected<Certificate, std::string> certificate_of(db::Database& database) {
  const std::string remedy = ". Restore a backup: cnclab-server --restore BACKUP";
  const auto certificate = database.value("certificate");
  const auto key = database.value("private_key");
  if (certificate && key) {
    if (const auto fingerprint = fingerprint_of(*certificate); !fingerprint)
      return std::unexpected("the certificate in the database is damaged (" + fingerprint.error() + ")" + remedy);
    return Certificate{*certificate, *key};
  }
  if (!database.people(true).empty())  // the stations know the former one, and would not trust another
    return std::unexpected("the certificate is gone from the database" + remedy);
  auto made = make_certificate();
  if (!made) return std::unexpected("cannot make the server's certificate: " + made.error());
  database.transaction([&] {
    database.put_value("certificate", made->certificate_pem);
    database.put_value("private_key", made->key_pem);
  });
  return *made;
}

std::uint64_t number_of(const std::optional<std::string>& text) {
  std::uint64_t number = 0;
  if (text) std::from_chars(text->data(), text->data() + text->size(), number);
  return number;
}

/// "120 80 30"; nothing where none was ever set: lab.toml says it then.
std::optional<std::array<double, 3>> workpiece_of(const std::optional<std::string>& text) {
  if (!text) return std::nullopt;
  std::istringstream words(*text);
  std::array<double, 3> size_mm{};
  for (double& mm : size_mm) words >> mm;
  return words ? std::optional(size_mm) : std::nullopt;
}

std::optional<std::string> make_first_instructor(db::Database& database) {
  if (!database.people(true).empty()) return std::nullopt;
  const std::string password = lab::one_time_password();
  db::Person person;
  person.name = kInstructor;
  person.role = "instructor";
  person.password_hash = lab::hash_password(password);
  person.must_change = true;
  database.add_person(person, unix_ms());
  return password;
}

}  // namespace

std::expected<DataFolder, std::string> open_data_folder(const fs::path& folder) {
  auto database = open_database(folder);
  if (!database) return std::unexpected(database.error());
  auto certificate = certificate_of(*database);
  if (!certificate) return std::unexpected(certificate.error());
  lab::Inheritance inheritance;
  inheritance.newest_epoch = lab::Epoch{number_of(database->value("epoch"))};
  const auto found = lab::lab_machine_data_of(database->machine_data(db::kLabMachine));
  inheritance.machine.data = found.data;
  inheritance.machine.damaged_data = found.damaged;
  inheritance.machine.tools = database->value("tools").value_or("");
  inheritance.machine.workpiece_mm = workpiece_of(database->value("workpiece"));
  inheritance.database = folder / kDatabase;
  auto first_password = make_first_instructor(*database);
  return DataFolder{std::move(*database), *certificate, inheritance, std::move(first_password)};
}

std::expected<std::string, std::string> renew_instructor_password(const fs::path& folder) {
  if (std::error_code error; !fs::exists(folder / kDatabase, error))  // nothing is made for a slip of the pen
    return std::unexpected("there is no lab in " + folder.string() + ": it has no " + kDatabase +
                           ". Give the data folder of the lab with --data DIR");
  auto database = open_database(folder);
  if (!database) return std::unexpected(database.error());
  auto person = database->person(kInstructor);
  if (!person)
    return std::unexpected("there is no instructor 'lehrer' in " + folder.string() +
                           ": start the server once with an empty data folder");
  const std::string password = lab::one_time_password();
  database->unarchive(person->id);
  database->set_password(person->id, lab::hash_password(password), true);
  return password;
}

std::expected<std::string, std::string> restore_backup(const fs::path& folder, const fs::path& backup) {
  if (const auto locked = lock_folder(folder); !locked) return std::unexpected(locked.error());
  const auto former = db::restore_database(backup, folder / kDatabase);
  if (!former) return std::unexpected(former.error().text);
  if (former->empty()) return "restored " + backup.string();
  return "restored " + backup.string() + "; the former database is kept as " + former->string();
}

}  // namespace cnclab
