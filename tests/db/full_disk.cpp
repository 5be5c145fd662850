// The default VFS with its write replaced.
#include "full_disk.hpp"

#include <sqlite3.h>

#include <array>
#include <atomic>
#include <mutex>

namespace cnclab::db {
namespace {

std::atomic<bool> is_full = false;
sqlite3_vfs* original = nullptr;
sqlite3_vfs with_switch;

/// The database and its -wal have different tables of functions; each has its twin.
struct Twin {
  const sqlite3_io_methods* original = nullptr;
  sqlite3_io_methods switched{};
};
std::array<Twin, 4> twins;
std::mutex twins_mutex;

template <std::size_t index>
int write(sqlite3_file* file, const void* data, int size, sqlite3_int64 offset) {
  if (is_full) return SQLITE_FULL;
  return twins[index].original->xWrite(file, data, size, offset);
}

const sqlite3_io_methods* switched(const sqlite3_io_methods* methods) {
  constexpr std::array kWrites{write<0>, write<1>, write<2>, write<3>};
  const std::lock_guard lock(twins_mutex);
  for (std::size_t i = 0; i < twins.size(); ++i) {
    if (twins[i].original == nullptr) {
      twins[i] = {methods, *methods};
      twins[i].switched.xWrite = kWrites[i];
    }
    if (twins[i].original == methods) return &twins[i].switched;
  }
  return methods;
}

int open(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* out_flags) {
  const int result = original->xOpen(original, name, file, flags, out_flags);
  if (result == SQLITE_OK) file->pMethods = switched(file->pMethods);
  return result;
}

}  // namespace

void FullDisk::prepare() {
  if (original != nullptr) return;
  original = sqlite3_vfs_find(nullptr);
  with_switch = *original;
  with_switch.zName = "with-full-switch";
  with_switch.xOpen = open;
  sqlite3_vfs_register(&with_switch, 1);
}

FullDisk::FullDisk() { is_full = true; }
FullDisk::~FullDisk() { is_full = false; }

}  // namespace cnclab::db
