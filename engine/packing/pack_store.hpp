// Packs kept from one run to the next.
#pragma once

#include "engine/packing/packing.hpp"

#include <optional>
#include <string>

namespace demlua::packing {

/// Keeps bytes under keys of any length. What it gives back is what it was given, or nothing; it never fails.
class PackStore {
public:
    PackStore() = default;
    virtual ~PackStore() = default;
    PackStore(const PackStore&) = delete;
    PackStore& operator=(const PackStore&) = delete;
    PackStore(PackStore&&) = delete;
    PackStore& operator=(PackStore&&) = delete;

    [[nodiscard]] virtual std::optional<std::string> find(const std::string& key) const = 0;
    virtual void keep(const std::string& key, const std::string& bytes) const = 0;
};

/// Everything a pack follows from, number for number: the pieces of the boundary and the settings. Nothing where the
/// user's function has a say, or where making grains anew is as quick as reading them.
std::optional<std::string> inputs_of(const model::Region& region, const Consolidation& settings);
std::optional<std::string> inputs_of(const model::Region& region, const Relaxation& settings);
std::optional<std::string> inputs_of(const model::Region& region, const model::GrainPacking& settings);

/// A pack as bytes, as this machine writes numbers, and back; nothing where the bytes are no pack.
std::string bytes_of(const Packing& packing);
std::optional<Packing> packing_of(const std::string& bytes);

/// The pack that `make` makes, from the store if it has it, and the same to the last bit. Without a store it is made.
template <class Settings, class Make>
Packing kept(const PackStore* store, const model::Region& region, const Settings& settings, const Make& make) {
    const std::optional<std::string> key = store == nullptr ? std::nullopt : inputs_of(region, settings);
    if (!key) return make(region, settings);
    if (const std::optional<std::string> bytes = store->find(*key)) {
        if (std::optional<Packing> found = packing_of(*bytes)) return *std::move(found);
    }
    Packing made = make(region, settings);
    store->keep(*key, bytes_of(made));
    return made;
}

} // namespace demlua::packing
