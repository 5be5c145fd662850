// The ring of chunks behind the segment queue.
#include "motion/segment_queue.hpp"

#include <cassert>

namespace cnclab::motion {

static_assert(std::atomic<double>::is_always_lock_free, "the tick must not lock");

SegmentQueue::SegmentQueue() : chunks_(kChunks) {}
SegmentQueue::~SegmentQueue() = default;

SegmentQueue::Slot& SegmentQueue::slot(std::uint64_t number) const {
  return (*chunks_[(number / kChunk) % kChunks])[number % kChunk];
}

void SegmentQueue::open_chunk(std::uint64_t chunk) {
  trim();
  auto& place = chunks_[chunk % kChunks];
  assert(place == nullptr);
  place = spare_ ? std::move(spare_) : std::make_unique<Chunk>();
}

void SegmentQueue::trim() {
  const std::uint64_t in_use = popped() / kChunk;
  const std::uint64_t opened = (pushed() + kChunk - 1) / kChunk;
  for (; oldest_chunk_ < in_use && oldest_chunk_ < opened; ++oldest_chunk_) {
    auto& left = chunks_[oldest_chunk_ % kChunks];
    if (!spare_) {
      spare_ = std::move(left);
    } else {
      left.reset();
    }
  }
}

std::size_t SegmentQueue::chunks_held() const {
  const std::uint64_t opened = (pushed() + kChunk - 1) / kChunk;
  return static_cast<std::size_t>(opened - oldest_chunk_) + (spare_ ? 1 : 0);
}

void SegmentQueue::push(const Segment& segment) {
  assert(!is_full());
  const std::uint64_t number = pushed();
  if (number % kChunk == 0) open_chunk(number / kChunk);
  Slot& place = slot(number);
  place.segment = segment;
  place.joint_speed = 0;
  place.is_full_stop = false;
  place.exit_speed.store(0, std::memory_order_relaxed);
  head_.store(number + 1, std::memory_order_release);
}

const Segment& SegmentQueue::at(std::uint64_t number) const { return slot(number).segment; }

void SegmentQueue::note_joint_speed(std::uint64_t number, double mm_per_s) { slot(number).joint_speed = mm_per_s; }

double SegmentQueue::noted_joint_speed(std::uint64_t number) const { return slot(number).joint_speed; }

void SegmentQueue::note_full_stop(std::uint64_t number) { slot(number).is_full_stop = true; }

bool SegmentQueue::is_full_stop_noted(std::uint64_t number) const { return slot(number).is_full_stop; }

void SegmentQueue::raise_exit_speed(std::uint64_t number, double mm_per_s) {
  std::atomic<double>& speed = slot(number).exit_speed;
  if (mm_per_s > speed.load(std::memory_order_relaxed)) speed.store(mm_per_s, std::memory_order_release);
}

double SegmentQueue::exit_speed(std::uint64_t number) const {
  return slot(number).exit_speed.load(std::memory_order_acquire);
}

const Segment* SegmentQueue::ahead(std::uint64_t number) const noexcept {
  if (number >= head_.load(std::memory_order_acquire)) return nullptr;
  return &slot(number).segment;
}

}  // namespace cnclab::motion
