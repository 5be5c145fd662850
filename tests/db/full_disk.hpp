// A disk that can be made full: SQLite's own file layer with one switch in its write.
#pragma once

namespace cnclab::db {

/// While one lives, every write that SQLite wants to do in this process finds the disk full.
class FullDisk {
 public:
  /// Must have been called before a database is opened that shall be affected.
  static void prepare();
  FullDisk();
  ~FullDisk();
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
};

}  // namespace cnclab::db
