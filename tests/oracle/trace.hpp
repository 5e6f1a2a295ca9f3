#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "tests/oracle/pigments.hpp"
#include "tests/oracle/world.hpp"

namespace meniscus::oracle {

/// Where the whole ray tree ends, with the meaning that `tracer::Options` gives to both.
struct Limits {
    /// Segments of one path, the camera's counted. Where a surface bends nothing, the segment
    /// behind it is not counted anew, but the last one is still the last.
    int depth = 20;
    /// Branches of less weight are dropped: the product of the largest channels of what was
    /// reflected and let through on the way.
    double cutoff = 1e-6;
    double contact = 3e-14;  // see World; in scene units
};

/// How much of the light gets through the length of a medium.
inline scene::Rgb transmittance(const scene::Interior& medium, double length) {
    const bool forever = std::isinf(length);
    scene::Rgb result{1.0};
    for (int c = 0; c < 3; ++c) {
        if (medium.absorption[c] != 0.0) result[c] *= std::exp(-medium.absorption[c] * length);
        if (!medium.fade.is_active()) continue;
        const double color = medium.fade.color[c], way = length / medium.fade.distance;
        if (medium.fade.power >= 1000.0) {
            if (color != 1.0) result[c] *= std::exp(-(1.0 - color) * way);
        } else {
            result[c] *=
                forever ? color : color + (1.0 - color) / (1.0 + std::pow(way, medium.fade.power));
        }
    }
    return result;
}

/// The reflected share of unpolarised light, from the two polarised ones (Fresnel).
template <class Real>
Real reflectance(Real n1, Real n2, Real cosine) {
    const Real sine2 = (n1 / n2) * (n1 / n2) * (1 - cosine * cosine);
    if (sine2 >= 1) return 1;
    const Real cosine2 = square_root(Real(1 - sine2));
    const Real s = (n1 * cosine - n2 * cosine2) / (n1 * cosine + n2 * cosine2);
    const Real p = (n1 * cosine2 - n2 * cosine) / (n1 * cosine2 + n2 * cosine);
    return (s * s + p * p) / 2;
}

template <class Real>
class Tracer {
public:
    using V = Vector<Real>;
    using Rgb = scene::Rgb;

    Tracer(const scene::Scene& scene, const Limits& limits)
        : world_(scene, limits.contact), limits_(limits) {}

    /// A ray of the tree, with what `radiance` is given beside it.
    struct Branch {
        V o, d;
        int level;
        double weight;
        bool straight_on;
    };
    std::vector<Branch>* record = nullptr;  // where to note each, if anyone wants to know
    std::function<V(const V& o)> moved;     // where a ray starts in place of o, if it is set

    const World<Real>& world() const { return world_; }

    /// The light at the centre of pixel (x, y).
    Rgb pixel(int x, int y, int width, int height) const {
        return sample(Real(x) + Real(0.5), Real(y) + Real(0.5), width, height);
    }

    /// The light at a point of the film, in pixels from the top left.
    Rgb sample(Real x, Real y, int width, int height) const {
        const scene::Camera& camera = world_.scene().camera;
        const Real a = x / Real(width) - Real(0.5), b = Real(0.5) - y / Real(height);
        const V offset = a * widen<Real>(camera.right) + b * widen<Real>(camera.up);
        const V location = widen<Real>(camera.location), ahead = widen<Real>(camera.direction);
        if (camera.kind == scene::Camera::Kind::orthographic)
            return radiance(location + offset, unit(ahead), 0, 1.0);
        return radiance(location, unit(ahead + offset), 0, 1.0);
    }

