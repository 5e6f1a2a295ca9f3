#include "compare/ray_tree_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "tracer/camera_rays.hpp"
#include "tracer/ray_tree.hpp"

namespace meniscus::compare {
namespace {

using tracer::TreeNode;

/// One segment of a ray tree: how it came about and where it ends.
struct Branch {
    std::uint64_t path;  // of it and all before it
    double weight;
};

struct Signature {
    std::vector<Branch> branches;  // sorted by path
    bool inside = false;           // a medium lies behind the first surface
};

Signature signature(const tracer::RenderScene& scene, const tracer::TreeRecord& record,
                    const tracer::FirstHit& first_hit) {
    Signature result;
    result.inside = first_hit.medium != tracer::outside;
    std::vector<std::uint64_t> paths;
    for (const TreeNode& node : record) {
        std::uint64_t path = node.parent < 0 ? 0 : paths[std::size_t(node.parent)];
        const auto add = [&](std::uint64_t word) { path = tracer::mix(path + word); };
        add(std::uint64_t(node.branch));
        if (node.end == TreeNode::End::surface) {
            add(2 + std::uint64_t(scene.parts[std::size_t(node.event.part)].object));
            add(std::uint64_t(node.event.face));
        } else {
            add(1);
        }
        paths.push_back(path);
        result.branches.push_back({path, node.weight});
    }
    std::ranges::sort(result.branches, {}, &Branch::path);
    return result;
}

/// Whether a branch of `a` with some weight is not in `b` at any weight.
bool has_other_branch(const Signature& a, const Signature& b) {
    return std::ranges::any_of(a.branches, [&](const Branch& branch) {
        return branch.weight >= least_weight &&
               !std::ranges::binary_search(b.branches, branch.path, {}, &Branch::path);
    });
}

class Signatures {
public:
    Signatures(const tracer::RenderScene& scene, const tracer::Options& options)
        : scene_(scene), options_(options), tree_(scene, options, statistics_) {
        tree_.record = &record_;
    }

    std::vector<Signature> row(int y) {
        std::vector<Signature> result;
        for (int x = 0; x < options_.width; ++x) {
            record_.clear();
            const auto ray = tracer::camera_ray(scene_.source.camera, x + 0.5, y + 0.5,
                                                options_.width, options_.height);
            tree_.radiance(ray, 0);
            result.push_back(signature(scene_, record_, tree_.first_hit));
        }
        return result;
    }

private:
    const tracer::RenderScene& scene_;
    const tracer::Options& options_;
    tracer::Statistics statistics_;
    tracer::TreeRecord record_;
    tracer::RayTree tree_;
};

}  // namespace

Regions regions_by_ray_trees(const tracer::RenderScene& scene, const tracer::Options& options,
                             const image::Image& picture) {
    Signatures signatures(scene, options);
    auto is_edge = edges_by_contrast(picture);
    std::vector<bool> is_inside(is_edge.size());
    const std::size_t width = std::size_t(options.width);
    std::vector<Signature> before, row;
    const auto compare = [&](const Signature& a, std::size_t i, const Signature& b, std::size_t j) {
        if (is_edge[i] && is_edge[j]) return;
        if (has_other_branch(a, b) || has_other_branch(b, a)) is_edge[i] = is_edge[j] = true;
    };
    for (std::size_t y = 0; y < std::size_t(options.height); ++y) {
        row = signatures.row(int(y));
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t pixel = y * width + x;
            is_inside[pixel] = row[x].inside;
            if (x > 0) compare(row[x], pixel, row[x - 1], pixel - 1);
            if (y == 0) continue;
            const std::size_t last = std::min(x + 1, width - 1);
            for (std::size_t u = x > 0 ? x - 1 : 0; u <= last; ++u)
                compare(row[x], pixel, before[u], pixel - width - x + u);
        }
        before = std::move(row);
    }
    return regions_of(
        is_inside, is_edge,
        fmt::format("by the ray trees of our own picture: inside glass where a medium lies behind "
                    "the first surface; edges where neighbours' trees differ in a branch of weight "
                    "{} or more, or their colours by more than {}",
                    least_weight, edge_contrast));
}

}  // namespace meniscus::compare
