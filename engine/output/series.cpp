#include "engine/output/series.hpp"

#include "engine/output/whole_file.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

namespace demlua::output {

Series::Series(std::filesystem::path folder, std::string_view name) : folder_(std::move(folder)), name_(name) {}

void Series::add(double time, const std::string& vtu) {
    std::string file = fmt::format("{}_{:06}.vtu", name_, frames_.size());
    replace_file(folder_ / file, vtu);
    frames_.push_back({std::move(file), time});
    write_indexes();
}

void Series::write_indexes() const {
    std::string pvd = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
    std::string series = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [";
    const char* separator = "\n";
    for (const Frame& frame : frames_) {
        fmt::format_to(std::back_inserter(pvd), "    <DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n",
                       frame.time, frame.file);
        fmt::format_to(std::back_inserter(series), "{}    {{\"name\": \"{}\", \"time\": {}}}", separator, frame.file,
                       frame.time);
        separator = ",\n";
    }
    pvd += "  </Collection>\n</VTKFile>\n";
    series += "\n  ]\n}\n";
    replace_file(folder_ / (name_ + ".pvd"), pvd);
    replace_file(folder_ / (name_ + ".vtu.series"), series);
}

} // namespace demlua::output
