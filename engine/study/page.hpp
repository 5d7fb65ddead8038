// What a study looks like: its two pictures, and one page that holds everything.
#pragma once

#include "engine/study/study.hpp"

#include <string>

namespace demlua::study {

/// |error| against size, one curve for each series, with the fitted slope.
std::string error_size_svg(const Study& study);
/// |error| against wall time: the work-precision picture.
std::string error_time_svg(const Study& study);

/// A page of HTML that needs nothing else: table, notes and both pictures. `version` is that of the program.
std::string page_of(const Study& study, const std::string& version);

} // namespace demlua::study
