#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "geom/crossing.hpp"
#include "geom/vec.hpp"
#include "lanes/program.hpp"

namespace meniscus::lanes {

/// What a ray is, apart from where it is.
struct RayCode {
    static constexpr std::uint64_t pixel_bits = 24, level_shift = 24;
    static constexpr std::uint64_t pixel_mask = (1ull << pixel_bits) - 1;
    static constexpr std::uint64_t level_mask = 0xffffull << level_shift;
    static constexpr std::uint64_t one_level = 1ull << level_shift;
    static constexpr std::uint64_t shadow = 1ull << 40;     // goes to a light
    static constexpr std::uint64_t straight = 1ull << 41;   // takes no level of its own
    static constexpr std::uint64_t reflected = 1ull << 42;  // comes from a mirror
    // The bits above are the upper ones of a double: M where the ray was born, rounded up.
    static constexpr std::uint64_t one_birth = 1ull << 43, birth_mask = ~(one_birth - 1);
    static std::uint64_t of_birth(double magnitude) {
        return (std::bit_cast<std::uint64_t>(magnitude) + one_birth) & birth_mask;
    }
    static double birth(std::uint64_t code) { return std::bit_cast<double>(code & birth_mask); }
};

/// A ray that waits.
struct WaitingRay {
    geom::Vec3 origin, direction, throughput;
    double weight = 1.0;            // POV-Ray's: specular factors only
    double t_max = geom::infinity;  // finite for shadow rays only
    double birth_magnitude = 0.0;   // M where it was born: how far its origin may be off; not yet
                                    // in `code`
    double way_before = 0.0;        // covered in this medium since the last surface
    std::uint64_t code = 0, key = 0;
    Places inside{};                    // the list
    std::uint64_t contacts = 0;         // four bits a solid: face + 1, or 0
    std::uint64_t sphere_contacts = 0;  // two ranks + 1 of grouped spheres, 32 bits each
    /// Two triangles + 1, of the last mesh in contact in the lower 32 bits, of the one before it
    /// in the upper.
    std::uint64_t mesh_contacts = 0;
};

/// Rays that wait, an array a field, so that lanes load and store them side by side.
class RayStack {
public:
    static constexpr std::size_t slack = 32;  // whole vectors are stored beyond the top
    enum Field {
        ox,
        oy,
        oz,
        dx,
        dy,
        dz,
        red,
        green,
        blue,
        weight,
        t_max,
        way,
        doubles,
        code = 0,
        key,
        inside,  // and the list's further words
        contacts = inside + list_words,
        sphere_contacts,
        mesh_contacts,
        words
    };

    RayStack() { reserve(512); }

    std::size_t size() const { return size_; }
    std::size_t capacity() const { return capacity_; }
    void resize(std::size_t size) { size_ = size; }
    double* operator[](Field field) { return doubles_.get() + field * stride(); }
    std::uint64_t* word(Field field) { return words_.get() + field * stride(); }

    void reserve(std::size_t capacity) {
        if (capacity <= capacity_) return;
        capacity = std::max(capacity, 2 * capacity_);
        auto more_doubles = std::make_unique<double[]>(std::size_t(doubles) * (capacity + slack));
        auto more_words =
            std::make_unique<std::uint64_t[]>(std::size_t(words) * (capacity + slack));
        for (std::size_t f = 0; f < doubles && size_ > 0; ++f)
            std::copy_n(&doubles_[f * stride()], size_, &more_doubles[f * (capacity + slack)]);
        for (std::size_t f = 0; f < words && size_ > 0; ++f)
            std::copy_n(&words_[f * stride()], size_, &more_words[f * (capacity + slack)]);
        doubles_ = std::move(more_doubles);
        words_ = std::move(more_words);
        capacity_ = capacity;
    }

    void push(const WaitingRay& ray) {
        const std::size_t i = grow(1);
        for (int axis = 0; axis < 3; ++axis) {
            (*this)[Field(ox + axis)][i] = ray.origin[axis];
            (*this)[Field(dx + axis)][i] = ray.direction[axis];
            (*this)[Field(red + axis)][i] = ray.throughput[axis];
        }
        (*this)[weight][i] = ray.weight;
        (*this)[t_max][i] = ray.t_max;
        (*this)[way][i] = ray.way_before;
        word(code)[i] = (ray.code & ~RayCode::birth_mask) | RayCode::of_birth(ray.birth_magnitude);
        word(key)[i] = ray.key;
        for (int w = 0; w < list_words; ++w)
            word(Field(inside + w))[i] = ray.inside[std::size_t(w)];
        word(contacts)[i] = ray.contacts;
        word(sphere_contacts)[i] = ray.sphere_contacts;
        word(mesh_contacts)[i] = ray.mesh_contacts;
    }
    /// Makes room for rays on top, whose fields are then set; returns where the first of them is.
    std::size_t grow(std::size_t count) {
        reserve(size_ + count);
        size_ += count;
        return size_ - count;
    }
    /// The same number or word in a field of all rays from `first` on.
    void fill(Field field, std::size_t first, double x) {
        std::fill((*this)[field] + first, (*this)[field] + size_, x);
    }
    void fill_words(Field field, std::size_t first, std::uint64_t x) {
        std::fill(word(field) + first, word(field) + size_, x);
    }

private:
    std::size_t stride() const { return capacity_ + slack; }

    std::size_t size_ = 0, capacity_ = 0;
    std::unique_ptr<double[]> doubles_;
    std::unique_ptr<std::uint64_t[]> words_;
};

}  // namespace meniscus::lanes
