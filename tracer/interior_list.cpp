#include "tracer/interior_list.hpp"

namespace meniscus::tracer {

int InteriorList::depth(int part) const {
    for (const Member& member : members_) {
        if (member.part == part) return member.depth;
    }
    return 0;
}

void InteriorList::change(int part, int by, bool entering) {
    for (std::size_t i = 0; i < members_.size(); ++i) {
        Member& member = members_[i];
        if (member.part != part) continue;
        member.depth += by;
        if (entering) member.serial = next_serial_++;
        if (member.depth == 0) members_.erase(i);
        return;
    }
    members_.push_back({part, by, next_serial_++});
}

void InteriorList::enter(int part) { change(part, +1, true); }
void InteriorList::leave(int part) { change(part, -1, false); }

int InteriorList::top(const RenderScene& scene) const {
    const Member* best = nullptr;
    for (const Member& member : members_) {
        if (member.depth <= 0) continue;
        if (!best) {
            best = &member;
            continue;
        }
        const double priority = scene.parts[member.part].priority;
        const double best_priority = scene.parts[best->part].priority;
        if (priority > best_priority ||
            (priority == best_priority && member.serial > best->serial)) {
            best = &member;
        }
    }
    return best ? best->part : outside;
}

int InteriorList::top_solid(const RenderScene& scene) const {
    const int part = top(scene);
    return part == outside ? outside : scene.parts[part].solid;
}

}  // namespace meniscus::tracer
