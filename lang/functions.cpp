#include "lang/functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "geom/transform.hpp"
#include "lang/evaluate.hpp"

namespace meniscus::lang {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;

/// The arguments of a call under way, checked as they are asked for.
struct Call {
    Session& session;
    std::string_view name;
    const std::vector<Argument>& arguments;
    const Span& span;

    std::size_t count() const { return arguments.size(); }
    const Argument& at(std::size_t i) const { return arguments[i]; }
    double number(std::size_t i) const { return to_number(at(i).value, at(i).span); }
    const std::string& text(std::size_t i) const { return to_string(at(i).value, at(i).span); }
    geom::Vec3 vector(std::size_t i) const {
        const auto v = to_vector(at(i).value, at(i).span);
        return {v.at[0], v.size > 1 ? v.at[1] : 0.0, v.size > 2 ? v.at[2] : 0.0};
    }
    int integer(std::size_t i) const {
        const double value = number(i);
        if (!(std::abs(value) < 2e9))
            throw SourceError(at(i).span, fmt::format("{} is out of range", value));
        return static_cast<int>(value);
    }
};

Value from(const geom::Vec3& v) {
    Vector result;
    result.at = {v.x, v.y, v.z, 0.0, 0.0};
    return {result};
}

double checked(const Call& call, double value, double fallback, const char* where) {
    if (!std::isnan(value)) return value;
    call.session.warn(call.span, fmt::format("{}() has no value {}", call.name, where));
    return fallback;
}

std::string format_number(double value, int length, int precision) {
    if (precision < 0) precision = 6;
    precision = std::min(precision, 60);
    length = std::clamp(length, -200, 200);
    return length < 0 ? fmt::format("{:0{}.{}f}", value, -length, precision)
                      : fmt::format("{:{}.{}f}", value, length, precision);
}

std::string checked_length(const Call& call, std::string text) {
    if (text.size() > call.session.options.limits.string_bytes)
        throw SourceError(call.span, "the string grows too long");
    return text;
}

Value vstr(const Call& call) {
    const int count = std::clamp(call.integer(0), 2, 5);
    const auto v = to_vector(call.at(1).value, call.at(1).span);
    std::string text;
    for (int i = 0; i < count; ++i) {
        if (i > 0) text += call.text(2);
        text += format_number(v.at[static_cast<std::size_t>(i)], call.integer(3), call.integer(4));
    }
    return {checked_length(call, text)};
}

Value concat(const Call& call) {
    std::string text;
    for (std::size_t i = 0; i < call.count(); ++i) text += call.text(i);
    return {checked_length(call, text)};
}

Value substr(const Call& call) {
    const auto& text = call.text(0);
    const int first = call.integer(1), count = call.integer(2);
    if (first < 1 || count < 0 ||
        static_cast<std::size_t>(first) - 1 + static_cast<std::size_t>(count) > text.size()) {
        throw SourceError(
            call.span, fmt::format("substr() asks for characters {} to {} of a string of {}", first,
                                   first + count - 1, text.size()));
    }
    return {text.substr(static_cast<std::size_t>(first - 1), static_cast<std::size_t>(count))};
}

/// Of the first bytes that differ, 0 if there are none.
double difference(const std::string& a, const std::string& b) {
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
        const int ca = i < a.size() ? static_cast<unsigned char>(a[i]) : 0;
        const int cb = i < b.size() ? static_cast<unsigned char>(b[i]) : 0;
        if (ca != cb) return ca - cb;
    }
    return 0.0;
}

template <class Map>
Value map_text(const Call& call, Map map) {
    auto text = call.text(0);
    std::ranges::transform(text, text.begin(),
                           [&](unsigned char c) { return static_cast<char>(map(c)); });
    return {text};
}

Value chr(const Call& call) {
    const int code = call.integer(0);
    if (code < 0 || code > 255) throw SourceError(call.span, "chr() takes 0 to 255");
    return {code == 0 ? std::string{} : std::string(1, static_cast<char>(code))};
}

Value val(const Call& call) {
    const auto& text = call.text(0);
    return {std::strtod(text.c_str(), nullptr)};
}

const ArrayValue& array(const Call& call) {
    const auto* found = call.at(0).value.get<std::shared_ptr<ArrayValue>>();
    if (!found)
        throw SourceError(call.at(0).span,
                          fmt::format("expected an array, found {}", kind_of(call.at(0).value)));
    return **found;
}

Value dimension_size(const Call& call) {
    const auto& sizes = array(call).sizes;
    const int which = call.integer(1);
    if (which < 1 || static_cast<std::size_t>(which) > sizes.size()) {
        throw SourceError(call.at(1).span,
                          fmt::format("the array has {} dimensions", sizes.size()));
    }
    return {static_cast<double>(sizes[static_cast<std::size_t>(which - 1)])};
}

