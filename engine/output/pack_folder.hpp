// A folder of packs, one file each.
#pragma once

#include "engine/packing/pack_store.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace demlua::output {

/// Keeps packs in files named after a hash of their key. A file holds the whole key and a checksum; one that is damaged,
/// or was written by another version, revision or compiler, counts as not there. The folder is made when first needed;
/// where it cannot be, nothing is kept. The oldest files go when there are more than 64.
class PackFolder : public packing::PackStore {
public:
    explicit PackFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

    [[nodiscard]] std::optional<std::string> find(const std::string& key) const override;
    void keep(const std::string& key, const std::string& bytes) const override;

    /// Where the pack with this key is or would be.
    [[nodiscard]] std::filesystem::path file_of(const std::string& key) const;

private:
    void drop_oldest() const;

    std::filesystem::path folder_;
};

} // namespace demlua::output
