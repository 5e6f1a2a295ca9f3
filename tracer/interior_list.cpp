#include "tracer/interior_list.hpp"

namespace meniscus::tracer {

// What was entered last is asked for first.
int InteriorList::depth(int part) const {
    const Member* const first = begin();
    for (const Member* member = first + size(); member != first;) {
        if ((--member)->part == part) return member->depth;
    }
    return 0;
}

/// The part's own entry, in memory that is this list's alone; null if it has none.
InteriorList::Member* InteriorList::find(int part) {
    if (many_ && many_.use_count() > 1) many_ = std::make_shared<std::vector<Member>>(*many_);
    Member* const first = many_ ? many_->data() : few_.data();
    for (Member* member = first + size(); member != first;) {
        if ((--member)->part == part) return member;
    }
    return nullptr;
}

void InteriorList::add(const Member& member) {
    if (!many_ && count_ < most_few) {
        few_[count_++] = member;
        return;
    }
    if (!many_) many_ = std::make_shared<std::vector<Member>>(few_.begin(), few_.end());
    many_->push_back(member);
}

void InteriorList::remove(Member* member) {
    std::move(member + 1, member + (end() - member), member);
    if (!many_) {
        --count_;
        return;
    }
    many_->pop_back();
    if (many_->size() > most_few / 2) return;
    std::copy(many_->begin(), many_->end(), few_.begin());
    count_ = std::uint32_t(many_->size());
    many_.reset();
}

void InteriorList::enter(int part) {
    // Of two that were entered unasked the order of asking would be the wrong one.
    if (entered_ != outside) top_ = unknown;
    entered_ = part;
    Member* const member = find(part);
    if (!member) {
        add({part, 1, next_serial_++});
        return;
    }
    ++member->depth;
    member->serial = next_serial_++;
    if (member->depth <= 0) top_ = unknown;
    if (member->depth == 0) remove(member);
}

void InteriorList::leave(int part) {
    if (part == top_ || part == entered_) top_ = unknown;
    Member* const member = find(part);
    if (!member) {
        add({part, -1, next_serial_++});
    } else if (--member->depth == 0) {
        remove(member);
    }
}

int InteriorList::find_top(const RenderScene& scene) const {
    const Member* best = nullptr;
    double best_priority = 0.0;
    for (const Member& member : *this) {
        if (member.depth <= 0) continue;
        const double priority = scene.priorities[std::size_t(member.part)];
        if (!best || priority > best_priority ||
            (priority == best_priority && member.serial > best->serial)) {
            best = &member;
            best_priority = priority;
        }
    }
    return best ? best->part : outside;
}

int InteriorList::top(const RenderScene& scene) const {
    if (top_ == unknown) {
        top_ = find_top(scene);
    } else if (entered_ != outside &&
               (top_ == outside ||
                scene.priorities[std::size_t(entered_)] >= scene.priorities[std::size_t(top_)])) {
        top_ = entered_;
    }
    entered_ = outside;
    return top_;
}

int InteriorList::top_solid(const RenderScene& scene) const {
    const int part = top(scene);
    return part == outside ? outside : scene.parts[std::size_t(part)].solid;
}

}  // namespace meniscus::tracer