Value make_seed(const Call& call) {
    const double value = std::trunc(call.number(0));
    const double wrapped = std::isfinite(value) ? std::fmod(value, 4294967296.0) : 0.0;
    auto seed = std::make_shared<Seed>();
    seed->state = static_cast<std::uint32_t>(static_cast<std::int64_t>(wrapped));
    return {std::move(seed)};
}

Value rand(const Call& call) {
    const auto* seed = call.at(0).value.get<std::shared_ptr<Seed>>();
    if (!seed)
        throw SourceError(call.at(0).span, fmt::format("rand() needs a seed(), found {}",
                                                       kind_of(call.at(0).value)));
    return {(*seed)->next()};
}

Value vnormalize(const Call& call) {
    const auto v = call.vector(0);
    const double length = glm::length(v);
    if (length == 0.0) {
        call.session.warn(call.span, "vnormalize() of the zero vector");
        return from(v);
    }
    return from(v / length);
}

Value vaxis_rotate(const Call& call) {
    const auto v = call.vector(0);
    const auto axis = call.vector(1);
    const double length = glm::length(axis), angle = call.number(2) * radians_per_degree;
    if (length == 0.0) return from(v);
    const auto k = axis / length;
    // Rodrigues: positive angles turn x to y about z
    return from(v * std::cos(angle) + glm::cross(k, v) * std::sin(angle) +
                k * glm::dot(k, v) * (1.0 - std::cos(angle)));
}

double int_division(double a, double b) { return std::trunc(a / b); }

template <class Fold>
Value fold(const Call& call, Fold f) {
    double result = call.number(0);
    for (std::size_t i = 1; i < call.count(); ++i) result = f(result, call.number(i));
    return {result};
}

Value bits(const Call& call, std::int64_t (*f)(std::int64_t, std::int64_t)) {
    std::int64_t result = call.integer(0);
    for (std::size_t i = 1; i < call.count(); ++i) result = f(result, call.integer(i));
    return {static_cast<double>(result)};
}

Value unsupported(const Call& call) { return {Refusal{std::string(call.name), call.span, {}}}; }

struct Function {
    std::size_t fewest, most;
    Value (*call)(const Call&);
};

template <double (*f)(double)>
Value real(const Call& call) {
    return {f(call.number(0))};
}

constexpr std::size_t any_number = 1000;

