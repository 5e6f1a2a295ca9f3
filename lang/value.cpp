#include "lang/value.hpp"

namespace meniscus::lang {
namespace {

template <class... Cases>
struct overloaded : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
overloaded(Cases...) -> overloaded<Cases...>;  // clang 14 asks for it

}  // namespace

double Seed::next() {
    state = state * 1812433253u + 12345u;
    return static_cast<double>(state) / 4294967295.0;
}

std::string kind_of(const Value& value) {
    const overloaded names{
        [](std::monostate) { return "nothing"; },
        [](double) { return "a number"; },
        [](const Vector& v) { return v.is_color ? "a color" : "a vector"; },
        [](const std::string&) { return "a string"; },
        [](const Refusal&) { return "something unsupported"; },
        [](const std::shared_ptr<Seed>&) { return "a seed"; },
        [](const std::shared_ptr<ArrayValue>&) { return "an array"; },
        [](const Shared<MacroValue>&) { return "a macro"; },
        [](const Shared<PigmentItem>&) { return "a pigment"; },
        [](const Shared<FinishItem>&) { return "a finish"; },
        [](const Shared<NormalItem>&) { return "a normal"; },
        [](const Shared<TextureItem>&) { return "a texture"; },
        [](const Shared<MaterialItem>&) { return "a material"; },
        [](const Shared<InteriorItem>&) { return "an interior"; },
        [](const Shared<MapItem>&) { return "a color map"; },
        [](const Shared<TransformItem>&) { return "a transform"; },
        [](const Shared<ObjectItem>&) { return "an object"; },
        [](const Shared<CameraItem>&) { return "a camera"; },
        [](const Shared<SkyItem>&) { return "a sky_sphere"; },
    };
    return std::visit(names, value.data);
}

}  // namespace meniscus::lang
