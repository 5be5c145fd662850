// The sentences that a screen shows when something could not be stored.
#include "db/failure.hpp"

namespace cnclab::db {

std::string_view explain(FailureKind kind, std::string_view language) {
  const bool english = language == "en";
  switch (kind) {
    case FailureKind::locked:
      return english ? "Not stored: the database is busy. Try again, else call the instructor."
                     : "Nicht gespeichert: Datenbank belegt. Nochmals versuchen oder Ausbilder rufen.";
    case FailureKind::full:
      return english ? "Not stored: the server's disk is full. Call the instructor, make room."
                     : "Nicht gespeichert: Platte des Servers voll. Ausbilder rufen, Platz schaffen.";
    case FailureKind::damaged:
      return english ? "Not stored: the database is damaged. Call the instructor: restore a backup."
                     : "Nicht gespeichert: Datenbank beschädigt. Ausbilder rufen: Sicherung laden.";
    case FailureKind::disk:
      return english ? "Not stored: the server's disk cannot be written. Call the instructor."
                     : "Nicht gespeichert: Platte des Servers nicht beschreibbar. Ausbilder rufen.";
    case FailureKind::refused:
      return english ? "Not stored: value not allowed. Call the instructor (see the server's log)."
                     : "Nicht gespeichert: Wert nicht zulässig. Ausbilder rufen (Protokoll des Servers).";
  }
  return {};
}

}  // namespace cnclab::db