const std::unordered_map<std::string_view, Function>& table() {
    using C = const Call&;
    // clang-format off
    static const std::unordered_map<std::string_view, Function> functions{
        {"abs", {1, 1, [](C c) -> Value { return {std::abs(c.number(0))}; }}},
        {"acos", {1, 1, [](C c) -> Value { const double v = c.number(0); return {checked(c, std::acos(v), v < 0 ? std::numbers::pi : 0.0, "outside -1 to 1")}; }}},
        {"acosh", {1, 1, [](C c) -> Value { return {checked(c, std::acosh(c.number(0)), 0.0, "below 1")}; }}},
        {"asc", {1, 1, [](C c) -> Value { const auto& t = c.text(0); return {t.empty() ? 0.0 : static_cast<double>(static_cast<unsigned char>(t[0]))}; }}},
        {"asin", {1, 1, [](C c) -> Value { const double v = c.number(0); return {checked(c, std::asin(v), v < 0 ? -std::numbers::pi / 2 : std::numbers::pi / 2, "outside -1 to 1")}; }}},
        {"asinh", {1, 1, real<std::asinh>}},
        {"atan", {1, 1, real<std::atan>}},
        {"atan2", {2, 2, [](C c) -> Value { return {std::atan2(c.number(0), c.number(1))}; }}},
        {"atanh", {1, 1, [](C c) -> Value { return {checked(c, std::atanh(c.number(0)), 0.0, "outside -1 to 1")}; }}},
        {"bitwise_and", {1, any_number, [](C c) { return bits(c, [](std::int64_t a, std::int64_t b) { return a & b; }); }}},
        {"bitwise_or", {1, any_number, [](C c) { return bits(c, [](std::int64_t a, std::int64_t b) { return a | b; }); }}},
        {"bitwise_xor", {1, any_number, [](C c) { return bits(c, [](std::int64_t a, std::int64_t b) { return a ^ b; }); }}},
        {"ceil", {1, 1, real<std::ceil>}},
        {"chr", {1, 1, chr}},
        {"concat", {1, any_number, concat}},
        {"cos", {1, 1, real<std::cos>}},
        {"cosh", {1, 1, real<std::cosh>}},
        {"datetime", {1, 2, unsupported}},
        {"degrees", {1, 1, [](C c) -> Value { return {c.number(0) / radians_per_degree}; }}},
        {"dimension_size", {2, 2, dimension_size}},
        {"dimensions", {1, 1, [](C c) -> Value { return {static_cast<double>(array(c).sizes.size())}; }}},
        {"div", {2, 2, [](C c) -> Value { return {int_division(c.number(0), c.number(1))}; }}},
        {"exp", {1, 1, real<std::exp>}},
        {"file_exists", {1, 1, [](C c) -> Value {
            return {c.session.options.allow_files && c.session.library.find(c.text(0), Session::folder_of(c.span)) ? 1.0 : 0.0}; }}},
        {"floor", {1, 1, real<std::floor>}},
        {"inside", {2, 2, unsupported}},
        {"int", {1, 1, real<std::trunc>}},
        {"ln", {1, 1, [](C c) -> Value { return {checked(c, std::log(c.number(0)), 0.0, "below 0")}; }}},
        {"log", {1, 1, [](C c) -> Value { return {checked(c, std::log10(c.number(0)), 0.0, "below 0")}; }}},
        {"max", {1, any_number, [](C c) { return fold(c, [](double a, double b) { return std::max(a, b); }); }}},
        {"max_extent", {1, 1, unsupported}},
        {"min", {1, any_number, [](C c) { return fold(c, [](double a, double b) { return std::min(a, b); }); }}},
        {"min_extent", {1, 1, unsupported}},
        {"mod", {2, 2, [](C c) -> Value { return {checked(c, std::fmod(c.number(0), c.number(1)), 0.0, "for a divisor of 0")}; }}},
        {"pow", {2, 2, [](C c) -> Value { return {checked(c, std::pow(c.number(0), c.number(1)), 0.0, "for a negative number and a fraction")}; }}},
        {"radians", {1, 1, [](C c) -> Value { return {c.number(0) * radians_per_degree}; }}},
        {"rand", {1, 1, rand}},
        {"seed", {1, 1, make_seed}},
        {"select", {3, 4, [](C c) -> Value {
            const double v = c.number(0);
            return {c.number(v < 0 ? 1 : c.count() == 3 || v == 0 ? 2 : 3)}; }}},
        {"sin", {1, 1, real<std::sin>}},
        {"sinh", {1, 1, real<std::sinh>}},
        {"sqrt", {1, 1, [](C c) -> Value { return {checked(c, std::sqrt(c.number(0)), 0.0, "below 0")}; }}},
        {"str", {3, 3, [](C c) -> Value { return {format_number(c.number(0), c.integer(1), c.integer(2))}; }}},
        {"strcmp", {2, 2, [](C c) -> Value { return {difference(c.text(0), c.text(1))}; }}},
        {"strlen", {1, 1, [](C c) -> Value { return {static_cast<double>(c.text(0).size())}; }}},
        {"strlwr", {1, 1, [](C c) { return map_text(c, [](int ch) { return std::tolower(ch); }); }}},
        {"strupr", {1, 1, [](C c) { return map_text(c, [](int ch) { return std::toupper(ch); }); }}},
        {"substr", {3, 3, substr}},
        {"tan", {1, 1, real<std::tan>}},
        {"tanh", {1, 1, real<std::tanh>}},
        {"trace", {3, 4, unsupported}},
        {"val", {1, 1, val}},
        {"vaxis_rotate", {3, 3, vaxis_rotate}},
        {"vcross", {2, 2, [](C c) { return from(glm::cross(c.vector(0), c.vector(1))); }}},
        {"vdot", {2, 2, [](C c) -> Value { return {glm::dot(c.vector(0), c.vector(1))}; }}},
        {"vlength", {1, 1, [](C c) -> Value { return {glm::length(c.vector(0))}; }}},
        {"vnormalize", {1, 1, vnormalize}},
        {"vrotate", {2, 2, [](C c) { return from(geom::Transform::rotation_degrees(c.vector(1)).point(c.vector(0))); }}},
        {"vstr", {5, 5, vstr}},
        {"vturbulence", {4, 4, unsupported}},
    };
    // clang-format on
    return functions;
}

}  // namespace

Value call_function(Session& session, std::string_view name, const std::vector<Argument>& arguments,
                    const Span& span) {
    const auto found = table().find(name);
    if (found == table().end()) return {Refusal{std::string(name), span, {}}};
    const auto& function = found->second;
    if (arguments.size() < function.fewest || arguments.size() > function.most) {
        throw SourceError(
            span, fmt::format("{}() takes {} argument{}, not {}", name,
                              function.fewest == function.most ? fmt::format("{}", function.fewest)
                              : function.most == any_number
                                  ? fmt::format("at least {}", function.fewest)
                                  : fmt::format("{} or {}", function.fewest, function.most),
                              function.most == 1 ? "" : "s", arguments.size()));
    }
    return function.call(Call{session, name, arguments, span});
}

}  // namespace meniscus::lang
