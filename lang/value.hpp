#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "lang/ast.hpp"
#include "lang/items.hpp"

namespace meniscus::lang {

/// Two to five components; a colour has five: red, green, blue, filter, transmit.
struct Vector {
    std::array<double, 5> at{};
    int size = 3;
    bool is_color = false;
};

/// `seed(n)`: copies of the handle share the stream.
struct Seed {
    std::uint32_t state = 0;
    double next();
};

struct MacroValue {
    const ast::Macro* macro;
    Span span;
};

struct Value;

struct ArrayValue {
    std::vector<std::size_t> sizes;
    std::vector<Value> elements;
    int depth = 1;
};

template <class T>
using Shared = std::shared_ptr<const T>;

/// Anything that can be declared. Scene items are shared and never change: to modify one is to copy
/// it. Refusals stand for what is read but not supported: they pass through expressions and are
/// reported where their value is needed.
struct Value {
    std::variant<std::monostate, double, Vector, std::string, Refusal, std::shared_ptr<Seed>,
                 std::shared_ptr<ArrayValue>, Shared<MacroValue>, Shared<PigmentItem>,
                 Shared<FinishItem>, Shared<NormalItem>, Shared<TextureItem>, Shared<MaterialItem>,
                 Shared<InteriorItem>, Shared<MapItem>, Shared<TransformItem>, Shared<ObjectItem>,
                 Shared<CameraItem>, Shared<SkyItem>>
        data;

    bool is_set() const { return data.index() != 0; }
    template <class T>
    const T* get() const {
        return std::get_if<T>(&data);
    }
    template <class T>
    const T* item() const {
        const auto* shared = std::get_if<Shared<T>>(&data);
        return shared ? shared->get() : nullptr;
    }
};

template <class T>
Value make_item(T item) {
    return {std::make_shared<const T>(std::move(item))};
}

/// "a number", "a texture", ... for messages.
std::string kind_of(const Value& value);

}  // namespace meniscus::lang
