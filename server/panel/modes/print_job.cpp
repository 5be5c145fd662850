// Lists to pages to files.
#include "panel/modes/print_job.hpp"

#include <atomic>
#include <utility>

#include "drawing/pdf.hpp"
#include "drawing/text_pages.hpp"
#include "language/listing.hpp"

namespace cnclab::panel {

namespace {

PutFiles printed(const PrintOrder& order) {
  std::string list;
  for (const language::Program& program : order.programs) {
    if (!list.empty()) list += '\n';
    list += language::write_listing(program, order.time_stamp, order.header.tongue);
  }
  if (!order.machine_data.empty()) list += "\n" + order.machine_data;
  const std::vector<transfer::PrintPage> pages = transfer::set_pages(list, order.header);
  std::vector<drawing::Picture> pictures;
  pictures.reserve(pages.size());
  for (const transfer::PrintPage& page : pages) pictures.push_back(drawing::text_page(page, order.header.what));
  PutFiles files{.files = {{order.file + ".txt", transfer::print_text(pages)}}, .is_printed = true};
  if (auto pdf = drawing::pdf_of(pictures)) files.files.push_back({order.file + ".pdf", std::move(*pdf)});
  return files;
}

}  // namespace

struct PrintJob::Shared {
  PutFiles files;  ///< written before `is_done`
  std::atomic<bool> is_done = false;
};

PrintJob::PrintJob(const LongWork& long_work, PrintOrder order) : shared_(std::make_shared<Shared>()) {
  long_work([shared = shared_, order = std::move(order)] {
    shared->files = printed(order);
    shared->is_done.store(true, std::memory_order_release);
  });
}

std::optional<PutFiles> PrintJob::result() const {
  if (!shared_->is_done.load(std::memory_order_acquire)) return std::nullopt;
  return shared_->files;
}

}  // namespace cnclab::panel
