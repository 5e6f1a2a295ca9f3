#include "tests/geom/mesh_parity.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "geom/mesh.hpp"
#include "geom/placed_shape.hpp"
#include "tests/geom/lines.hpp"
#include "tests/geom/meshes.hpp"
#include "tracer/ahead.hpp"

namespace meniscus::geom {

namespace {

struct AimedLine {
    Ray ray;
    Face on = no_face;  // the face that its origin is on
};

AimedLine aimed_line(const TriangleMesh& mesh, Dice& dice) {
    const int count = static_cast<int>(mesh.size());
    const Face face = dice.below(count);
    const auto corners = mesh.corners(face);
    const int kind = dice.below(4);
    Vec3 target = corners[0];
    if (kind == 1) target = 0.5 * (corners[0] + corners[1]);
    if (kind == 2) target = corners[0] + dice.between(0.0, 1.0) * (corners[1] - corners[0]);
    Vec3 d = dice.direction();
    if (dice.below(5) == 0) {
        d = Vec3{0.0};
        d[dice.below(3)] = dice.below(2) == 0 ? 1.0 : -1.0;
    }
    if (kind == 3) {
        const Vec3 way = mesh.corners(dice.below(count))[1] - target;
        if (glm::length(way) > 0.0) d = glm::normalize(way);
    }
    const double distances[] = {0.0, 2.0, 4.0, 1e4};
    const double distance = distances[dice.below(4)];
    return {{target - distance * d, d}, distance == 0.0 ? face : no_face};
}

bool equal(const Crossings& a, const Crossings& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Crossing& x, const Crossing& y) {
                          return x.t == y.t && x.face == y.face && x.entering == y.entering;
                      });
}

/// How deep a line is after its crossings.
int depth_after(const Crossings& found, int depth) {
    for (const Crossing& crossing : found) depth += crossing.entering ? 1 : -1;
    return depth;
}

bool takes_turns(const Crossings& found, bool is_inside) {
    for (const Crossing& crossing : found) {
        if (crossing.entering == is_inside) return false;
        is_inside = crossing.entering;
    }
    return true;
}

void add(const Crossings& found, ParityCount& count) {
    ++count.lines;
    count.crossings += found.size();
}

/// A closed mesh, and the lines that wait until there are enough to take turns.
class ShotMesh {
public:
    ShotMesh(const TriangleSoup& soup, unsigned seed)
        : mesh_(std::make_shared<const TriangleMesh>(soup)),
          shape_(Mesh{mesh_}, Transform{}),
          dice_(seed) {}

    void shoot(Dice& dice, Parity& result) {
        lines_[waiting_++] = aimed_line(*mesh_, dice);
        if (waiting_ == wanted_) search(result);
    }
    void search(Parity& result) {
        search_alone(result);
        search_in_turns(result);
        search_ahead(result);
        waiting_ = 0;
        wanted_ = most - static_cast<std::size_t>(std::max(0, dice_.below(32) - 16));
    }

private:
    static constexpr std::size_t most = 16;

    void search_alone(Parity& result) {
        for (std::size_t i = 0; i < waiting_; ++i) {
            whole_[i].clear();
            mesh_->crossings(lines_[i].ray, whole_[i]);
            add(whole_[i], result.alone);
            result.alone.unbalanced += depth_after(whole_[i], 0) != 0;
            result.alone.out_of_turn += !takes_turns(whole_[i], false);
        }
    }

    void search_in_turns(Parity& result) {
        for (std::size_t i = 0; i < waiting_; ++i) {
            searched_[i].ray = lines_[i].ray;
            searched_[i].search = {};
            searched_[i].found.clear();
        }
        mesh_->crossings({searched_.data(), waiting_});
        for (std::size_t i = 0; i < waiting_; ++i) {
            const Crossings& found = searched_[i].found;
            Crossings alone;
            mesh_->crossings(lines_[i].ray, Search{}, alone);
            result.differing += !equal(found, alone);
            add(found, result.in_turns);
            result.in_turns.unbalanced += depth_after(found, 0) != 0;
        }
    }

