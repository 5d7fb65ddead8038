// Catch2, version 3 or 2 (2.13), whichever is installed.
#pragma once

#if __has_include(<catch2/catch_test_macros.hpp>)

#include <catch2/catch_approx.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_all.hpp>

#else

#include <catch2/catch.hpp>

#include <string>

namespace Catch {

using Detail::Approx; // where version 3 has it

namespace Matchers {

// The name version 3 gives to the matcher for a part of a string.
inline auto ContainsSubstring(const std::string& part) { return Contains(part); }

} // namespace Matchers
} // namespace Catch

#endif
