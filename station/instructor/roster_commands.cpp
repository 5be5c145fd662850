// Who is on the roster; copies of everything.
#include "instructor/command_table.hpp"

namespace cnclab::instructor {
namespace {

void add_student_add(CommandTable& student) {
  const auto name = value<std::string>();
  const auto file = value<std::string>();
  const auto must_change = value(false);
  const auto role = value<std::string>("student");
  const auto language = value<std::string>();
  auto& add = student.add("add", "adds somebody; without a file prints a one-time password", [=](Command& c) {
    auto* request = c.request.mutable_student_add();
    request->set_name(*name);
    if (!file->empty()) request->set_password(password_of(*file));
    request->set_must_change(*must_change);
    request->set_role(*role);
    request->set_language(*language);
  });
  needed(add, "name", name, "login name", "NAME");
  add.add_option("--password-file", *file, "password in the first line")->type_name("FILE")->check(CLI::ExistingFile);
  add.add_flag("--must-change", *must_change, "to be changed at the first login");
  add.add_option("--role", *role, "role")
      ->type_name("student|observer|instructor")
      ->check(CLI::IsMember({"student", "observer", "instructor"}));
  add.add_option("--language", *language, "language")->type_name("de|en")->check(CLI::IsMember({"de", "en"}));
}

void add_student_set(CommandTable& student) {
  const auto name = value<std::string>();
  const auto model = value<std::string>();
  const auto language = value<std::string>();
  auto& set =
      student.add("set", "sets model and language from the next log-in on; lab: as the lab has them", [=](Command& c) {
        if (model->empty() && language->empty())
          throw CLI::ValidationError("student set", "--model or --language is needed, or both");
        auto* request = c.request.mutable_student_set();
        request->set_name(*name);
        request->set_model(*model);
        request->set_language(*language);
      });
  needed(set, "name", name, "login name", "NAME");
  set.add_option("--model", *model, "model of the control")
      ->type_name("3300|3250|lab")
      ->check(CLI::IsMember({"3300", "3250", "lab"}));
  set.add_option("--language", *language, "language")
      ->type_name("de|en|lab")
      ->check(CLI::IsMember({"de", "en", "lab"}));
}

void add_roster(CommandTable& table) {
  table.add("passwd", "changes the own password; the new one from --new-password-file",
            [](Command& c) { c.changes_own_password = true; });
  table.add("students", "everybody on the roster", [](Command& c) { c.request.mutable_students(); });
  CommandTable student = table.group("student", "changes the roster");
  add_student_add(student);
  add_student_set(student);
  const auto removed = value<std::string>();
  const auto erase = value(false);
  auto& remove = student.add("remove", "archives somebody for 30 days", [=](Command& c) {
    c.request.mutable_student_remove()->set_name(*removed);
    c.request.mutable_student_remove()->set_erase(*erase);
  });
  needed(remove, "name", removed, "login name", "NAME");
  remove.add_flag("--erase", *erase, "deletes for good, programs too");
  const auto restored = value<std::string>();
  auto& restore = student.add("restore", "brings an archived one back",
                              [=](Command& c) { c.request.mutable_student_restore()->set_name(*restored); });
  needed(restore, "name", restored, "login name", "NAME");
  const auto from = value<std::string>();
  const auto to = value<std::string>();
  auto& rename = student.add("rename", "gives another name", [=](Command& c) {
    c.request.mutable_student_rename()->set_name(*from);
    c.request.mutable_student_rename()->set_new_name(*to);
  });
  needed(rename, "name", from, "login name", "NAME");
  needed(rename, "new_name", to, "new login name", "NAME");
  const auto forgetful = value<std::string>();
  auto& password = student.add("password", "prints a new one-time password",
                               [=](Command& c) { c.request.mutable_student_password()->set_name(*forgetful); });
  needed(password, "name", forgetful, "login name", "NAME");
}

void add_roster_files(CommandTable& table) {
  const auto roster = value<std::string>();
  auto& import = table.add("import", "adds everybody of a list, or nobody",
                           [=](Command& c) { c.request.mutable_import()->set_csv(content_of(*roster)); });
  needed(import, "file", roster, "CSV with name,password,language", "FILE")->check(CLI::ExistingFile);
  const auto target = value<std::string>();
  auto& exported = table.add("export", "writes the roster", [=](Command& c) {
    c.request.mutable_export_();
    c.content_file = *target;
  });
  needed(exported, "file", target, "CSV to write", "FILE");
  const auto copy = value<std::string>();
  auto& backup = table.add("backup", "a consistent copy of the database", [=](Command& c) {
    c.request.mutable_backup();
    c.content_file = *copy;
  });
  needed(backup, "file", copy, "file to write", "FILE");
}

}  // namespace

void add_roster_commands(CommandTable& table) {
  add_roster(table);
  add_roster_files(table);
}

}  // namespace cnclab::instructor
