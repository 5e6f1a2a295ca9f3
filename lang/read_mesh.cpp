#include "lang/read_mesh.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "lang/evaluate.hpp"
#include "lang/load_mesh.hpp"

namespace meniscus::lang {
namespace {

using geom::TriangleIndices;
using geom::TriangleSoup;
using geom::Vec3;

geom::Mesh build(const Session& session, TriangleSoup soup, const Span& span) {
    soup.is_numbered = session.options.number_triangles;
    if (soup.triangles.empty())
        throw SourceError(span,
                          "this mesh has no triangles; they follow as triangle { ... }, or stand "
                          "in a file: mesh { file \"NAME.obj\" }");
    try {
        return {std::make_shared<const geom::TriangleMesh>(std::move(soup))};
    } catch (const std::invalid_argument& error) {
        throw SourceError(span, error.what());
    }
}

/// Appends the corners of a triangle { } or smooth_triangle { }.
void read_triangle(Cursor& cursor, TriangleSoup& soup, const Span& span) {
    const bool smooth = cursor.block_word() == "smooth_triangle";
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    TriangleIndices normals{TriangleSoup::no_normal, TriangleSoup::no_normal,
                            TriangleSoup::no_normal};
    for (auto& normal : normals) {
        soup.positions.push_back(cursor.vector());
        if (!smooth) continue;
        normal = static_cast<std::uint32_t>(soup.normals.size());
        soup.normals.push_back(cursor.vector());
    }
    soup.triangles.push_back({first, first + 1, first + 2});
    soup.corner_normals.push_back(normals);
    if (!cursor.at_end()) {
        const auto* block = cursor.block();
        const bool textured = cursor.word() == "uv_vectors" || cursor.word() == "texture_list" ||
                              (block && block->word == "texture");
        if (!textured) cursor.fail_unknown();
        if (cursor.word() != "uv_vectors")
            throw refuse({"texture in a mesh's triangle", cursor.span(), {}});
        cursor.skip_rest();
    }
    (void)span;
}

MeshFile find_file(Cursor& cursor) {
    const auto span = cursor.span();
    auto& session = cursor.session();
    const auto name = cursor.string();
    if (!session.options.allow_files) throw FileError(span, "files cannot be read here");
    const auto found = session.library.find(name, Session::folder_of(span));
    if (!found)
        throw FileError(
            span, fmt::format("cannot find '{}' beside the scene or in the library paths", name));
    if (found->other_case)
        session.warn(span,
                     fmt::format("there is no '{}': taking '{}'", name, found->path.string()));
    return {name, found->path, span};
}

bool read_mesh_option(Cursor& cursor) {
    if (cursor.accept("inside_vector")) {
        cursor.vector();
    } else if (cursor.accept("hierarchy")) {
        cursor.flag_or_true();
    } else {
        return false;
    }
    return true;
}

std::size_t read_count(Cursor& cursor) {
    const auto span = cursor.span();
    const double count = cursor.number();
    if (!(count >= 0.0 && count < 4e9))
        throw SourceError(span, fmt::format("{} is no count", count));
    return static_cast<std::size_t>(count);
}

std::vector<Vec3> read_vectors(Cursor& cursor) {
    const auto count = read_count(cursor);
    std::vector<Vec3> list;
    for (std::size_t i = 0; i < count; ++i) list.push_back(cursor.vector());
    cursor.expect_end();
    return list;
}

std::vector<TriangleIndices> read_indices(Cursor& cursor, std::size_t size, std::string_view of) {
    const auto count = read_count(cursor);
    std::vector<TriangleIndices> list;
    for (std::size_t i = 0; i < count; ++i) {
        const auto span = cursor.span();
        const auto v = cursor.vector();
        TriangleIndices triangle{};
        for (int k = 0; k < 3; ++k) {
            const double index = v[k];
            if (!(index >= 0.0 && index < static_cast<double>(size))) {
                throw SourceError(span,
                                  fmt::format("index {} is outside the {} {}", index, size, of));
            }
            triangle[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(index);
        }
        list.push_back(triangle);
        while (cursor.expression() &&
               !std::holds_alternative<ast::Vector>(cursor.expression()->node)) {
            throw refuse({"texture_list", cursor.span(), {}});
        }
    }
    cursor.expect_end();
    return list;
}

}  // namespace

std::variant<geom::Shape, MeshFile> read_mesh(Cursor& cursor, const Span& span) {
    TriangleSoup soup;
    std::optional<MeshFile> from_file;
    while (!cursor.at_end()) {
        const auto at = cursor.span();
        const auto* block = cursor.block();
        if (block && (block->word == "triangle" || block->word == "smooth_triangle")) {
            Cursor inner(cursor.session(), *block, at);
            read_triangle(inner, soup, at);
            cursor.advance();
            cursor.accept_comma();
        } else if (cursor.accept("file")) {
            from_file = find_file(cursor);
        } else if (!read_mesh_option(cursor)) {
            break;
        }
    }
    if (from_file && !soup.triangles.empty())
        throw SourceError(
            span, "a mesh takes its triangles from a file or from the scene, not from both");
    if (from_file) return *from_file;
    return geom::Shape{build(cursor.session(), std::move(soup), span)};
}

geom::Mesh load_mesh_file(Session& session, const MeshFile& file) {
    if (const auto known = session.meshes.find(file.path); known != session.meshes.end())
        return known->second;
    try {
        const geom::Mesh mesh{load_mesh(file.path, session.options.number_triangles)};
        return session.meshes.emplace(file.path, mesh).first->second;
    } catch (const std::exception& error) {
        throw SourceError(
            file.span, fmt::format("cannot use the mesh file '{}': {}", file.name, error.what()));
    }
}

geom::Mesh read_mesh2(Cursor& cursor, const Span& span) {
    TriangleSoup soup;
    while (!cursor.at_end()) {
        const auto* block = cursor.block();
        if (!block) {
            if (read_mesh_option(cursor)) continue;
            break;
        }
        const auto at = cursor.span();
        Cursor inner(cursor.session(), *block, at);
        const auto word = block->word;
        if (word == "vertex_vectors") {
            soup.positions = read_vectors(inner);
        } else if (word == "normal_vectors") {
            soup.normals = read_vectors(inner);
        } else if (word == "face_indices") {
            soup.triangles = read_indices(inner, soup.positions.size(), "vertex_vectors");
        } else if (word == "normal_indices") {
            soup.corner_normals = read_indices(inner, soup.normals.size(), "normal_vectors");
        } else if (word == "uv_vectors" || word == "uv_indices") {
            inner.skip_rest();
        } else if (word == "texture_list") {
            throw refuse({"texture_list", block->word_span, {}});
        } else {
            break;
        }
        cursor.advance();
        cursor.accept_comma();
    }
    if (!soup.normals.empty() && soup.corner_normals.empty()) {
        if (soup.normals.size() < soup.positions.size()) {
            throw SourceError(span, fmt::format("this mesh has {} vertices but only {} normals",
                                                soup.positions.size(), soup.normals.size()));
        }
        soup.corner_normals =
            soup.triangles;  // without indices of their own, normals go with the vertices
    }
    if (!soup.corner_normals.empty() && soup.corner_normals.size() != soup.triangles.size()) {
        throw SourceError(span, fmt::format("this mesh has {} faces but {} normal_indices",
                                            soup.triangles.size(), soup.corner_normals.size()));
    }
    return build(cursor.session(), std::move(soup), span);
}

}  // namespace meniscus::lang
