// The roster as a CSV file: name,password,language (INS-004, interfaces.md section 4).
//
//   file   = [ heading ] { line }           lines end with LF or CR LF; empty lines are passed over
//   line   = name [ "," [ password ] [ "," [ language ] ] ]
//   field  = plain text | '"' text with every quotation mark doubled '"'       (RFC 4180)
//
// The heading is the line name,password,language in large or small letters; like any line it may leave out columns at
// its end. Nobody can be called so there: `name` with the password `password` would be an account that anyone guesses.
// Spaces around a plain field are not part of it.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "language/units.hpp"

namespace cnclab::lab {

struct RosterEntry {
  std::string name;
  std::string password;  ///< empty: a one-time password is made
  std::string language;  ///< "", "de", "en"
  int line = 0;          ///< of the file, from 1
};

/// What a roster file says, or every error with its line.
struct Roster {
  std::vector<RosterEntry> entries;
  std::map<int, std::string> errors;  ///< by line: "line 3: …" in the reader's language
};

/// Names twice in the file are errors; whether a name is on the roster already is for whoever knows the roster.
[[nodiscard]] Roster read_roster(std::string_view csv, language::Tongue tongue);

/// With heading; passwords are not known to anybody and stay empty.
[[nodiscard]] std::string write_roster(const std::vector<RosterEntry>& entries);

/// Names are typed at stations and stand on screens: letters, digits and . - _ only, 1 to 32 bytes.
[[nodiscard]] bool is_name(std::string_view name);

/// "line 3: " or "Zeile 3: ".
[[nodiscard]] std::string line_prefix(int line, language::Tongue tongue);

}  // namespace cnclab::lab
