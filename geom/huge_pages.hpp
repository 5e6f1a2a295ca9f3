#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace meniscus::geom {

/// Memory in pages of 2 MiB where the system has them: rays that run through a large hierarchy miss
/// the translation buffer less often.
template <class T>
struct HugePages {
    using value_type = T;
    static constexpr std::size_t page = std::size_t{1} << 21;
    static constexpr std::size_t cache_line = 64;

    HugePages() = default;
    template <class Other>
    HugePages(const HugePages<Other>&) {}

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        const std::size_t alignment = bytes >= page ? page : cache_line;
        const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
        void* memory = std::aligned_alloc(alignment, rounded);
        if (memory == nullptr) throw std::bad_alloc();
#if defined(__linux__) && defined(MADV_HUGEPAGE)
        // Only whole pages: what is touched of the last one would be resident as a whole.
        if (bytes >= page) madvise(memory, bytes / page * page, MADV_HUGEPAGE);
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t) { std::free(memory); }

    template <class Other>
    bool operator==(const HugePages<Other>&) const {
        return true;
    }
};

template <class T>
using HugeVector = std::vector<T, HugePages<T>>;

}  // namespace meniscus::geom
