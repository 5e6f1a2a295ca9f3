#pragma once

#include <array>
#include <memory>
#include <vector>

#include "geom/shape.hpp"
#include "geom/transform.hpp"
#include "tests/geom/exact_roots.hpp"

namespace meniscus::geom {

/// A shape in its own frame, in quad precision: where a line meets any of the whole surfaces that
/// it is cut from (whole planes, whole cones), whether it contains a point, and which way a face
/// looks. Faces are numbered as in geom/.
class ExactShape {
public:
    struct Meeting {
        Quad t;
        Face face;
    };

    virtual ~ExactShape() = default;
    virtual void meet(const QuadVec& o, const QuadVec& d, std::vector<Meeting>& out) const = 0;
    virtual bool contains(const QuadVec& p) const = 0;
    /// Along the normal of the face at `p`, which is near it; of any length.
    virtual QuadVec gradient(Face face, const QuadVec& p) const = 0;
};

/// Box, cone, cylinder, lathe, plane, sphere or torus; throws std::invalid_argument for others.
std::unique_ptr<ExactShape> exact_shape(const Shape& shape);
std::unique_ptr<ExactShape> exact_lathe(const Lathe& lathe);

/// Tells in quad precision where a line passes through the surface of a closed shape in its place:
/// all meetings of the line with all faces, and inside or outside halfway between two.
class Referee {
public:
    struct Crossing {
        Quad t;
        Face face;
    };

    Referee(const Shape& shape, const Transform& transform);

    std::vector<Crossing> crossings(const Ray& ray) const;
    bool contains(const QuadVec& p) const { return shape_->contains(to_local(p)); }
    /// The unit normal of the face where the line is at t.
    QuadVec normal(const Ray& ray, Face face, Quad t) const;
    /// |d.n| where the line is at t, near the face.
    double cosine(const Ray& ray, Face face, Quad t) const;

    static QuadVec origin(const Ray& ray);
    static QuadVec at(const Ray& ray, Quad t);

private:
    QuadVec to_local_vector(const QuadVec& v) const;
    QuadVec to_local(const QuadVec& p) const { return to_local_vector(p - shift_); }

    std::unique_ptr<ExactShape> shape_;
    std::array<QuadVec, 3> rows_;  // of the inverse linear map
    QuadVec shift_;
};

}  // namespace meniscus::geom
