#include "grammar/words.hpp"

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace meniscus::grammar {
namespace {

// clang-format off
constexpr std::string_view plain_words[] = {
    "aa_level", "aa_threshold", "absorption", "accuracy", "adaptive", "adc_bailout", "agate",
    "agate_turb", "albedo", "all", "all_intersections", "altitude", "always_sample", "ambient",
    "ambient_light", "angle", "anisotropy", "aoi", "aperture", "append", "arc_angle",
    "area_illumination", "area_light", "array", "ascii", "assumed_gamma", "autostop", "average",
    "b_spline", "background", "bezier_spline", "bicubic_patch", "black_hole", "blob",
    "blur_samples", "bokeh", "bounded_by", "box", "boxed", "bozo", "break", "brick", "brick_size",
    "brightness", "brilliance", "bump_map", "bump_size", "bumps", "camera", "case", "caustics",
    "cells", "charset", "checker", "circular", "clipped_by", "collect", "color_map", "colour_map",
    "component", "composite", "cone", "confidence", "conic_sweep", "conserve_energy",
    "contact_tolerance", "contained_by", "control0", "control1", "coords", "count", "crackle",
    "crand", "cube", "cubic", "cubic_spline", "cubic_wave", "cutaway_textures", "cylinder",
    "cylindrical", "debug", "declare", "default", "density", "density_file", "density_map",
    "dents", "deprecated", "df3", "difference", "diffuse", "direction", "disc", "dispersion",
    "dispersion_samples", "dist_exp", "distance", "double_illuminate", "eccentricity", "else",
    "elseif", "emission", "end", "error", "error_bound", "evaluate", "expand_thresholds",
    "exponent", "exterior", "extinction", "face_indices", "facets", "fade_color", "fade_colour",
    "fade_distance", "fade_power", "falloff", "falloff_angle", "fclose", "file", "finish",
    "fisheye", "flatness", "flip", "focal_point", "fog", "fog_alt", "fog_offset", "fog_type",
    "fopen", "for", "form", "frequency", "fresnel", "function", "gather", "gif", "global_lights",
    "global_settings", "gradient", "granite", "gray_threshold", "height_field", "hexagon",
    "hf_gray_16", "hierarchy", "hollow", "hypercomplex", "if", "ifdef", "iff", "ifndef",
    "image_map", "image_pattern", "importance", "include", "inside_vector", "interior",
    "interior_texture", "internal", "interpolate", "intersection", "intervals", "inverse", "ior",
    "irid", "irid_wavelength", "isosurface", "jitter", "jpeg", "julia", "julia_fractal", "lambda",
    "lathe", "lattice", "leopard", "light_group", "light_source", "linear_spline", "linear_sweep",
    "load_file", "local", "location", "look_at", "looks_like", "low_error_factor", "macro",
    "magnet", "major_radius", "mandel", "map_type", "marble", "material", "material_map",
    "matrix", "max_gradient", "max_intersections", "max_iteration", "max_sample", "max_trace",
    "max_trace_level", "maximum_reuse", "media", "media_attenuation", "media_interaction",
    "merge", "mesh", "mesh2", "mesh_camera", "metallic", "method", "metric", "minimum_reuse",
    "mm_per_unit", "mortar", "natural_spline", "nearest_count", "no_bump_scale", "no_image",
    "no_radiosity", "no_reflection", "no_shadow", "noise_generator", "normal", "normal_indices",
    "normal_map", "normal_vectors", "number_of_waves", "object", "octaves", "offset", "omega",
    "omnimax", "once", "onion", "open", "orient", "orientation", "orthographic", "ovus",
    "panoramic", "parallel", "parametric", "pass_through", "pattern", "perspective", "pgm",
    "phase", "phong", "phong_size", "photons", "pigment", "pigment_map", "pigment_pattern",
    "planar", "plane", "png", "point_at", "poly", "poly_wave", "polygon", "polynomial", "pot",
    "ppm", "precision", "precompute", "premultiplied", "pretrace_end", "pretrace_start",
    "priority", "prism", "projected_through", "pwr", "quadratic_spline", "quadric", "quartic",
    "quaternion", "quick_color", "quick_colour", "quilted", "radial", "radiosity", "radius",
    "rainbow", "ramp_wave", "range", "ratio", "read", "reciprocal", "recursion_limit",
    "reflection", "reflection_exponent", "refraction", "render", "repeat", "right", "ripples",
    "rotate", "roughness", "samples", "save_file", "scale", "scallop_wave", "scattering",
    "shadowless", "sine_wave", "sint16be", "sint16le", "sint32be", "sint32le", "sint8", "size",
    "sky", "sky_sphere", "slice", "slope", "slope_map", "smooth", "smooth_triangle", "solid",
    "sor", "spacing", "specular", "sphere", "sphere_sweep", "spherical", "spiral1", "spiral2",
    "spline", "split_union", "spotlight", "spotted", "sqr", "square", "statistics", "strength",
    "sturm", "subsurface", "sum", "superellipsoid", "switch", "sys", "target", "text", "texture",
    "texture_list", "texture_map", "tga", "thickness", "threshold", "tiff", "tightness", "tile2",
    "tiles", "tiling", "tolerance", "toroidal", "torus", "transform", "translate", "translucency",
    "triangle", "triangle_wave", "triangular", "ttf", "turb_depth", "turbulence", "type",
    "u_steps", "uint16be", "uint16le", "uint8", "ultra_wide_angle", "undef", "union",
    "unofficial", "up", "use_alpha", "use_color", "use_colour", "use_index", "utf8", "uv_indices",
    "uv_mapping", "uv_vectors", "v_steps", "variance", "vertex_vectors", "warning", "warp",
    "water_level", "waves", "while", "width", "wood", "wrinkles", "write"};
// clang-format on

// clang-format off
constexpr std::string_view color_words[] = {
    "alpha", "blue", "color", "colour", "filter", "gray", "green", "red", "rgb", "rgbf", "rgbft",
    "rgbt", "srgb", "srgbf", "srgbft", "srgbt", "transmit"};
// clang-format on

// clang-format off
constexpr std::string_view constants[] = {
    "clock", "clock_delta", "clock_on", "false", "final_frame", "frame_number", "image_height",
    "image_width", "initial_frame", "no", "now", "off", "on", "pi", "t", "true", "u", "v",
    "version", "x", "y", "yes", "z"};
// clang-format on

// clang-format off
constexpr std::string_view functions[] = {
    "atan2", "bitwise_and", "bitwise_or", "bitwise_xor", "concat", "datetime", "defined",
    "dimension_size", "div", "inside", "max", "max_extent", "min", "min_extent", "mod", "pow",
    "prod", "select", "str", "strcmp", "substr", "trace", "vaxis_rotate", "vcross", "vdot",
    "vrotate", "vstr", "vturbulence"};
// clang-format on

// clang-format off
constexpr std::string_view functions_of_one[] = {
    "abs", "acos", "acosh", "asc", "asin", "asinh", "atan", "atanh", "ceil", "chr", "cos", "cosh",
    "degrees", "dimensions", "exp", "file_exists", "floor", "int", "ln", "log", "radians", "rand",
    "seed", "sin", "sinh", "sqrt", "strlen", "strlwr", "strupr", "tan", "tanh", "val", "vlength",
    "vnormalize"};
// clang-format on

const auto& table() {
    static const auto words = [] {
        std::unordered_map<std::string_view, WordClass> all;
        for (const auto word : plain_words) all.emplace(word, WordClass::plain);
        for (const auto word : color_words) all.emplace(word, WordClass::color);
        for (const auto word : constants) all.emplace(word, WordClass::constant);
        for (const auto word : functions) all.emplace(word, WordClass::function);
        for (const auto word : functions_of_one) all.emplace(word, WordClass::function_of_one);
        return all;
    }();
    return words;
}

}  // namespace

WordClass classify(std::string_view word) {
    const auto found = table().find(word);
    return found == table().end() ? WordClass::name : found->second;
}

std::span<const std::string_view> reserved_words() {
    static const auto sorted = [] {
        std::vector<std::string_view> words;
        for (const auto& entry : table()) words.push_back(entry.first);
        std::ranges::sort(words);
        return words;
    }();
    return sorted;
}

}  // namespace meniscus::grammar
