#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <type_traits>

#include "geom/huge_pages.hpp"

namespace meniscus::geom {

/// Memory that begins as 0, handed out by the system when it is first touched, in pages of 2 MiB
/// where it has them: what is never used costs nothing, and threads share the work.
class ZeroPages {
public:
    explicit ZeroPages(std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
        constexpr std::size_t page = HugePages<std::byte>::page;
        if (bytes >= page) {
            // With room to begin on a whole page.
            mapped_ = bytes + page;
            memory_ =
                mmap(nullptr, mapped_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            if (memory_ == MAP_FAILED) throw std::bad_alloc();
            const auto start = reinterpret_cast<std::uintptr_t>(memory_);
            data_ = static_cast<std::byte*>(memory_) + (page - start % page) % page;
            madvise(data_, bytes / page * page, MADV_HUGEPAGE);
            return;
        }
#endif
        memory_ = std::calloc(bytes > 0 ? bytes : 1, 1);
        if (!memory_) throw std::bad_alloc();
        data_ = static_cast<std::byte*>(memory_);
    }
    ZeroPages(const ZeroPages&) = delete;
    ZeroPages& operator=(const ZeroPages&) = delete;
    ~ZeroPages() {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
        if (mapped_ > 0) {
            munmap(memory_, mapped_);
            return;
        }
#endif
        std::free(memory_);
    }

    /// An array of things whose bytes are all 0 at first, from this offset on.
    template <class T>
    T* array(std::size_t offset) {
        static_assert(std::is_trivially_copyable_v<T>);
        return reinterpret_cast<T*>(data_ + offset);
    }

private:
    void* memory_ = nullptr;
    std::byte* data_ = nullptr;
    std::size_t mapped_ = 0;
};

}  // namespace meniscus::geom
