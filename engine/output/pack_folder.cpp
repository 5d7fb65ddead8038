#include "engine/output/pack_folder.hpp"

#include "engine/base/problems.hpp"
#include "engine/base/random.hpp"
#include "engine/output/whole_file.hpp"

#include "demlua/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace demlua::output {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view ending = ".pack";
constexpr std::size_t most_files = 64;
constexpr std::size_t digits = 16; ///< of a hash

std::string hash_of(std::string_view text) {
    std::uint64_t hash = text.size();
    for (std::size_t k = 0; k < text.size(); k += sizeof hash) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data() + k, std::min(sizeof word, text.size() - k));
        hash = mixed_bits(hash ^ word);
    }
    return fmt::format("{:016x}", hash);
}

/// Whoever packs differently must not find this pack.
std::string full_key(const std::string& key) {
    return fmt::format("demlua {} {} {} {}\n{}\n", version, revision, compiler, build_type, key.size()) + key;
}

} // namespace

fs::path PackFolder::file_of(const std::string& key) const {
    return folder_ / (hash_of(full_key(key)) + std::string(ending));
}

std::optional<std::string> PackFolder::find(const std::string& key) const {
    std::ifstream stream(file_of(key), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const std::string head = full_key(key);
    if (text.size() < digits + head.size()) return std::nullopt;
    const std::string_view checked = std::string_view(text).substr(digits);
    if (text.compare(0, digits, hash_of(checked)) != 0) return std::nullopt;
    if (checked.substr(0, head.size()) != head) return std::nullopt;
    return std::string(checked.substr(head.size()));
}

void PackFolder::keep(const std::string& key, const std::string& bytes) const {
    try {
        const std::string checked = full_key(key) + bytes;
        fs::create_directories(folder_);
        replace_file(file_of(key), hash_of(checked) + checked);
        drop_oldest();
    } catch (const fs::filesystem_error&) { // nothing is kept then, and the next run packs again
        return;
    } catch (const RunError&) {
        return;
    }
}

void PackFolder::drop_oldest() const {
    std::vector<std::pair<fs::file_time_type, fs::path>> packs;
    for (const auto& entry : fs::directory_iterator(folder_)) {
        if (entry.path().extension() == ending) packs.emplace_back(entry.last_write_time(), entry.path());
    }
    if (packs.size() <= most_files) return;
    std::sort(packs.begin(), packs.end());
    packs.resize(packs.size() - most_files);
    std::error_code ignored;
    for (const auto& [time, file] : packs) fs::remove(file, ignored);
}

} // namespace demlua::output
