// One connection and how far it has come: greeted, logged in, at a desk, at the console, looking on.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>

#include "cnclab/v1/session.pb.h"
#include "db/types.hpp"
#include "lab/desk.hpp"
#include "lab/peer.hpp"
#include "lab/screen_feed.hpp"

namespace cnclab::lab {

enum class Stage : std::uint8_t {
  greeting,      ///< Hello is to come
  login,         ///< Login or Resume is to come
  checking,      ///< a password is being hashed, data are being read: nothing else is accepted
  new_password,  ///< ChangePassword is to come
  at_desk,       ///< a station with its control
  at_console,    ///< an instructor
  looking_on,    ///< sees a station's screen, can do nothing (SEAT-006)
  gone,
};

struct Visit {
  explicit Visit(std::shared_ptr<Peer> far_end, std::int64_t now_ns)
      : peer(std::move(far_end)), opened_ns(now_ns), heard_ns(now_ns) {}

  std::shared_ptr<Peer> peer;
  Stage stage = Stage::greeting;
  v1::ClientKind kind = v1::CLIENT_KIND_UNSPECIFIED;
  RowForm row_form = RowForm::whole;  ///< how its screens travel
  std::int64_t opened_ns = 0, heard_ns = 0, last_beat_ns = 0;
  db::Person person;                  ///< from a correct password on
  v1::Login login;                    ///< what was asked for; the password is wiped once it is compared
  std::shared_ptr<Desk> desk;         ///< at_desk
  bool has_media = false;             ///< a station with a folder for files
  int watched_station = 0;            ///< looking_on, at_console: whose screen is shown here, 0 nobody's
  std::weak_ptr<Desk> own_control;    ///< looking_on at the own login elsewhere (SEAT-003): that control and no other
  std::weak_ptr<Desk> keyboard;       ///< at_console: whose keyboard it has taken over
  bool is_changing_password = false;  ///< at_desk: the old one is being compared, the new one hashed
  std::uint64_t received = 0;         ///< at_console: number of the last key that came
  ScreenFeed feed;

  /// A file on its way to a console, chunk by chunk (bulk.proto).
  struct Transfer {
    std::uint32_t number = 0;
    std::shared_ptr<std::istream> content;
    std::uint64_t size = 0;
    std::uint64_t sent = 0;
  };
  std::optional<Transfer> transfer;
  std::uint32_t transfers = 0;
  std::string tape;  ///< at_console: of `program send`, what has come of it so far

  [[nodiscard]] bool is_logged_in() const {
    return stage == Stage::at_desk || stage == Stage::at_console || stage == Stage::looking_on;
  }
};

}  // namespace cnclab::lab
