#pragma once

#include <cstdint>
#include <string>

namespace dda {

/// An HDF5 file driver for appending to a file that a kill or a full disk must not damage.
///
/// HDF5 itself writes its bookkeeping in any order, so that a process killed meanwhile leaves an unreadable
/// file. Here every change stays in memory until the file is closed and is then written in an order that
/// keeps what was there readable at each moment:
///
///     1. pages beyond the end that the file's first block states     (a failure here cuts them off again)
///     2. the first page, which moves that end                        (what lies behind it is already there)
///     3. the pages that link to the new ones, from the last to the first
///
/// A page is written at once, or not at all when the process is killed. The pages of 2 and 3 stand in a
/// journal beside the file (FILE.journal) meanwhile; the next opening finishes what a kill left undone. The
/// file is locked (flock) against readers while it is open. Returns HDF5's identifier of the driver; the file
/// must exist. Source: HDF5 file format 3.0, II.A superblock version 0; HDF5 1.10 H5FDdevelop.
std::int64_t overlay_driver();

/// Why the last closing through the driver could not write, "" when it could; asking clears it.
///
/// HDF5 cannot be told by the driver itself: where closing a driver fails, the library keeps an identifier of
/// freed memory and crashes at the end of the program.
std::string take_closing_failure();

/// The reason given when another program holds the lock.
inline constexpr const char* locked_reason = "another program holds the file's lock";

}  // namespace dda
