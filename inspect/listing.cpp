#include "inspect/listing.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meniscus::inspect {

bool Listing::operator==(const Listing& other) const {
    return top == other.top &&
           std::ranges::equal(members, other.members, [](const Member& a, const Member& b) {
               return a.solid == b.solid && a.depth == b.depth;
           });
}

Listing listing(const tracer::RenderScene& scene, const tracer::InteriorList& list) {
    std::vector<tracer::InteriorList::Member> parts(list.begin(), list.end());
    std::ranges::sort(parts, {}, &tracer::InteriorList::Member::serial);
    Listing result;
    for (const auto& part : parts) {
        if (part.depth <= 0) continue;
        const int solid = scene.parts[std::size_t(part.part)].solid;
        int depth = part.depth;
        std::erase_if(result.members, [&](const Listing::Member& member) {
            if (member.solid != solid) return false;
            depth += member.depth;
            return true;
        });
        result.members.push_back({solid, depth});
    }
    result.top = list.top_solid(scene);
    return result;
}

std::string text(const Names& names, const Listing& listing) {
    std::string text;
    for (const auto& member : listing.members) {
        if (!text.empty()) text += ", ";
        text += names.solid(member.solid);
        if (member.depth > 1) text += fmt::format(" x{}", member.depth);
    }
    return text.empty() ? "empty" : text;
}

}  // namespace meniscus::inspect
