// dem.study as it is read.
#pragma once

#include "scripting/context.hpp"

namespace demlua::scripting {

/// At the end of a reading, when all parameters are known: checks what the study says of them and asks its functions.
void finish_study(Context& context);

} // namespace demlua::scripting
