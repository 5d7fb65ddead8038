#include "scripting/program.hpp"

int main(int argc, char** argv) { return demlua::scripting::run_program(argc, argv); }
