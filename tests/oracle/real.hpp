#pragma once

#include <cmath>

namespace meniscus::oracle {

/// The types that the oracle is instantiated for: 53, 64 and 113 bits. The last is done in software
/// and slow.
using Extended = long double;
__extension__ typedef __float128 Quad;

inline double square_root(double x) { return std::sqrt(x); }
inline Extended square_root(Extended x) { return std::sqrt(x); }
/// Newton's steps from the 64-bit root: no library is needed.
inline Quad square_root(Quad x) {
    if (!(x > 0)) return 0;
    Quad root = std::sqrt(static_cast<Extended>(x));
    for (int i = 0; i < 2; ++i) root = (root + x / root) / 2;
    return root;
}

template <class Real>
Real absolute(Real x) {
    return x < 0 ? -x : x;
}

/// A vector of its own: nothing is shared with the code under test.
template <class Real>
struct Vector {
    Real x{0}, y{0}, z{0};

    friend Vector operator+(const Vector& a, const Vector& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend Vector operator-(const Vector& a, const Vector& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
    friend Vector operator*(Real s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
    friend Real dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    friend Vector cross(const Vector& a, const Vector& b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    friend Vector unit(const Vector& a) { return (Real(1) / square_root(dot(a, a))) * a; }
};

/// From any vector of doubles.
template <class Real, class V>
Vector<Real> widen(const V& v) {
    return {Real(v.x), Real(v.y), Real(v.z)};
}

}  // namespace meniscus::oracle
