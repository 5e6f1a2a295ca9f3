#include "lang/unused_objects.hpp"

namespace meniscus::lang {

std::vector<UnusedObject> ObjectUse::unused(const Source& file) const {
    std::vector<UnusedObject> result;
    for (const auto& [place, declared] : declared_) {
        if (place.first == &file && !read_.contains(place))
            result.push_back({declared.name, declared.where.location()});
    }
    return result;
}

}  // namespace meniscus::lang
