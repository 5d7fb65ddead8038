#include "engine/packing/pack_store.hpp"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace demlua::packing {

namespace {

template <class T>
void append(std::string& bytes, const T& value) {
    static_assert(std::is_arithmetic_v<T>);
    const std::size_t end = bytes.size();
    bytes.resize(end + sizeof value);
    std::memcpy(bytes.data() + end, &value, sizeof value);
}

void append(std::string& bytes, Vec2 v) {
    append(bytes, v.x);
    append(bytes, v.y);
}

void append(std::string& bytes, const model::Region& region) {
    append(bytes, region.bounds().lower);
    append(bytes, region.bounds().upper);
    append(bytes, static_cast<std::uint64_t>(region.boundary().size()));
    for (const model::Piece& piece : region.boundary()) {
        append(bytes, piece.origin);
        append(bytes, piece.direction);
        append(bytes, piece.radius);
        append(bytes, piece.begin);
        append(bytes, piece.end);
        append(bytes, piece.around_hole);
    }
}

template <class T>
void append_all(std::string& bytes, const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t end = bytes.size();
    if (values.empty()) return;
    bytes.resize(end + values.size() * sizeof(T));
    std::memcpy(bytes.data() + end, values.data(), values.size() * sizeof(T));
}

/// Takes `count` values from `bytes` at `at`, which must hold them.
template <class T>
void take_all(const std::string& bytes, std::size_t& at, std::size_t count, std::vector<T>& values) {
    values.resize(count);
    if (count == 0) return;
    std::memcpy(values.data(), bytes.data() + at, count * sizeof(T));
    at += count * sizeof(T);
}

constexpr std::size_t bytes_of_element = sizeof(Vec2) + sizeof(double) + sizeof(Index) + sizeof(double);

} // namespace

std::optional<std::string> inputs_of(const model::Region& region, const Consolidation& settings) {
    std::string bytes = "consolidated";
    append(bytes, region);
    append(bytes, settings.cluster);
    append(bytes, settings.count);
    append(bytes, settings.radius);
    append(bytes, settings.solid_fraction);
    append(bytes, settings.relax);
    append(bytes, settings.seed);
    return bytes;
}

std::optional<std::string> inputs_of(const model::Region& region, const Relaxation& settings) {
    if (settings.size) return std::nullopt;
    std::string bytes = "relaxed";
    append(bytes, region);
    append(bytes, settings.count);
    append(bytes, settings.spacing);
    append(bytes, settings.steps);
    append(bytes, settings.on_boundary);
    append(bytes, settings.boundary_within);
    append(bytes, settings.seed);
    return bytes;
}

std::optional<std::string> inputs_of(const model::Region& region, const model::GrainPacking& settings) {
    if (settings.method == model::Placing::insertion) return std::nullopt;
    std::string bytes = "grains";
    append(bytes, region);
    append(bytes, settings.elements);
    append(bytes, static_cast<std::uint64_t>(settings.disks.size()));
    for (const model::Disk& disk : settings.disks) {
        append(bytes, disk.centre);
        append(bytes, disk.radius);
    }
    append(bytes, static_cast<std::uint64_t>(settings.sizes.size()));
    for (const model::SizeClass& each : settings.sizes) {
        append(bytes, each.least);
        append(bytes, each.greatest);
        append(bytes, each.share);
    }
    append(bytes, static_cast<int>(settings.method));
    append(bytes, settings.porosity.value_or(0.0));
    append(bytes, settings.count);
    append(bytes, settings.removed);
    append(bytes, settings.seed);
    return bytes;
}

std::string bytes_of(const Packing& packing) {
    std::string bytes;
    append_all(bytes, packing.centre);
    append_all(bytes, packing.radius);
    append_all(bytes, packing.cluster);
    append_all(bytes, packing.cell_area);
    return bytes;
}

std::optional<Packing> packing_of(const std::string& bytes) {
    if (bytes.size() % bytes_of_element != 0) return std::nullopt;
    const std::size_t count = bytes.size() / bytes_of_element;
    std::size_t at = 0;
    Packing packing;
    take_all(bytes, at, count, packing.centre);
    take_all(bytes, at, count, packing.radius);
    take_all(bytes, at, count, packing.cluster);
    take_all(bytes, at, count, packing.cell_area);
    return packing;
}

} // namespace demlua::packing
