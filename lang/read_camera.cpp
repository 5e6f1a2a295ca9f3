#include "lang/read_camera.hpp"

#include <cmath>
#include <numbers>

#include "lang/evaluate.hpp"
#include "lang/extent.hpp"
#include "lang/read_pigment.hpp"
#include "lang/read_transform.hpp"

namespace meniscus::lang {
namespace {

using geom::Vec3;

bool read_place(Cursor& cursor, CameraItem& camera) {
    if (cursor.accept("location")) {
        camera.location = cursor.vector();
    } else if (cursor.accept("look_at")) {
        camera.look_at = cursor.vector();
    } else if (cursor.accept("direction")) {
        camera.direction = cursor.vector();
    } else if (cursor.accept("sky")) {
        camera.sky = cursor.vector();
    } else if (cursor.accept("right")) {
        camera.right = cursor.vector();
        camera.states_size = true;
    } else if (cursor.accept("up")) {
        camera.up = cursor.vector();
        camera.states_size = true;
    } else {
        return false;
    }
    return true;
}

bool read_lens(Cursor& cursor, CameraItem& camera) {
    const auto span = cursor.span();
    if (cursor.accept("perspective")) {
        camera.kind = scene::Camera::Kind::perspective;
    } else if (cursor.accept("orthographic")) {
        camera.kind = scene::Camera::Kind::orthographic;
    } else if (cursor.accept("angle")) {
        camera.angle_degrees = cursor.number();
        if (cursor.expression()) cursor.number();  // the vertical angle of a spherical camera
    } else if (cursor.accept("aperture")) {
        if (cursor.number() != 0.0 && !camera.refusal)
            camera.refusal = Refusal{"aperture", span, {}};
    } else if (cursor.accept("focal_point")) {
        cursor.vector();
    } else if (cursor.accept("blur_samples") || cursor.accept("variance") ||
               cursor.accept("confidence")) {
        cursor.number();
        if (cursor.expression()) cursor.number();
    } else {
        return false;
    }
    return true;
}

double sign(double v) { return v < 0.0 ? -1.0 : 1.0; }

[[noreturn]] void fail(const Span& span, const char* text) { throw SourceError(span, text); }

}  // namespace

CameraItem read_camera(Cursor& cursor) {
    CameraItem camera;
    while (!cursor.at_end()) {
        if (read_place(cursor, camera) || read_lens(cursor, camera) ||
            read_transform(cursor, camera.transform))
            continue;
        const auto* value = cursor.declared();
        if (const auto* other = value ? value->item<CameraItem>() : nullptr) {
            camera = *other;
            cursor.advance();
            continue;
        }
        if (!is_reserved_next(cursor)) cursor.fail_unknown();
        refuse_rest(cursor, camera.refusal);
    }
    return camera;
}

scene::Camera resolve(const CameraItem& camera, const Span& span) {
    if (camera.refusal) throw refuse(*camera.refusal);
    scene::Camera result;
    result.kind = camera.kind;
    result.location = camera.location;
    result.direction = camera.direction;
    result.right = camera.right;
    result.up = camera.up;

    const double width = glm::length(camera.right), height = glm::length(camera.up);
    double depth = glm::length(camera.direction);
    if (width == 0.0) fail(span, "the camera's 'right' is zero");
    if (height == 0.0) fail(span, "the camera's 'up' is zero");
    if (depth == 0.0) fail(span, "the camera's 'direction' is zero");
    if (camera.angle_degrees) {
        const double angle = *camera.angle_degrees;
        if (!(angle > 0.0 && angle < 180.0))
            fail(span, "the camera's 'angle' must lie between 0 and 180 degrees");
        depth = width / (2.0 * std::tan(angle * std::numbers::pi / 360.0));
        result.direction = glm::normalize(camera.direction) * depth;
    }
    // without look_at, POV-Ray sizes an orthographic picture as if it were <0, 0, 1>
    double distance = glm::length(camera.look_at.value_or(Vec3{0.0, 0.0, 1.0}) - camera.location);
    if (camera.look_at) {
        const auto towards = *camera.look_at - camera.location;
        if (distance == 0.0) fail(span, "the camera's 'look_at' is its 'location'");
        if (camera.sky == Vec3{0.0}) fail(span, "the camera's 'sky' is zero");
        const double hand = sign(glm::dot(glm::cross(camera.up, camera.direction), camera.right));
        const auto d = towards / distance;
        auto r = glm::cross(camera.sky, d);
        // looking along the sky, POV-Ray keeps `right` as it was given
        if (glm::length(r) < 1e-10 * glm::length(camera.sky)) r = camera.right;
        r = glm::normalize(r);
        result.direction = depth * d;
        result.right = hand * width * r;
        result.up = height * glm::cross(d, r);
    }
    if (camera.kind == scene::Camera::Kind::orthographic &&
        (camera.angle_degrees || !camera.states_size)) {
        result.right *= distance / depth;
        result.up *= distance / depth;
    }
    const auto& t = camera.transform;
    result.location = t.point(result.location);
    result.direction = t.vector(result.direction);
    result.right = t.vector(result.right);
    result.up = t.vector(result.up);
    for (const auto& v : {result.location, result.direction, result.right, result.up})
        check_extent(std::abs(v.x) + std::abs(v.y) + std::abs(v.z), "this camera", span);
    return result;
}

}  // namespace meniscus::lang
