#include "engine/model/check_grains.hpp"

#include "engine/base/disjoint_sets.hpp"
#include "engine/model/setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace demlua::model {

namespace {

constexpr double touching = 1e-6; ///< gap, over the sum of radii, across which listed disks still touch

/// The first disk, counted from 1, that does not hang together with the first; 0 where all do.
std::size_t first_apart(const std::vector<Disk>& disks) {
    DisjointSets sets(disks.size());
    for (std::size_t i = 0; i < disks.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const double reach = (1.0 + touching) * (disks[i].radius + disks[k].radius);
            if (norm(disks[i].centre - disks[k].centre) <= reach) sets.join(i, k);
        }
    }
    for (std::size_t i = 1; i < disks.size(); ++i) {
        if (sets.root(i) != 0) return i + 1;
    }
    return 0;
}

bool said(const BondChoice& bonds) { return !std::holds_alternative<NoBonds>(bonds); }

} // namespace

std::vector<Problem> cluster_problems(const Cluster& cluster) {
    std::vector<Problem> problems;
    const Place elsewhere; // whoever read the cluster knows where
    const auto add = [&](const char* what, std::string value, const char* rule, const char* hint) {
        problems.push_back({elsewhere, std::string("cluster.") + what, std::move(value), rule, hint});
    };
    if ((cluster.elements == 0) == cluster.disks.empty()) {
        add("elements", cluster.elements == 0 ? "" : std::to_string(cluster.elements),
            "exactly one of elements and disks must be given", "");
        return problems;
    }
    if (const std::size_t apart = first_apart(cluster.disks); apart > 0) {
        add("disks", fmt::format("{} of them", cluster.disks.size()),
            "each disk must touch or overlap another of its cluster, directly or through others",
            fmt::format("nothing joins number {} to the first", apart).c_str());
    }
    if (cluster.rigid && said(cluster.bonds)) {
        add("rigid", "true", "must not be given beside bonds", "a rigid cluster needs none");
    }
    if (std::max<std::size_t>(cluster.disks.size(), static_cast<std::size_t>(cluster.elements)) == 1 &&
        said(cluster.bonds)) {
        add("bonds", "", "have nothing to hold together: the cluster is a single disk",
            "leave them away or take more elements");
    }
    return problems;
}

std::vector<Problem> grain_problems(const Body& body, const GrainPacking& packing) {
    std::vector<Problem> problems;
    const auto add = [&](const std::string& what, std::string value, std::string rule, std::string hint = {}) {
        problems.push_back({body.place, "grains." + what, std::move(value), std::move(rule), std::move(hint)});
    };
    double largest = 0.0;
    for (const SizeClass& sizes : packing.sizes) {
        largest = std::max(largest, sizes.greatest);
        if (sizes.least <= sizes.greatest) continue;
        add("radius", fmt::format("{{ {}, {} }}", sizes.least, sizes.greatest), "the first must not exceed the second");
    }
    const bool rain = packing.method == Placing::rain;
    if (packing.porosity && packing.count > 0) {
        add("count", std::to_string(packing.count), "must not be given beside porosity", "each follows from the other");
    } else if (!rain && !packing.porosity && packing.count == 0) {
        add("porosity", "", "is missing: this or count must be given", "only rain can fill the region by itself");
    }
    const Vec2 size = body.region.bounds().size();
    if (size.x < 2.0 * largest || size.y < 2.0 * largest) {
        add("region", fmt::format("{} m by {} m", size.x, size.y),
            fmt::format("is too small for an element of radius {} m", largest));
    }
    return problems;
}

std::vector<Problem> cluster_problems(const Body& body) {
    std::vector<Problem> problems;
    const std::optional<Network> network = network_of(body);
    const bool shared_out = network == Network::facets || network == Network::delaunay;
    const std::string name = '"' + body.name + '"';
    const auto removes = [](const auto& packing) { return packing.removed > 0.0; };
    const auto* close = std::get_if<ClosePacking>(&body.packing);
    const auto* pressed = std::get_if<Consolidation>(&body.packing);
    if (shared_out && ((close != nullptr && removes(*close)) || (pressed != nullptr && removes(*pressed)))) {
        problems.push_back({body.place, close != nullptr ? "close_packed.removed" : "consolidated.removed", "",
                            "would leave no holes: the cells of body " + name + " share out the whole region",
                            R"(take bonds with stiffness = "contacts" or "unit cell")"});
    }
    if (!body.in_clusters) return problems;
    const auto* listed = std::get_if<ListedDisks>(&body.packing);
    const bool comes_in_clusters = (pressed != nullptr && pressed->cluster > 1 && pressed->relax == 0) ||
                                   (listed != nullptr && !listed->clusters.empty()) ||
                                   std::holds_alternative<GrainPacking>(body.packing);
    if (!comes_in_clusters) {
        problems.push_back({body.place, "body.in_clusters", "true", "needs a packing that comes in clusters",
                            "such as dem.consolidated, or dem.disks with a cluster given for each"});
    }
    if (shared_out) {
        problems.push_back({body.place, "body.bonds", "",
                            "across facets cannot hold clusters together one by one: cells share out the whole region",
                            R"(take stiffness = "contacts")"});
    }
    return problems;
}

} // namespace demlua::model
