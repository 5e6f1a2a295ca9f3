#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace meniscus::geom {

/// A vector of small values that needs no heap while it holds at most `N`, and has no upper limit.
template <class T, std::size_t N>
requires std::is_trivially_copyable_v<T>
class InlineVector {
public:
    InlineVector() = default;
    InlineVector(const InlineVector& other) : size_(other.size_), spilled_(other.spilled_) {
        if (spilled_.empty()) std::copy_n(other.inline_.data(), size_, inline_.data());
    }
    InlineVector(InlineVector&& other) noexcept
        : size_(other.size_), spilled_(std::move(other.spilled_)) {
        if (spilled_.empty()) std::copy_n(other.inline_.data(), size_, inline_.data());
        other.spilled_.clear();
        other.size_ = 0;
    }
    InlineVector& operator=(InlineVector other) noexcept {
        size_ = other.size_;
        spilled_ = std::move(other.spilled_);
        if (spilled_.empty()) std::copy_n(other.inline_.data(), size_, inline_.data());
        return *this;
    }
    ~InlineVector() = default;

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }

    T* data() { return spilled_.empty() ? inline_.data() : spilled_.data(); }
    const T* data() const { return spilled_.empty() ? inline_.data() : spilled_.data(); }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }
    T& operator[](std::size_t i) { return data()[i]; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    T& back() { return data()[size_ - 1]; }
    const T& back() const { return data()[size_ - 1]; }

    void push_back(const T& value) {
        if (spilled_.empty() && size_ < N) {
            inline_[size_] = value;
        } else {
            if (spilled_.empty()) spilled_.assign(inline_.begin(), inline_.begin() + size_);
            spilled_.push_back(value);
        }
        ++size_;
    }
    void pop_back() { resize(size_ - 1); }
    void erase(std::size_t i) {
        std::move(begin() + i + 1, end(), begin() + i);
        pop_back();
    }
    void clear() { resize(0); }
    /// Drops all but the first `count` elements.
    void resize(std::size_t count) {
        if (!spilled_.empty()) {
            if (count <= N) {
                std::copy_n(spilled_.begin(), count, inline_.begin());
                spilled_.clear();
            } else {
                spilled_.resize(count);
            }
        }
        size_ = count;
    }

private:
    std::size_t size_ = 0;
    std::array<T, N> inline_;
    std::vector<T> spilled_;
};

}  // namespace meniscus::geom
