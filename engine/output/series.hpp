// Numbered VTK files with the two indexes that ParaView opens: .pvd and .vtu.series.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace demlua::output {

/// Files NAME_000000.vtu, ... in `folder`. The indexes hold whatever has been added and are whole at any moment.
class Series {
public:
    Series(std::filesystem::path folder, std::string_view name);

    /// Writes the next file and then the indexes. `time` in s. Throws RunError.
    void add(double time, const std::string& vtu);

    [[nodiscard]] std::size_t size() const { return frames_.size(); }

private:
    struct Frame {
        std::string file;
        double time;
    };

    void write_indexes() const;

    std::filesystem::path folder_;
    std::string name_;
    std::vector<Frame> frames_;
};

} // namespace demlua::output
