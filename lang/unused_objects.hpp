#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "lang/source.hpp"

namespace meniscus::lang {

/// An object that a scene declares and never uses.
struct UnusedObject {
    std::string name;
    scene::Location location;
};

/// Which declared objects have been read. What counts is the place of the declaration: one in a
/// loop or a macro is used as soon as one of its objects is.
class ObjectUse {
public:
    void declare(std::string_view name, const Span& where) {
        declared_.try_emplace(place(where), Declared{std::string(name), where});
    }
    void read(const Span& declared_where) { read_.insert(place(declared_where)); }

    /// Those of one file, in its order.
    std::vector<UnusedObject> unused(const Source& file) const;

private:
    struct Declared {
        std::string name;
        Span where;
    };
    using Place = std::pair<const Source*, std::uint32_t>;
    static Place place(const Span& span) { return {span.source, span.begin}; }

    std::map<Place, Declared> declared_;
    std::set<Place> read_;
};

}  // namespace meniscus::lang
