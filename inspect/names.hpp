#pragma once

#include <string>
#include <vector>

#include "tracer/render_scene.hpp"

namespace meniscus::inspect {

/// What to call solids and objects, so that no two of them are called alike: "Glass", or, where
/// several have that name, "sphere@12" by the line, or "sphere@12#3" where a loop made several
/// there.
class Names {
public:
    explicit Names(const scene::Scene& scene);

    /// `solid` may be tracer::outside.
    const std::string& solid(int solid) const;
    const std::string& object(int object) const { return objects_[std::size_t(object)]; }
    /// "Glass (priority 3)".
    std::string with_priority(int solid) const;

private:
    const scene::Scene& scene_;
    std::vector<std::string> solids_, objects_;
};

/// "glass.scene:12", or nothing where no text said so.
std::string place(const scene::Location& location);

/// "<0, 1, -0.5>", with so many digits that a reader can go there.
std::string text(const geom::Vec3& v);
/// "0.96" where all channels agree, else as a vector.
std::string text_of_color(const scene::Rgb& color);
std::string text(double number);

}  // namespace meniscus::inspect
