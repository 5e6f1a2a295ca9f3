#pragma once

#include <vector>

#include "tests/oracle/real.hpp"

namespace meniscus::geom {

using oracle::Quad;
using QuadVec = oracle::Vector<Quad>;

/// Where c[0] + c[1] x + ... changes its sign between `low` and `high`, sorted, to the last digits
/// of quad precision: between the roots of its derivative a polynomial is monotonic.
inline std::vector<Quad> sign_changes(const std::vector<Quad>& c, Quad low, Quad high) {
    if (c.size() < 2) return {};
    const auto value = [&](Quad x) {
        Quad sum = 0;
        for (std::size_t i = c.size(); i-- > 0;) sum = sum * x + c[i];
        return sum;
    };
    std::vector<Quad> derivative;
    for (std::size_t i = 1; i < c.size(); ++i) derivative.push_back(Quad(int(i)) * c[i]);
    const auto slope = [&](Quad x) {
        Quad sum = 0;
        for (std::size_t i = derivative.size(); i-- > 0;) sum = sum * x + derivative[i];
        return sum;
    };
    std::vector<Quad> roots, stops = sign_changes(derivative, low, high);
    stops.push_back(high);
    Quad left = low, at_left = value(low);
    for (const Quad right : stops) {
        const Quad at_right = value(right);
        if ((at_left < 0) != (at_right < 0)) {
            // Newton's step, halving instead where it leaves the bracket.
            Quad a = left, b = right, x = (a + b) / 2;
            for (int i = 0; i < 250 && a < b; ++i) {
                const Quad here = value(x);
                if (here == 0) break;
                ((here < 0) == (at_left < 0) ? a : b) = x;
                Quad next = x - here / slope(x);
                if (!(next > a && next < b)) next = (a + b) / 2;
                const Quad step = oracle::absolute(Quad(next - x));
                x = next;
                if (step <= oracle::absolute(x) * Quad(1e-33)) break;
            }
            roots.push_back(x);
        }
        left = right;
        at_left = at_right;
    }
    return roots;
}

}  // namespace meniscus::geom
