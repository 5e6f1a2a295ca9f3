#include "povray/write_bodies.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "povray/coincidence.hpp"
#include "povray/exactness.hpp"
#include "povray/grow.hpp"
#include "povray/plan.hpp"
#include "povray/region.hpp"
#include "povray/scale.hpp"
#include "povray/write_interior.hpp"
#include "povray/write_shape.hpp"
#include "povray/write_texture.hpp"

namespace meniscus::povray {
namespace {

using tracer::Part;

class BodyWriter {
public:
    BodyWriter(Writer& writer, const tracer::RenderScene& scene, Model model, double hair,
               double sliver)
        : writer_(writer),
          scene_(scene),
          model_(model),
          hair_(hair),
          sliver_(sliver),
          plan_(model == Model::plain ? make_plain_plan(scene) : make_plan(scene)) {}

    void write() {
        if (model_ != Model::plain) require_exact(scene_, plan_);
        warnings_ = doubts(scene_, plan_);
        for (const Body& body : plan_.bodies) {
            cutters_.push_back(
                body.is_outside ? std::vector<Cutter>{}
                                : cutters(scene_, plan_, body, model_, hair_, sliver_, warnings_));
        }
        name_textures();
        for (const int part : plan_.plain_parts) write_plain(part);
        if (model_ == Model::contact) {
            for (const Body& body : plan_.bodies) {
                if (!body.is_outside && needs_name(body)) declare(body);
            }
        }
        for (const Body& body : plan_.bodies) {
            if (!body.is_outside || model_ == Model::plain) write_body(body);
        }
    }

    /// What the reader of what was written should know.
    const std::vector<std::string>& warnings() const { return warnings_; }

private:
    const scene::Object& object(int part) const {
        return scene_.source.objects[std::size_t(scene_.parts[std::size_t(part)].object)];
    }
    const scene::Solid& solid(const Body& body) const {
        return scene_.source.solids[std::size_t(body.solid)];
    }
    const std::vector<Cutter>& cutters_of(const Body& body) const {
        return cutters_[std::size_t(&body - plan_.bodies.data())];
    }
    const Body& body(int index) const { return plan_.bodies[std::size_t(index)]; }

    /// A texture that is used more than once gets a name.
    void name_textures() {
        std::set<std::size_t> used;
        for (const auto& object : scene_.source.objects) used.insert(object.texture);
        bool needs_clear = model_ == Model::gap;
        int count = 0;
        for (const std::size_t index : used) {
            const auto& texture = scene_.source.textures[index];
            needs_clear = needs_clear || texture.clear;
            if (!texture.clear) texture_names_[index] = fmt::format("Texture_{}", ++count);
        }
        if (needs_clear) declare_texture("Clear", scene::Texture::clear_skin());
        if (model_ == Model::contact) {
            scene::Texture silent;
            silent.pigment.pattern = scene::SolidColor{{scene::Rgb{1.0}, 0.0, 1.0}};
            silent.finish.ambient = scene::Rgb{0.0};
            silent.finish.diffuse = 0.0;
            declare_texture("Silent", silent);
        }
        for (const auto& [index, name] : texture_names_)
            declare_texture(name, scene_.source.textures[index]);
    }

    void declare_texture(const std::string& name, const scene::Texture& texture) {
        writer_.blank();
        writer_.line("#declare {} =", name);
        write_texture(writer_, texture);
    }

    std::string texture_name(std::size_t index) const {
        const auto found = texture_names_.find(index);
        return found == texture_names_.end() ? "Clear" : found->second;
    }

    void write_heading(const std::string& name, const scene::Location& location,
                       const std::string& more) {
        const auto slash = location.file.rfind('/');
        const auto file =
            slash == location.file.npos ? location.file : location.file.substr(slash + 1);
        writer_.blank();
        writer_.line("// {}{}{}", name,
                     location.line > 0 ? fmt::format(" ({}:{})", file, location.line) : "", more);
    }

