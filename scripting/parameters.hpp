// Parameters a scene declares and a command line or an including scene sets.
#pragma once

#include "scripting/context.hpp"

namespace demlua::scripting {

/// At the end of a scene: what was set but never declared, and inclusions never finished.
void complain_of_leftovers(Context& context);

} // namespace demlua::scripting
