#include "lang/read_array.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lang/cursor.hpp"
#include "lang/evaluate.hpp"
#include "lang/read_value.hpp"

namespace meniscus::lang {
namespace {

std::size_t read_size(Session& session, const ast::Expression& node) {
    const double size = std::trunc(evaluate_number(session, node));
    if (!(size >= 1.0 && size <= static_cast<double>(session.options.limits.array_elements))) {
        throw SourceError(node.span, fmt::format("an array of {} elements cannot be made", size));
    }
    return static_cast<std::size_t>(size);
}

/// Fills the elements of one dimension, starting at `place`.
void fill(Session& session, ArrayValue& array, const std::vector<ast::Array::Element>& elements,
          std::size_t dimension, std::size_t place, const Span& span) {
    std::size_t stride = 1;
    for (auto i = dimension + 1; i < array.sizes.size(); ++i) stride *= array.sizes[i];
    if (elements.size() > array.sizes[dimension]) {
        throw SourceError(span, fmt::format("{} values for an array of {}", elements.size(),
                                            array.sizes[dimension]));
    }
    for (const auto& element : elements) {
        if (const auto* nested = std::get_if<std::vector<ast::Array::Element>>(&element.value)) {
            if (dimension + 1 == array.sizes.size())
                throw SourceError(element.span, "more braces than the array has dimensions");
            fill(session, array, *nested, dimension + 1, place, element.span);
        } else {
            if (dimension + 1 < array.sizes.size())
                throw SourceError(element.span,
                                  "expected '{' and the elements of the next dimension");
            Cursor cursor(session, std::get<ast::Items>(element.value), element.span, "array");
            array.elements[place] = read_value(cursor);
            cursor.expect_end();
            if (const auto* inner = array.elements[place].get<std::shared_ptr<ArrayValue>>()) {
                array.depth = std::max(array.depth, (*inner)->depth + 1);
                if (array.depth > session.options.limits.nesting)
                    throw SourceError(element.span, "arrays nested too deep");
            }
        }
        place += stride;
    }
}

}  // namespace

Value read_array(Session& session, const ast::Array& node, const Span& span) {
    auto array = std::make_shared<ArrayValue>();
    std::size_t total = 1;
    for (const auto& size : node.sizes) {
        array->sizes.push_back(read_size(session, size));
        total *= array->sizes.back();
        if (total > session.options.limits.array_elements)
            throw SourceError(span, "this array is too large");
    }
    array->elements.resize(total);
    if (node.has_elements) fill(session, *array, node.elements, 0, 0, span);
    return {std::move(array)};
}

}  // namespace meniscus::lang
