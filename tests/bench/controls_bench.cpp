// What a control costs the server when it runs its program: interpreting, ticks, screens and their differences, in
// virtual time and without network, for more stations than a lab has.
#include <chrono>
#include <memory>
#include <vector>

#include "../panel/bench.hpp"
#include "cnclab/v1/screen.pb.h"
#include "figure.hpp"
#include "shared/screen_wire.hpp"

namespace cnclab {
namespace {

constexpr int kSeconds = 10;

/// One running control and the screen that its station has.
struct Seat {
  panel::Bench bench{{.tape = "P0001N001G11F2000N002G01X+20000Y+10000N003G01X-20000Y-10000N004G20P0001N002%"}};
  Screen shown;
  std::size_t sent_bytes = 0;

  /// 50 ms of machining, then a screen.
  void live() {
    bench.run_for(50);
    const Screen newest = bench.screen();
    v1::ScreenUpdate update;
    write_rows(shown, newest, update);
    sent_bytes += update.ByteSizeLong();
    shown = newest;
  }
};

void measure(int seats) {
  std::vector<std::unique_ptr<Seat>> all;
  for (int i = 0; i < seats; ++i) all.push_back(std::make_unique<Seat>());
  for (auto& seat : all) seat->bench.keys("AUTOMAT ENTER ENTER START");
  const auto start = std::chrono::steady_clock::now();
  constexpr int kScreensPerSecond = 20;
  for (int i = 0; i < kSeconds * kScreensPerSecond; ++i)
    for (auto& seat : all) seat->live();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::size_t bytes = 0;
  for (const auto& seat : all) bytes += seat->sent_bytes;
  bench::print_figure(fmt::format("controls_{}_core_percent", seats), 100 * took.count() / kSeconds, "%");
  bench::print_figure(fmt::format("controls_{}_us_per_second_each", seats), took.count() * 1e6 / kSeconds / seats,
                      "us");
  bench::print_figure(fmt::format("controls_{}_kbit_per_s", seats), static_cast<double>(bytes) * 8 / 1000 / kSeconds,
                      "kbit/s");
}

}  // namespace
}  // namespace cnclab

int main() {
  for (const int seats : {1, 15, 50, 100, 200}) cnclab::measure(seats);
  return 0;
}
