#include "scripting/grains.hpp"

#include <map>
#include <utility>

namespace demlua::scripting {

using namespace model;

namespace {

/// Reads a table of settings that is an item of a list.
template <class T>
bool read_item(const Value& item, const WordOf<T>& word, T& said) {
    Call call = item.call;
    call.label = item.what;
    return read(call, item.index, word, said);
}

} // namespace

void read_sizes(const Value& value, const Slot& slot, std::vector<SizeClass>& sizes) {
    sizes.clear();
    lua_State* const L = value.call.L;
    if (lua_type(L, value.index) == LUA_TNUMBER) {
        if (const auto size = value.number(value.index, slot)) sizes.push_back({*size, *size, 1.0});
        return;
    }
    const bool list = lua_type(L, value.index) == LUA_TTABLE && lua_rawlen(L, value.index) > 0;
    if (!list) return value.wrong_type(slot);
    const bool numbers = lua_rawgeti(L, value.index, 1) == LUA_TNUMBER;
    lua_pop(L, 1);
    if (!numbers) {
        for_each_item(value, slot, [&sizes](const Value& item) {
            SizeClass each;
            if (!read_item(item, words::size_class(), each)) return;
            each.greatest = each.least;
            sizes.push_back(each);
        });
        return;
    }
    if (lua_rawlen(L, value.index) != 2) return value.wrong_type(slot);
    std::vector<double> ends;
    for_each_item(value, slot, [&](const Value& item) {
        if (const auto end = item.number(item.index, slot)) ends.push_back(*end);
    });
    if (ends.size() == 2) sizes.push_back({ends.front(), ends.back(), 1.0});
}

void read_listed(const Value& value, const Slot& slot, ListedDisks& listed) {
    listed = {};
    std::map<double, std::uint32_t> number;
    bool numbered = false;
    for_each_item(value, slot, [&](const Value& item) {
        DiskSaid said;
        if (!read_item(item, words::disk(), said)) return;
        if (listed.disks.empty()) numbered = said.cluster.has_value();
        if (said.cluster.has_value() != numbered) {
            item.call.complain(item.what + ".cluster", "", "must be given for all disks or for none", "",
                               Cause::wording);
        }
        listed.disks.push_back({{said.x, said.y}, said.radius});
        if (!said.cluster) return;
        const auto next = static_cast<std::uint32_t>(number.size());
        listed.clusters.push_back(number.emplace(*said.cluster, next).first->second);
    });
}

Body body_of(const GrainsSaid& said) {
    Body body;
    body.name = said.name;
    body.material = said.material;
    body.region = said.region;
    body.bonds = said.shape.bonds;
    body.rigid = said.shape.rigid;
    body.in_clusters = true;
    body.velocity = said.velocity;
    body.place = said.place;
    GrainPacking packing;
    packing.elements = said.shape.elements;
    packing.disks = said.shape.disks;
    packing.sizes = said.sizes;
    packing.method = said.method;
    packing.porosity = said.porosity;
    packing.count = said.count;
    packing.removed = said.removed;
    packing.seed = said.seed;
    body.packing = std::move(packing);
    return body;
}

} // namespace demlua::scripting
