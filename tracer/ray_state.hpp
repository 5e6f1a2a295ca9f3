#pragma once

#include "geom/crossing.hpp"
#include "geom/inline_vector.hpp"
#include "geom/ray.hpp"
#include "tracer/interior_list.hpp"

namespace meniscus::tracer {

/// A face that a ray's origin lies on. Of solids that stand in no list, it also says on which side
/// the ray starts.
struct Contact {
    int part;
    geom::Face face;
    bool starts_inside;
};

using Contacts = geom::InlineVector<Contact, 4>;

/// Which objects a ray can meet: no_image, no_reflection and no_shadow hide some of them.
enum class RayKind { image, reflection, shadow };

/// M of the crossing where a ray was born: bounds how far its origin is off.
struct Birth {
    double magnitude = 0.0;
    int anchor = no_anchor;           // that everything crossed there shares
    double anchored_magnitude = 0.0;  // M from there
};

/// A ray with all that it knows about where it starts. The list says whether it is inside; geometry
/// only says where that changes.
struct TracedRay {
    geom::Ray ray;
    InteriorList interior;
    Contacts contacts;
    Birth birth;
    RayKind kind = RayKind::image;
};

/// Where the medium changes, or where an opaque or open surface is met.
struct Event {
    double t = 0.0;
    int part = outside;  // whose surface it is: its normal
    int skin = outside;  // whose texture is seen: the same part, but where a higher solid ends
                         // inside an opaque one
    geom::Face face = geom::no_face;
    geom::Vec3 normal{0.0};          // outward unit normal of `part`'s solid
    geom::Vec3 shading_normal{0.0};  // of its shape, of either side
    geom::Ray origin;  // the point as an origin of new rays, without a direction: position and its
                       // rounding error
    InteriorList before, after;
    int solid_before = outside, solid_after = outside;
    Contacts contacts;  // of rays that stay on this side; for those that go on `starts_inside` is
                        // flipped
    Birth birth;        // of rays that are born here
};

}  // namespace meniscus::tracer
