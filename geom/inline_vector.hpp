#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <type_traits>

namespace meniscus::geom {

/// A vector of small values that needs no heap while it holds at most `N`, and has no upper limit.
/// To copy one that needs none is to copy all its bytes, which costs no loop and no call.
template <class T, std::size_t N>
requires std::is_trivially_copyable_v<T>
class InlineVector {
public:
    InlineVector() = default;
    InlineVector(const InlineVector& other) { assign(other); }
    InlineVector(InlineVector&& other) noexcept { take(other); }
    InlineVector& operator=(const InlineVector& other) {
        if (this != &other) assign(other);
        return *this;
    }
    InlineVector& operator=(InlineVector&& other) noexcept {
        if (this != &other) take(other);
        return *this;
    }
    ~InlineVector() = default;

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }

    T* data() { return spilled_ ? spilled_.get() : inline_; }
    const T* data() const { return spilled_ ? spilled_.get() : inline_; }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }
    T& operator[](std::size_t i) { return data()[i]; }
    const T& operator[](std::size_t i) const { return data()[i]; }
    T& back() { return data()[size_ - 1]; }
    const T& back() const { return data()[size_ - 1]; }

    void push_back(const T& value) {
        if (size_ == capacity_) {
            const T copy = value;  // it may be one of these
            grow(2 * (size_ < N ? N : size_));
            data()[size_++] = copy;
            return;
        }
        data()[size_++] = value;
    }
    void pop_back() { --size_; }
    void erase(std::size_t i) {
        std::move(begin() + i + 1, end(), begin() + i);
        pop_back();
    }
    void clear() { size_ = 0; }
    /// Drops all but the first `count` elements.
    void resize(std::size_t count) { size_ = count; }

private:
    void assign(const InlineVector& other) {
        if (!spilled_ && !other.spilled_) [[likely]] {
            std::memcpy(static_cast<void*>(inline_), other.inline_, sizeof inline_);
            size_ = other.size_;
            return;
        }
        size_ = 0;
        if (other.size_ > capacity_) grow(other.size_);
        std::copy_n(other.data(), other.size_, data());
        size_ = other.size_;
    }
    void take(InlineVector& other) {
        if (!other.spilled_) [[likely]] {
            assign(other);
            return;
        }
        spilled_ = std::move(other.spilled_);
        size_ = other.size_;
        capacity_ = other.capacity_;
        other.size_ = 0;
        other.capacity_ = N;
    }
    void grow(std::size_t capacity) {
        std::unique_ptr<T[]> larger(new T[capacity]);
        std::copy_n(data(), size_, larger.get());
        spilled_ = std::move(larger);
        capacity_ = capacity;
    }

    std::size_t size_ = 0, capacity_ = N;
    std::unique_ptr<T[]> spilled_;
    T inline_[N];
};

}  // namespace meniscus::geom
