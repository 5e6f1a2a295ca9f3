#include "lang/symbols.hpp"

#include <ranges>

namespace meniscus::lang {

Slot Symbols::find(std::string_view name) const {
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
        if (const auto found = scope->find(name); found != scope->end()) return found->second;
    }
    return nullptr;
}

Slot Symbols::declare(std::string_view name) {
    if (auto slot = find(name)) return slot;
    return scopes_.front().emplace(std::string(name), std::make_shared<Value>()).first->second;
}

Slot Symbols::declare_local(std::string_view name) {
    auto& scope = scopes_.back();
    if (const auto found = scope.find(name); found != scope.end()) return found->second;
    return scope.emplace(std::string(name), std::make_shared<Value>()).first->second;
}

void Symbols::bind(std::string_view name, Slot slot) {
    scopes_.back().insert_or_assign(std::string(name), std::move(slot));
}

void Symbols::remove(std::string_view name) {
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
        if (const auto found = scope->find(name); found != scope->end()) {
            scope->erase(found);
            return;
        }
    }
}

std::vector<std::string> Symbols::names() const {
    std::vector<std::string> all;
    for (const auto& scope : scopes_) {
        for (const auto& entry : scope) all.push_back(entry.first);
    }
    return all;
}

}  // namespace meniscus::lang