    static std::vector<std::string> flags(const Part& part) {
        std::vector<std::string> words;
        if (part.no_shadow) words.emplace_back("no_shadow");
        if (part.no_image) words.emplace_back("no_image");
        if (part.no_reflection) words.emplace_back("no_reflection");
        if (part.double_illuminate) words.emplace_back("double_illuminate");
        return words;
    }

    /// What is no dielectric: as declared; but the camera must not be inside, or POV-Ray takes it
    /// for the medium there.
    void write_plain(int index) {
        const Part& part = scene_.parts[std::size_t(index)];
        auto it = object(index);
        if (part.shape.is_closed() && !std::holds_alternative<geom::Mesh>(it.shape) &&
            part.shape.contains(scene_.source.camera.location) != it.inverse)
            it.inverse = !it.inverse;
        auto words = flags(part);
        words.insert(words.begin(), fmt::format("texture {{ {} }}", texture_name(it.texture)));
        write_heading(it.name, it.location, "");
        write_shape(writer_, it, words);
    }

    /// Whether faces of several textures make up the body's surface.
    bool is_many_textured(const Body& body, const std::vector<Cutter>& cutters) const {
        const auto name = texture_name(object(body.parts.front()).texture);
        return std::ranges::any_of(
                   body.parts,
                   [&](int part) { return texture_name(object(part).texture) != name; }) ||
               std::ranges::any_of(cutters, [&](const Cutter& cutter) {
                   return texture_name(cutter.texture) != name;
               });
    }

    /// The words for a texture on a face of the body: within other solids it says nothing.
    std::vector<std::string> skin(const Body& body, const std::string& texture) const {
        std::vector<std::string> words{fmt::format("texture {{ {} }}", texture)};
        if (model_ != Model::contact) return words;
        std::vector<std::string> others;
        for (const auto* list : {&body.higher, &body.lower}) {
            for (const int other : *list) {
                if (!this->body(other).is_outside) others.push_back(this->body(other).name);
            }
        }
        if (others.empty()) return words;
        std::string around;
        if (others.size() == 1) {
            around = others.front();
        } else {
            around = "union {";
            for (const auto& other : others) around += fmt::format(" object {{ {} }}", other);
            around += " }";
        }
        words.push_back(fmt::format(
            "interior_texture {{ object {{ {} texture {{ {} }} texture {{ Silent }} }} }}", around,
            texture));
        return words;
    }

    /// POV-Ray asks for the media at the camera only what has it in its bounds, and those of a
    /// complement are the shape's: a plane that no ray reaches takes them away.
    void write_part(const scene::Object& part, std::vector<std::string> skin,
                    const std::vector<std::string>& words) {
        const geom::PlacedShape placed(part.shape, part.transform);
        const auto& camera = scene_.source.camera.location;
        if (!part.inverse || !placed.bounds().is_finite() || placed.contains(camera)) {
            skin.insert(skin.end(), words.begin(), words.end());
            return write_shape(writer_, part, skin);
        }
        writer_.open("intersection");
        writer_.line("plane {{ y, {} }}  // never met: it leaves the complement without bounds",
                     number(100.0 * farthest));
        write_shape(writer_, part, skin);
        for (const auto& word : words) writer_.line("{}", word);
        writer_.close();
    }

    void write_cutter(const Cutter& cutter, const std::vector<std::string>& words) {
        if (!cutter.within) return write_shape(writer_, cutter.object, words);
        writer_.line("// only next to {}", cutter.within->name);
        writer_.open("intersection");
        write_shape(writer_, cutter.object, {});
        write_shape(writer_, *cutter.within, {});
        for (const auto& word : words) writer_.line("{}", word);
        writer_.close();
    }