    /// What ray `i` says of its start: that it was born where it is, inside of the mesh or outside
    /// of it; how deep it is, rightly or not; or nothing.
    tracer::KnownStart claim(std::size_t i) {
        const double magnitude = max_abs(lines_[i].ray.origin) + mesh_->magnitude();
        tracer::KnownStart start{magnitude, 16.0 * unit_roundoff * magnitude, std::nullopt};
        Crossings behind;
        for (const Crossing& crossing : whole_[i]) {
            if (crossing.t <= 0.0) behind.push_back(crossing);
        }
        int depth = depth_after(behind, 0);
        const int says = dice_.below(8);
        if (lines_[i].on != no_face && says < 6) {
            start.born_on = lines_[i].on;
            start.starts_inside = says < 3;
            depth = start.starts_inside ? 1 : 0;
        } else if (says == 6) {
            depth = 1 - depth;
        }
        if (says != 7) start.depth = depth;
        return start;
    }

    /// As the tracer asks for several rays at once (`LaneHost::meet_mesh`) and for one
    /// (`find_ahead`).
    void search_ahead(Parity& result) {
        for (std::size_t i = 0; i < waiting_; ++i) {
            starts_[i] = claim(i);
            const bool is_hidden = dice_.below(2) == 0;
            Search& search = searched_[i].search;
            search = {.to = dice_.below(4) == 0 ? dice_.between(0.0, 4.0) : infinity,
                      .entering_ends = !is_hidden,
                      .leaving_ends = !is_hidden,
                      .slack = 2e-7 * starts_[i].magnitude,
                      .slack_per_t = 2e-7};
            tracer::begin_ahead(starts_[i], search, own_[i]);
            searched_[i].found.clear();
        }
        mesh_->crossings({searched_.data(), waiting_});
        for (std::size_t i = 0; i < waiting_; ++i) check_ahead(i, result);
    }

    void check_ahead(std::size_t i, Parity& result) {
        auto& [ray, search, found, end] = searched_[i];
        const tracer::KnownStart& start = starts_[i];
        const bool is_sure = mesh_->fits(ray, search, start.depth, 0, found) &&
                             tracer::is_clear_ahead(shape_, ray, start, own_[i], found);
        Crossings alone;
        Search alone_search = search;
        alone_search.own_met = nullptr;
        const bool alone_is_sure = tracer::find_ahead(shape_, ray, start, alone_search, alone);
        ++result.asked;
        result.differing += is_sure != alone_is_sure || (is_sure && !equal(found, alone));
        if (!is_sure) return;
        const int depth = start.depth.value_or(!found.empty() && !found[0].entering);
        add(found, result.ahead);
        result.ahead.unbalanced += end == infinity && depth_after(found, depth) != 0;
        result.ahead.out_of_turn += !takes_turns(found, depth > 0);
        Crossings expected;
        for (const Crossing& crossing : whole_[i]) {
            if (crossing.t > 0.0 && crossing.t <= end && crossing.face != search.own)
                expected.push_back(crossing);
        }
        result.astray += !equal(found, expected);
    }

    std::shared_ptr<const TriangleMesh> mesh_;
    PlacedShape shape_;
    Dice dice_;  // for all but the lines
    std::size_t waiting_ = 0, wanted_ = most;
    std::array<AimedLine, most> lines_;
    std::array<Crossings, most> whole_;
    std::array<SearchedRay, most> searched_;
    std::array<tracer::KnownStart, most> starts_;
    std::array<Crossing, most> own_;
};

/// Coordinates that are floats, which meshes keep as such.
TriangleSoup in_floats(TriangleSoup soup) {
    for (Vec3& p : soup.positions) p = glm::round(p * 0x1p20) * 0x1p-20;
    return soup;
}

}  // namespace

Parity mesh_parity(std::uint64_t lines, unsigned seed) {
    std::vector<TriangleSoup> soups;
    for (const Vec3& place : {Vec3{0.0}, Vec3{148376.0, 1234.0, -223423.0}}) {
        TriangleSoup ring = torus_mesh(96, 48);
        for (Vec3& p : ring.positions) p += place;
        soups.push_back(icosphere(2, 1.0, place));
        soups.push_back(gridded_box(7, place - Vec3{1.0}, place + Vec3{1.0, 0.5, 0.7}));
        soups.push_back(ring);
        soups.push_back(icosphere(6, 1.0, place));  // 81,920 triangles
    }
    soups.push_back(in_floats(torus_mesh(96, 48)));
    soups.push_back(in_floats(icosphere(6)));
    std::vector<ShotMesh> meshes;
    for (const TriangleSoup& soup : soups)
        meshes.emplace_back(soup, static_cast<unsigned>(meshes.size()));
    Dice dice(seed);
    Parity result;
    for (std::uint64_t i = 0; i < lines; ++i) meshes[i % meshes.size()].shoot(dice, result);
    for (ShotMesh& mesh : meshes) mesh.search(result);
    return result;
}

}  // namespace meniscus::geom
