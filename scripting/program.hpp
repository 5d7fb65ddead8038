// The program behind the command line.
#pragma once

namespace demlua::scripting {

/// Does what the command line asks. Returns the exit code: 0 done, 2 something wrong with scene or command line and
/// nothing written, 3 the run failed, 130 interrupted.
int run_program(int argc, const char* const* argv);

} // namespace demlua::scripting
