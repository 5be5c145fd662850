// Printed pages made by long work: a full memory takes longer than a key press may.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "language/block.hpp"
#include "panel/media.hpp"
#include "panel/run/long_work.hpp"
#include "transfer/printout.hpp"

namespace cnclab::panel {

struct PrintOrder {
  std::vector<language::Program> programs;  ///< one after another (D-108)
  std::string machine_data{};               ///< the list behind them; empty: none
  std::string time_stamp;                   ///< of printing, "09:00:00 16/06/83"
  transfer::PrintHeader header;
  std::string file;  ///< name without ending
};

class PrintJob {
 public:
  PrintJob(const LongWork& long_work, PrintOrder order);
  /// A text and a PDF file, once they are made.
  [[nodiscard]] std::optional<PutFiles> result() const;

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

}  // namespace cnclab::panel
