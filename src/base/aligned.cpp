// SPDX-License-Identifier: MIT
#include "base/aligned.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstring>

namespace talus {
namespace {

constexpr std::size_t line = 64;
/// Arrays of at least this size [bytes] are mapped pages, which the kernel allocates at the first write. Freed heap
/// memory would need clearing, and would be resident.
constexpr std::size_t large = std::size_t{1} << 20;
/// Size of a huge page where pages have 4 kB [bytes].
constexpr std::size_t huge_page = std::size_t{1} << 21;

bool uses_huge_pages = true;

/// Length of the mapping of an array [bytes]. Linux aligns mappings of whole huge pages to these.
std::size_t find_mapped_size(std::size_t bytes) {
  return bytes < huge_page ? bytes : (bytes + huge_page - 1) / huge_page * huge_page;
}

/// Presence of the pages of this process, from /proc/self/pagemap of Linux: one word per page, with one bit for pages
/// in memory and one for swapped pages. If the file is not readable, all pages count as present.
class Pages {
 public:
  Pages() : file_(open("/proc/self/pagemap", O_RDONLY | O_CLOEXEC)) {}
  ~Pages() {
    if (file_ >= 0) close(file_);
  }
  Pages(const Pages&) = delete;
  Pages& operator=(const Pages&) = delete;

  bool is_there(std::size_t page) {
    if (file_ < 0) return true;
    if (page < first_ || page >= first_ + words_.size()) {
      first_ = page;
      words_.fill(anywhere);  // pages beyond those that were read count as present
      if (pread(file_, words_.data(), sizeof words_, static_cast<off_t>(first_ * sizeof(std::uint64_t))) <= 0)
        return true;
    }
    return (words_[page - first_] & anywhere) != 0;
  }

 private:
  static constexpr std::uint64_t anywhere = std::uint64_t{3} << 62;
  int file_;
  std::size_t first_ = 0;
  std::array<std::uint64_t, 1024> words_{};
};

bool is_zero(const std::byte* bytes, std::size_t count) {
  return bytes[0] == std::byte{0} && std::memcmp(bytes, bytes + 1, count - 1) == 0;
}

}  // namespace

void* allocate_zeros(std::size_t bytes) {
  if (bytes < large) return std::memset(::operator new (bytes, std::align_val_t{line}), 0, bytes);
  const std::size_t mapped = find_mapped_size(bytes);
  void* start = mmap(nullptr, mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (start == MAP_FAILED) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  // Otherwise misses of the TLB take a tenth of a step of a million points.
  if (uses_huge_pages && mapped >= huge_page) madvise(start, mapped, MADV_HUGEPAGE);
#endif
  return start;
}

void free_zeros(void* start, std::size_t bytes) {
  if (bytes < large)
    ::operator delete (start, std::align_val_t{line});
  else
    munmap(start, find_mapped_size(bytes));
}

void avoid_huge_pages() {
  uses_huge_pages = false;
}

void copy_to_zeros(void* to, const void* from, std::size_t bytes) {
  if (bytes < large) {
    std::memcpy(to, from, bytes);
    return;
  }
  const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const auto* source = static_cast<const std::byte*>(from);
  const auto start = reinterpret_cast<std::uintptr_t>(from);
  Pages pages;
  for (std::size_t at = 0; at < bytes;) {
    const std::size_t count = std::min(bytes - at, size - (start + at) % size);  // up to the end of the page
    if (pages.is_there((start + at) / size) && !is_zero(source + at, count))
      std::memcpy(static_cast<std::byte*>(to) + at, source + at, count);
    at += count;
  }
}

}  // namespace talus
