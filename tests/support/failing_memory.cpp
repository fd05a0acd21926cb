// Whether an allocation is the watched library's is told by the address it returns to. Any thread's counts.
#undef _FILE_OFFSET_BITS  // or mmap would be another name of mmap64
#include "failing_memory.h"

#include <link.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace terrazzo::test {
namespace {

constinit std::uintptr_t library_begin = 0, library_end = 0;
constinit std::atomic<bool> counting = false;
constinit std::atomic<long> asked = 0, failed = 0;
constinit long first_failing = 0, failing = 0;

bool runs_out(const void* caller) {
    const auto address = reinterpret_cast<std::uintptr_t>(caller);
    if (!counting.load(std::memory_order_acquire) || address < library_begin || address >= library_end)
        return false;
    const long number = asked.fetch_add(1);
    if (number < first_failing || (failing != kAllBehind && number - first_failing >= failing)) return false;
    ++failed;
    errno = ENOMEM;
    return true;
}

int find_library(dl_phdr_info* info, std::size_t, void* path_part) {
    char path[PATH_MAX];
    if (!realpath(info->dlpi_name, path) || !std::strstr(path, static_cast<const char*>(path_part))) return 0;
    library_begin = info->dlpi_addr;
    for (int i = 0; i < info->dlpi_phnum; ++i)
        if (info->dlpi_phdr[i].p_type == PT_LOAD)
            library_end = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr + info->dlpi_phdr[i].p_memsz;
    return 1;
}

}  // namespace

bool watch_library(const char* path_part) {
    return dl_iterate_phdr(find_library, const_cast<char*>(path_part)) != 0;
}

void fail_allocations(long first, long count) {
    asked = failed = 0;
    first_failing = first;
    failing = count;
    counting.store(true, std::memory_order_release);
}

Allocations allocations() {
    return {asked, failed};
}

Allocations stop_failing() {
    counting = false;
    return allocations();
}

}  // namespace terrazzo::test

// The allocator behind: the C library's, or the address sanitizer's.
#ifdef __SANITIZE_ADDRESS__
#define BEHIND(name) __interceptor_##name
#else
#define BEHIND(name) __libc_##name
#endif

#define RUNS_OUT terrazzo::test::runs_out(__builtin_return_address(0))

extern "C" {

void* BEHIND(malloc)(std::size_t size);
void* BEHIND(calloc)(std::size_t count, std::size_t size);
void* BEHIND(realloc)(void* memory, std::size_t size);
void* BEHIND(memalign)(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
    return RUNS_OUT ? nullptr : BEHIND(malloc)(size);
}

void* calloc(std::size_t count, std::size_t size) {
    return RUNS_OUT ? nullptr : BEHIND(calloc)(count, size);
}

void* realloc(void* memory, std::size_t size) {
    return RUNS_OUT ? nullptr : BEHIND(realloc)(memory, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
    return RUNS_OUT ? nullptr : BEHIND(memalign)(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
    if (RUNS_OUT) return ENOMEM;
    *memory = BEHIND(memalign)(alignment, size);
    return *memory ? 0 : ENOMEM;
}

void* mmap(void* address, std::size_t size, int protection, int flags, int file, off_t offset) noexcept {
    if (RUNS_OUT) return MAP_FAILED;
    return reinterpret_cast<void*>(syscall(SYS_mmap, address, size, protection, flags, file, offset));
}

void* mmap64(void* address, std::size_t size, int protection, int flags, int file, off64_t offset) noexcept {
    if (RUNS_OUT) return MAP_FAILED;
    return reinterpret_cast<void*>(syscall(SYS_mmap, address, size, protection, flags, file, offset));
}
}
