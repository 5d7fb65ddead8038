#include "scripting/kept_packs.hpp"

#include "engine/output/pack_folder.hpp"

#include "demlua/version.hpp"

#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace demlua::scripting {

namespace {

/// What a variable holds; empty where it is not set.
std::string_view variable(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? "" : value;
}

std::filesystem::path folder() {
    if (std::getenv("DEMLUA_CACHE") != nullptr) return variable("DEMLUA_CACHE");
    if (std::string_view(revision).find("-dirty") != std::string_view::npos) return {};
    if (!variable("XDG_CACHE_HOME").empty()) return std::filesystem::path(variable("XDG_CACHE_HOME")) / "demlua";
    if (!variable("HOME").empty()) return std::filesystem::path(variable("HOME")) / ".cache" / "demlua";
    return {};
}

} // namespace

std::shared_ptr<const packing::PackStore> kept_packs() {
    const std::filesystem::path where = folder();
    if (where.empty()) return nullptr;
    return std::make_shared<output::PackFolder>(where);
}

} // namespace demlua::scripting