    /// `level` is that of the segment before.
    Rgb radiance(V o, const V& d, int level, double weight, bool straight_on = false) const {
        if (moved) o = moved(o);
        if (level >= limits_.depth) return Rgb{0.0};
        if (record) record->push_back({o, d, level, weight, straight_on});
        if (!straight_on) ++level;
        if (weight < limits_.cutoff) return Rgb{0.0};
        int start = nothing;
        const auto surface = world_.next(o, d, start);
        if (!surface) {
            return transmittance(world_.medium(start), geom::infinity) *
                   sky(world_.scene(), narrow(d));
        }
        const V p = o + surface->t * d;
        const scene::Object& object = world_.scene().objects[surface->skin];
        const scene::Texture& texture = world_.scene().textures[object.texture];
        const Rgb light = texture.clear ? clear_skin(*surface, p, d, level, weight)
                                        : textured(*surface, texture, p, d, level, weight);
        return transmittance(world_.medium(start), double(surface->t)) * light;
    }

private:
    static geom::Vec3 narrow(const V& v) { return {double(v.x), double(v.y), double(v.z)}; }
    static double largest(const Rgb& c) { return std::max({c.r, c.g, c.b}); }
    static V mirrored(const V& d, const V& n) { return unit(d - (2 * dot(d, n)) * n); }
    Real ior(int solid) const { return world_.medium(solid).ior; }

    bool bends_nothing(const Surface<Real>& surface) const {
        return absolute(ior(surface.before) / ior(surface.after) - 1) < Real(1e-10);
    }

    /// Snell; no direction under total reflection. `n` faces the ray.
    std::optional<V> refracted(const Surface<Real>& surface, const V& d) const {
        const Real eta = ior(surface.before) / ior(surface.after);
        const Real c = -dot(d, surface.normal), k = 1 - eta * eta * (1 - c * c);
        if (k < 0) return std::nullopt;
        return unit(eta * d + (eta * c - square_root(k)) * surface.normal);
    }

    Rgb clear_skin(const Surface<Real>& surface, const V& p, const V& d, int level,
                   double weight) const {
        const auto through = refracted(surface, d);
        const V back = mirrored(d, surface.normal);
        if (!through) return radiance(p, back, level, weight);
        const double reflected =
            double(reflectance(ior(surface.before), ior(surface.after), -dot(d, surface.normal)));
        Rgb light = (1.0 - reflected) * radiance(p, *through, level, (1.0 - reflected) * weight,
                                                 bends_nothing(surface));
        if (reflected > 0.0) light += reflected * radiance(p, back, level, reflected * weight);
        return light;
    }

    /// POV-Ray's rules for a finish.
    Rgb textured(const Surface<Real>& surface, const scene::Texture& texture, const V& p,
                 const V& d, int level, double weight) const {
        const scene::Finish& finish = texture.finish;
        const geom::Vec3 in_texture =
            texture.transform.inverse_linear() * (narrow(p) - texture.transform.shift());
        const scene::Color color = color_at(texture.pigment, in_texture);
        const double cosine = double(-dot(d, surface.normal));

        Rgb light = color.opacity() * color.rgb *
                    (finish.ambient * world_.scene().settings.ambient_light + finish.emission);
        for (const scene::Light& lamp : world_.scene().lights)
            light += lit(lamp, finish, color, p, d, surface.normal);

        const Rgb rho = reflectivity(surface, finish, color.rgb, cosine);
        Rgb through = color.transparency();
        if (finish.conserve_energy) through *= Rgb{1.0} - rho;
        const V back = mirrored(d, surface.normal);
        if (largest(through) > 0.0) {
            const auto direction = refracted(surface, d);
            if (!direction) return light + radiance(p, back, level, largest(through) * weight);
            light += through * radiance(p, *direction, level, largest(through) * weight,
                                        bends_nothing(surface));
        }
        if (finish.reflection.is_active()) {
            const scene::Reflection& r = finish.reflection;
            const double share =
                r.fresnel ? largest(rho) : std::max(largest(r.min), largest(r.max));
            Rgb seen = radiance(p, back, level, share * weight);
            if (finish.reflection.exponent != 1.0)
                seen = glm::pow(seen, Rgb{1.0 / finish.reflection.exponent});
            light += rho * seen;
        }
        return light;
    }

    static double schlick_like(double x) {
        const double f = 0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903;
        return std::clamp(f, 0.0, 1.0);
    }
    static Rgb metallic_tint(double metallic, const Rgb& color, double cosine) {
        if (metallic == 0.0) return Rgb{1.0};
        const double x = std::acos(std::clamp(cosine, -1.0, 1.0)) / (std::acos(-1.0) / 2.0);
        return Rgb{1.0} + metallic * (1.0 - schlick_like(x)) * (color - Rgb{1.0});
    }

