// Holds a contour back until its check has ended.
#include "program/checked_path.hpp"

#include <algorithm>
#include <iterator>
#include <span>

namespace cnclab::program {

std::expected<CheckedPath, language::Error> CheckedPath::begin(ProgramSet programs, Settings settings,
                                                               const Start& start) {
  auto source = PathSource::begin(std::move(programs), std::move(settings), start);
  if (!source) return std::unexpected(source.error());
  return CheckedPath(std::move(*source));
}

std::expected<void, language::Error> CheckedPath::step(std::vector<geometry::PathItem>& out) {
  if (fault_) return std::unexpected(*fault_);
  const std::size_t before = out.size();
  const auto executed = source_.step(held_, &check_);
  const auto judged = judge(out);
  silent_blocks_ = out.size() == before ? silent_blocks_ + 1 : 0;
  if (!judged) return judged;
  if (!executed) return std::unexpected(executed.error());
  return {};
}

std::expected<void, language::Error> CheckedPath::flush(std::vector<geometry::PathItem>& out) {
  if (fault_) return std::unexpected(*fault_);
  const auto flushed = source_.flush(held_, &check_);
  if (auto judged = judge(out); !judged) return judged;
  return flushed;
}

/// Lets the held items go as far as they are known to be right. An error of a block or a corner comes behind them: what
/// a contour's own walls forbid lies before it.
std::expected<void, language::Error> CheckedPath::judge(std::vector<geometry::PathItem>& out) {
  if (held_.size() >= kMostHeld) check_.split();
  const bool is_gouged = check_.findings().size() > findings_seen_;
  if (is_gouged) keep_what_is_right();
  findings_seen_ = check_.findings().size();
  if (check_.is_open() && held_.size() < kMostHeld && !is_gouged) return {};
  std::ranges::move(held_, std::back_inserter(out));
  held_.clear();
  if (fault_) return std::unexpected(*fault_);
  return {};
}

/// Drops the first block that is to blame, and all behind it.
void CheckedPath::keep_what_is_right() {
  const std::span findings = std::span(check_.findings()).subspan(findings_seen_);
  const auto blame = [&](const geometry::PathItem& item) {
    return std::ranges::find(findings, item.source, &geometry::StageFault::block);
  };
  const auto first = std::ranges::find_if(held_, [&](const auto& item) { return blame(item) != findings.end(); });
  fault_ = error_of(first == held_.end() ? findings.front() : *blame(*first));
  held_.erase(first, held_.end());
}

}  // namespace cnclab::program
