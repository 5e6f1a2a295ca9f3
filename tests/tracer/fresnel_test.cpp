#include "tracer/fresnel.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace meniscus;
using tracer::fresnel_reflectance;

TEST_CASE("at normal incidence the reflectance is ((n1 - n2) / (n1 + n2))^2", "[tracer]") {
    for (const double n : {1.0, 1.31, 1.5, 2.4}) {
        const double r = (n - 1.0) / (n + 1.0);
        CHECK_THAT(fresnel_reflectance(1.0 / n, 1.0), Catch::WithinAbs(r * r, 1e-16));
        CHECK_THAT(fresnel_reflectance(n, 1.0), Catch::WithinAbs(r * r, 1e-16));
    }
}

TEST_CASE("at Brewster's angle only the perpendicular half is reflected", "[tracer]") {
    const double n = 1.5, cosine = std::cos(std::atan(n));
    const double s = (1.0 - n * n) / (1.0 + n * n);  // r_s at tan(angle) = n
    CHECK_THAT(fresnel_reflectance(1.0 / n, cosine), Catch::WithinAbs(0.5 * s * s, 1e-15));
}

TEST_CASE("at grazing incidence and beyond the critical angle everything is reflected",
          "[tracer]") {
    CHECK_THAT(fresnel_reflectance(1.0 / 1.5, 0.0), Catch::WithinAbs(1.0, 1e-15));
    const double critical = std::asin(1.0 / 1.5);
    CHECK(fresnel_reflectance(1.5, std::cos(critical + 1e-6)) == 1.0);
    CHECK(fresnel_reflectance(1.5, std::cos(critical - 1e-3)) < 1.0);
}

TEST_CASE("reflectance is the same for the light path reversed", "[tracer]") {
    for (double angle = 0.0; angle < 1.5; angle += 0.1) {
        const double inner = std::asin(std::sin(angle) / 1.7);
        CHECK_THAT(fresnel_reflectance(1.0 / 1.7, std::cos(angle)),
                   Catch::WithinAbs(fresnel_reflectance(1.7, std::cos(inner)), 1e-14));
    }
}

TEST_CASE("refraction obeys Snell's law and stays in the plane of incidence", "[tracer]") {
    const geom::Vec3 normal{0.0, 1.0, 0.0};
    for (double angle = 0.05; angle < 1.5; angle += 0.1) {
        const geom::Vec3 d{std::sin(angle), -std::cos(angle), 0.0};
        const auto t = tracer::refract(d, normal, 1.0 / 1.33);
        REQUIRE(t);
        CHECK_THAT(1.33 * t->x, Catch::WithinAbs(std::sin(angle), 1e-15));
        CHECK(t->z == 0.0);
        CHECK_THAT(glm::length(*t), Catch::WithinAbs(1.0, 1e-15));
    }
    CHECK_FALSE(tracer::refract({std::sin(1.0), -std::cos(1.0), 0.0}, normal, 1.5));
}
