// The sentences that a screen shows when something could not be stored.
#include "db/failure.hpp"

namespace cnclab::db {

std::string_view explain(FailureKind kind, std::string_view language) {
  const bool english = language == "en";
  switch (kind) {
    case FailureKind::locked:
      return english ? "The database is busy. Try again, else call the instructor."
                     : "Datenbank belegt. Nochmals versuchen oder Lehrkraft rufen.";
    case FailureKind::full:
      return english ? "The server's disk is full. Call the instructor, make room."
                     : "Platte des Servers voll. Lehrkraft rufen, Platz schaffen.";
    case FailureKind::damaged:
      return english ? "The database is damaged. Call the instructor: restore a backup."
                     : "Datenbank beschädigt. Lehrkraft rufen: Sicherung laden.";
    case FailureKind::disk:
      return english ? "The server's disk cannot be written. Call the instructor."
                     : "Platte des Servers nicht beschreibbar. Lehrkraft rufen.";
    case FailureKind::refused:
      return english ? "Value not allowed. Call the instructor (see the server's log)."
                     : "Wert nicht zulässig. Lehrkraft rufen (Protokoll des Servers).";
  }
  return {};
}

}  // namespace cnclab::db
