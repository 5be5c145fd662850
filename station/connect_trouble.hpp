// Why no connection came about, in the reader's words.
#pragma once

#include <boost/system/error_code.hpp>
#include <string>

#include "station/language.hpp"

namespace cnclab::station {

/// Part of a sentence: "dort antwortet kein Server". What is not known here is said as the system says it.
[[nodiscard]] std::string connect_trouble(const boost::system::error_code& error, Language language);

}  // namespace cnclab::station
