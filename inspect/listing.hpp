#pragma once

#include <string>
#include <vector>

#include "inspect/names.hpp"
#include "tracer/interior_list.hpp"

namespace meniscus::inspect {

/// An interior list as people read it: solids in the order of their latest entry, each once.
struct Listing {
    struct Member {
        int solid;
        int depth;  // how many times the ray is inside it
    };
    std::vector<Member> members;
    int top = tracer::outside;  // the solid that is there

    bool operator==(const Listing& other) const;
};

Listing listing(const tracer::RenderScene& scene, const tracer::InteriorList& list);

/// "Glass, Water", "Glass x2" for a solid entered twice, "empty".
std::string text(const Names& names, const Listing& listing);

}  // namespace meniscus::inspect
