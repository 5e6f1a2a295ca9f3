#include "lang/read_transform.hpp"

#include <stdexcept>

#include "lang/diagnostic.hpp"

namespace meniscus::lang {
namespace {

geom::Vec3 read_scale(Cursor& cursor, const Span& span) {
    auto factors = cursor.vector();
    for (int i = 0; i < 3; ++i) {
        if (factors[i] == 0.0) {
            cursor.session().warn(span, "scale by 0 is taken as scale by 1");
            factors[i] = 1.0;
        }
    }
    return factors;
}

geom::Transform read_matrix(Cursor& cursor) {
    const auto span = cursor.span();
    // twelve numbers in angle brackets: the images of x, y, z and of the origin, row by row
    const auto* node = cursor.expression();
    const auto* vector = node ? std::get_if<ast::Vector>(&node->node) : nullptr;
    if (!vector) cursor.fail_expected("a matrix of 12 numbers");
    Cursor numbers(cursor.session(), vector->items, node->span, "matrix");
    double m[12];
    for (auto& value : m) value = numbers.number();
    numbers.expect_end();
    cursor.advance();
    const geom::Mat3 linear{{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}};
    try {
        return {linear, {m[9], m[10], m[11]}};
    } catch (const std::invalid_argument&) {
        throw SourceError(span, "this matrix is singular: it flattens what it transforms");
    }
}

geom::Transform scaling(const geom::Vec3& factors, const Span& span) {
    try {
        return geom::Transform::scaling(factors);
    } catch (const std::invalid_argument&) {
        throw SourceError(span, "this scale is too small or too large");
    }
}

}  // namespace

geom::Transform chain_transforms(const geom::Transform& first, const geom::Transform& next,
                                 const Span& span) {
    try {
        return first.then(next);
    } catch (const std::invalid_argument&) {
        throw SourceError(span, "together, these transformations are too small or too large");
    }
}

bool read_transform(Cursor& cursor, geom::Transform& transform) {
    const auto span = cursor.span();
    geom::Transform next;
    if (cursor.accept("translate")) {
        next = geom::Transform::translation(cursor.vector());
    } else if (cursor.accept("rotate")) {
        next = geom::Transform::rotation_degrees(cursor.vector());
    } else if (cursor.accept("scale")) {
        next = scaling(read_scale(cursor, span), span);
    } else if (cursor.accept("matrix")) {
        next = read_matrix(cursor);
    } else if (cursor.accept("transform")) {
        const auto* value = cursor.declared();
        const auto* item = value ? value->item<TransformItem>() : nullptr;
        if (!item) cursor.fail_expected("a declared transform");
        next = item->transform;
        cursor.advance();
    } else if (const auto* block = cursor.block(); block && block->word == "transform") {
        Cursor inner(cursor.session(), *block, span);
        next = read_transform_block(inner).transform;
        cursor.advance();
    } else {
        return false;
    }
    transform = chain_transforms(transform, next, span);
    return true;
}

TransformItem read_transform_block(Cursor& cursor) {
    TransformItem item;
    while (!cursor.at_end()) {
        if (read_transform(cursor, item.transform)) continue;
        if (cursor.accept("inverse")) {
            item.transform = item.transform.inverse();
            continue;
        }
        const auto* value = cursor.declared();
        const auto* other = value ? value->item<TransformItem>() : nullptr;
        if (!other) cursor.fail_unknown();
        item.transform = chain_transforms(item.transform, other->transform, cursor.span());
        cursor.advance();
    }
    return item;
}

}  // namespace meniscus::lang
