#include "framework/files/hdf5_overlay.hpp"

#include <fcntl.h>
#include <hdf5.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "framework/base/errors.hpp"
#include "framework/files/run_folder.hpp"

namespace dda {
namespace {

constexpr haddr_t page_size = 4096;
constexpr haddr_t largest_address = (haddr_t{1} << 62) - 1;
using Page = std::array<char, page_size>;

/// HDF5 reaches the file through its first base, which must stay first.
struct Overlay : H5FD_t {
  int descriptor = -1;
  haddr_t allocated = 0;    ///< end of what HDF5 has allocated
  haddr_t end = 0;          ///< end of what has been written
  haddr_t stated_end = 0;   ///< end as the file states it on opening
  haddr_t size_before = 0;  ///< size of the file on opening
  std::string journal;
  std::map<haddr_t, Page> pages;

  Overlay() : H5FD_t{} {}
  ~Overlay() {
    if (descriptor >= 0) ::close(descriptor);
  }
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;
};

Overlay& overlay_of(H5FD_t* file) { return *static_cast<Overlay*>(file); }
const Overlay& overlay_of(const H5FD_t* file) { return *static_cast<const Overlay*>(file); }

thread_local std::string closing_failure;
thread_local std::string last_reason;

herr_t fail(const char* reason) {
  last_reason = reason;
  H5Epush2(H5E_DEFAULT, __FILE__, __func__, __LINE__, H5E_ERR_CLS, H5E_VFL, H5E_WRITEERROR, "%s", reason);
  return -1;
}

/// Reads what is there and leaves zeros behind the end.
bool read_from_disk(int descriptor, char* to, std::pair<haddr_t, std::size_t> where) {
  auto [address, size] = where;
  std::memset(to, 0, size);
  while (size > 0) {
    const ssize_t got = ::pread(descriptor, to, size, static_cast<off_t>(address));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return false;
    if (got == 0) return true;
    to += got;
    address += static_cast<haddr_t>(got);
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool write_to_disk(int descriptor, const char* from, std::pair<haddr_t, std::size_t> where) {
  auto [address, size] = where;
  while (size > 0) {
    const ssize_t done = ::pwrite(descriptor, from, size, static_cast<off_t>(address));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    from += done;
    address += static_cast<haddr_t>(done);
    size -= static_cast<std::size_t>(done);
  }
  return true;
}

/// The end of the file as its superblock (version 0) states it; the size of the file for other versions.
haddr_t stated_end(int descriptor, haddr_t size) {
  constexpr std::size_t version_at = 8, end_at = 40;
  std::array<char, 48> head{};
  if (!read_from_disk(descriptor, head.data(), {0, head.size()}) || head[version_at] != 0) return size;
  haddr_t end = 0;
  std::memcpy(&end, head.data() + end_at, sizeof end);
  return std::min(end, size);
}

bool write_page(const Overlay& file, const std::pair<const haddr_t, Page>& page) {
  const haddr_t address = page.first * page_size;
  if (address >= file.allocated) return true;
  const std::size_t size = std::min(page_size, file.allocated - address);
  return write_to_disk(file.descriptor, page.second.data(), {address, size});
}

bool write_new_pages(const Overlay& file) {
  for (auto page = file.pages.rbegin(); page != file.pages.rend(); ++page) {
    if (page->first * page_size >= file.stated_end && !write_page(file, *page)) return false;
  }
  return true;
}

/// Pages that were there before, in the order of writing: the first, then from the last to the second.
std::vector<haddr_t> old_pages(const Overlay& file) {
  std::vector<haddr_t> numbers;
  for (const auto& [number, page] : file.pages) {
    if (number * page_size < file.stated_end) numbers.push_back(number);
  }
  if (!numbers.empty()) std::reverse(numbers.begin() + (numbers.front() == 0 ? 1 : 0), numbers.end());
  return numbers;
}

bool write_old_pages(const Overlay& file, const std::vector<haddr_t>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [&](haddr_t number) { return write_page(file, *file.pages.find(number)); });
}

/// The journal: for every page its address, then its bytes. It appears whole, through a renaming.
std::string journal_of(const Overlay& file, const std::vector<haddr_t>& numbers) {
  std::string text;
  for (const haddr_t number : numbers) {
    const haddr_t address = number * page_size;
    text.append(reinterpret_cast<const char*>(&address), sizeof address);
    text.append(file.pages.at(number).data(), page_size);
  }
  return text;
}

/// Finishes what a killed process had begun.
bool replay(int descriptor, const std::string& journal) {
  if (!std::filesystem::exists(journal)) return true;
  const std::string text = read_whole(journal);
  constexpr std::size_t entry = sizeof(haddr_t) + page_size;
  for (std::size_t begin = 0; begin + entry <= text.size(); begin += entry) {
    haddr_t address = 0;
    std::memcpy(&address, text.data() + begin, sizeof address);
    if (!write_to_disk(descriptor, text.data() + begin + sizeof address, {address, page_size})) return false;
  }
  return ::unlink(journal.c_str()) == 0;
}

bool keep_journal(const Overlay& file, const std::vector<haddr_t>& numbers) {
  try {
    write_whole(file.journal, journal_of(file, numbers), Flush::to_system);
    return true;
  } catch (const OutputError&) {
    return false;
  }
}

/// Gives back what was added; the old pages are still untouched.
herr_t give_up(const Overlay& file, int reason) {
  [[maybe_unused]] const int cut = ::ftruncate(file.descriptor, static_cast<off_t>(file.size_before));
  return fail(std::strerror(reason));
}

herr_t commit(const Overlay& file) {
  if (file.pages.empty()) return 0;
  // Room for the page at the end too, which counts as old but grows.
  const haddr_t more = file.allocated > file.size_before ? file.allocated - file.size_before : 0;
  const int reserved = more > 0 ? ::posix_fallocate(file.descriptor, static_cast<off_t>(file.size_before),
                                                    static_cast<off_t>(more))
                                : 0;
  const bool full = reserved == ENOSPC || reserved == EFBIG || reserved == EDQUOT || reserved == EIO;
  if (full) return give_up(file, reserved);
  if (!write_new_pages(file)) return give_up(file, errno);
  const std::vector<haddr_t> numbers = old_pages(file);
  if (!keep_journal(file, numbers)) return give_up(file, errno);
  if (!write_old_pages(file, numbers)) return fail(std::strerror(errno));
  return ::unlink(file.journal.c_str()) == 0 ? 0 : fail(std::strerror(errno));
}

/// Opens and locks the file; 0 or the reason why not.
int open_locked(Overlay& file, const char* name) {
  file.descriptor = ::open(name, O_RDWR | O_CLOEXEC);
  if (file.descriptor < 0) return errno;
  if (::flock(file.descriptor, LOCK_EX | LOCK_NB) != 0 && errno != ENOSYS) return errno;
  file.journal = std::string(name) + ".journal";
  struct stat state {};
  if (!replay(file.descriptor, file.journal) || ::fstat(file.descriptor, &state) != 0) return errno;
  file.end = file.size_before = static_cast<haddr_t>(state.st_size);
  file.stated_end = stated_end(file.descriptor, file.size_before);
  return 0;
}

H5FD_t* open_file(const char* name, unsigned, hid_t, haddr_t) {
  auto file = std::make_unique<Overlay>();
  const int reason = open_locked(*file, name);
  if (reason == 0) return file.release();
  fail(reason == EWOULDBLOCK ? locked_reason : std::strerror(reason));
  return nullptr;
}

herr_t close_file(H5FD_t* file) {
  const std::unique_ptr<Overlay> overlay(&overlay_of(file));
  if (commit(*overlay) < 0) closing_failure = last_reason;
  return 0;
}

herr_t read_file(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* buffer) {
  const Overlay& overlay = overlay_of(file);
  char* to = static_cast<char*>(buffer);
  if (!read_from_disk(overlay.descriptor, to, {address, size})) return fail(std::strerror(errno));
  auto page = overlay.pages.lower_bound(address / page_size);
  for (; page != overlay.pages.end() && page->first * page_size < address + size; ++page) {
    const haddr_t begin = std::max(address, page->first * page_size);
    const haddr_t end = std::min(address + size, (page->first + 1) * page_size);
    std::memcpy(to + (begin - address), page->second.data() + begin % page_size, end - begin);
  }
  return 0;
}

herr_t write_file(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, const void* buffer) {
  Overlay& overlay = overlay_of(file);
  const char* from = static_cast<const char*>(buffer);
  const haddr_t stop = address + size;
  for (haddr_t begin = address; begin < stop;) {
    const haddr_t number = begin / page_size;
    const haddr_t end = std::min(stop, (number + 1) * page_size);
    const auto [page, is_new] = overlay.pages.try_emplace(number);
    if (is_new && !read_from_disk(overlay.descriptor, page->second.data(), {number * page_size, page_size})) {
      return fail(std::strerror(errno));
    }
    std::memcpy(page->second.data() + begin % page_size, from + (begin - address), end - begin);
    begin = end;
  }
  overlay.end = std::max(overlay.end, stop);
  return 0;
}

herr_t truncate_file(H5FD_t* file, hid_t, hbool_t) {
  overlay_of(file).end = overlay_of(file).allocated;
  return 0;
}

haddr_t allocated_end(const H5FD_t* file, H5FD_mem_t) { return overlay_of(file).allocated; }

herr_t set_allocated_end(H5FD_t* file, H5FD_mem_t, haddr_t address) {
  overlay_of(file).allocated = address;
  return 0;
}

haddr_t written_end(const H5FD_t* file, H5FD_mem_t) { return overlay_of(file).end; }

herr_t features(const H5FD_t*, unsigned long* flags) {
  if (flags == nullptr) return 0;
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

H5FD_class_t make_class() {
  H5FD_class_t driver{};
  driver.name = "ddapath_overlay";
  driver.maxaddr = largest_address;
  driver.fc_degree = H5F_CLOSE_STRONG;
  driver.open = open_file;
  driver.close = close_file;
  driver.query = features;
  driver.get_eoa = allocated_end;
  driver.set_eoa = set_allocated_end;
  driver.get_eof = written_end;
  driver.read = read_file;
  driver.write = write_file;
  driver.truncate = truncate_file;
  const H5FD_mem_t kinds[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(kinds), std::end(kinds), driver.fl_map);
  return driver;
}

}  // namespace

std::string take_closing_failure() { return std::exchange(closing_failure, {}); }

std::int64_t overlay_driver() {
  static const H5FD_class_t driver = make_class();
  static const hid_t id = H5FDregister(&driver);
  return id;
}

}  // namespace dda