    Rgb reflectivity(const Surface<Real>& surface, const scene::Finish& finish, const Rgb& color,
                     double cosine) const {
        const scene::Reflection& r = finish.reflection;
        if (!r.is_active()) return Rgb{0.0};
        double share = 1.0;  // of `max`
        if (r.fresnel) {
            share = double(reflectance(ior(surface.before), ior(surface.after), Real(cosine)));
        } else if (r.falloff != 0.0) {
            share = std::pow(1.0 - cosine, r.falloff);
        }
        return ((1.0 - share) * r.min + share * r.max) * metallic_tint(r.metallic, color, cosine);
    }

    /// Diffuse light and highlights of one lamp.
    Rgb lit(const scene::Light& lamp, const scene::Finish& finish, const scene::Color& color,
            const V& p, const V& d, const V& n) const {
        if (lamp.kind != scene::Light::Kind::point || lamp.parallel)
            throw std::invalid_argument("the oracle knows point lights only");
        const V to_lamp = widen<Real>(lamp.position) - p;
        const Real distance = square_root(dot(to_lamp, to_lamp));
        const V l = (Real(1) / distance) * to_lamp;
        const double cosine = double(dot(n, l));
        if (cosine < 1e-10) return Rgb{0.0};
        const bool has_highlight =
            !lamp.shadowless && (finish.phong != 0.0 || finish.specular != 0.0);
        if (finish.diffuse * color.opacity() == 0.0 && !has_highlight) return Rgb{0.0};

        Rgb arriving = lamp.color;
        if (lamp.fade_distance > 0.0 && lamp.fade_power > 0.0) {
            arriving *=
                2.0 / (1.0 + std::pow(double(distance) / lamp.fade_distance, lamp.fade_power));
        }
        if (!lamp.shadowless) arriving *= visibility(p, l, distance);

        Rgb light = finish.diffuse * std::pow(cosine, finish.brilliance) * color.opacity() *
                    color.rgb * arriving;
        if (has_highlight) {
            const Rgb tint = metallic_tint(finish.metallic, color.rgb, cosine);
            const double phong = double(dot(mirrored(d, n), l));
            if (finish.phong != 0.0 && phong > 0.0)
                light += finish.phong * std::pow(phong, finish.phong_size) * tint * arriving;
            const double half = double(dot(n, unit(l - d)));
            if (finish.specular != 0.0 && half > 0.0)
                light += finish.specular * std::pow(half, 1.0 / finish.roughness) * tint * arriving;
        }
        return light;
    }

    /// What is left of a lamp's light on the straight way to it.
    Rgb visibility(V o, const V& d, Real distance) const {
        Rgb left{1.0};
        for (;;) {
            int start = nothing;
            const auto surface = world_.next(o, d, start, distance);
            const Real way = surface ? surface->t : distance;
            left *= transmittance(world_.medium(start), double(way));
            if (!surface) return left;
            o = o + surface->t * d;
            distance -= surface->t;
            const scene::Object& object = world_.scene().objects[surface->skin];
            const scene::Texture& texture = world_.scene().textures[object.texture];
            if (texture.clear) continue;
            const geom::Vec3 in_texture =
                texture.transform.inverse_linear() * (narrow(o) - texture.transform.shift());
            left *= color_at(texture.pigment, in_texture).transparency();
            if (left == Rgb{0.0}) return left;
        }
    }

    World<Real> world_;
    Limits limits_;
};

/// A whole picture: linear, three values a pixel, rows from the top.
template <class Real>
std::vector<scene::Rgb> picture(const scene::Scene& scene, int width, int height,
                                const Limits& limits) {
    const Tracer<Real> tracer(scene, limits);
    std::vector<scene::Rgb> result;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) result.push_back(tracer.pixel(x, y, width, height));
    }
    return result;
}

}  // namespace meniscus::oracle
