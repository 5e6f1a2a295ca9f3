#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "lang/value.hpp"

namespace meniscus::lang {

/// A variable: macro parameters share it with the caller.
using Slot = std::shared_ptr<Value>;

/// The names that a scene has declared. Lookup is dynamic: a macro sees its callers' locals.
class Symbols {
public:
    Symbols() { enter(); }

    void enter() { scopes_.emplace_back(); }
    void leave() { scopes_.pop_back(); }

    Slot find(std::string_view name) const;
    /// The variable that `#declare` sets: the one that is visible, else a new global one.
    Slot declare(std::string_view name);
    /// The variable that `#local` sets: one of the innermost scope.
    Slot declare_local(std::string_view name);
    /// Makes a parameter's name stand for a variable, in the innermost scope.
    void bind(std::string_view name, Slot slot);
    void remove(std::string_view name);

    std::vector<std::string> names() const;

private:
    struct Hash {
        using is_transparent = void;
        std::size_t operator()(std::string_view text) const {
            return std::hash<std::string_view>{}(text);
        }
    };
    using Scope = std::unordered_map<std::string, Slot, Hash, std::equal_to<>>;
    std::vector<Scope> scopes_;
};

}  // namespace meniscus::lang