    /// The body's region: its parts, larger by a hair where it reaches into others, minus what is
    /// above.
    void write_region(const Body& body, const std::vector<Cutter>& cutters, bool with_skins,
                      const std::vector<std::string>& words) {
        const double distance = growth(plan_, body, model_, hair_);
        std::vector<scene::Object> parts;
        const auto apart = growth_apart(scene_, body.parts, sliver_);
        for (std::size_t i = 0; i < apart.size(); ++i)
            parts.push_back(grown(object(body.parts[i]), distance + apart[i]));
        const auto child_words = [&](std::size_t texture) {
            return with_skins ? skin(body, texture_name(texture)) : std::vector<std::string>{};
        };
        const auto write_cutters = [&](std::optional<int> from) {
            for (const auto& cutter : cutters) {
                if (parts.size() > 1 && cutter.from != from) continue;
                if (cutter.object.name != object(body.parts.front()).name)
                    writer_.line("// minus {}", cutter.object.name);
                write_cutter(cutter, child_words(cutter.texture));
            }
        };
        const auto is_cut = [&](std::optional<int> from) {
            return std::ranges::any_of(cutters, [&](const Cutter& c) { return c.from == from; });
        };
        const auto write_parts = [&](const std::vector<std::string>& last) {
            if (parts.size() == 1) {
                return write_part(parts.front(), child_words(parts.front().texture), last);
            }
            writer_.open("merge");
            for (std::size_t i = 0; i < parts.size(); ++i) {
                const auto skins = child_words(parts[i].texture);
                if (!is_cut(body.parts[i])) {
                    write_part(parts[i], skins, {});
                    continue;
                }
                writer_.open("difference");
                write_part(parts[i], skins, {});
                write_cutters(body.parts[i]);
                writer_.close();
            }
            for (const auto& line : last) writer_.line("{}", line);
            writer_.close();
        };
        const bool all_of_parts = parts.size() > 1 && !is_cut(std::nullopt);
        if (cutters.empty() || all_of_parts) return write_parts(words);
        writer_.open("difference");
        write_parts({});
        write_cutters(std::nullopt);
        for (const auto& line : words) writer_.line("{}", line);
        writer_.close();
    }

    bool needs_name(const Body& body) const {
        const auto is_exported = [&](int other) { return !this->body(other).is_outside; };
        return std::ranges::any_of(body.higher, is_exported) ||
               std::ranges::any_of(body.lower, is_exported);
    }

    void declare(const Body& body) {
        write_heading(body.name, solid(body).location, ", its region");
        writer_.line("#declare {} =", body.name);
        write_region(body, cutters_of(body), false, {});
    }

    void write_body(const Body& body) {
        const auto& it = solid(body);
        write_heading(body.name, it.location,
                      fmt::format(", priority {}", number(it.interior.priority)));
        const auto& cut = cutters_of(body);
        const bool many = is_many_textured(body, cut);
        std::vector<std::string> words;
        if (!many) words = skin(body, texture_name(object(body.parts.front()).texture));
        words.push_back(interior(it, scene_.source.settings.outside, model_));
        words.emplace_back("hollow");
        const auto more = flags(scene_.parts[std::size_t(body.parts.front())]);
        words.insert(words.end(), more.begin(), more.end());
        if (model_ == Model::contact && needs_name(body) && !many) {
            writer_.open("object");
            writer_.line("{}", body.name);
            for (const auto& line : words) writer_.line("{}", line);
            writer_.close();
        } else {
            write_region(body, cut, many, words);
        }
    }

    Writer& writer_;
    const tracer::RenderScene& scene_;
    Model model_;
    double hair_, sliver_;
    Plan plan_;
    std::vector<std::vector<Cutter>> cutters_;  // of each body
    std::vector<std::string> warnings_;
    std::map<std::size_t, std::string> texture_names_;
};

}  // namespace

std::vector<std::string> write_bodies(Writer& writer, const tracer::RenderScene& scene, Model model,
                                      double hair, double sliver) {
    BodyWriter bodies(writer, scene, model, hair, sliver);
    bodies.write();
    return bodies.warnings();
}

}  // namespace meniscus::povray
