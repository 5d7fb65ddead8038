// The kernels of each width, each from a file compiled for it.
#pragma once

namespace demlua::step {

struct Kernels;

const Kernels& lanes_1();
const Kernels& lanes_2();
const Kernels& lanes_4();
const Kernels& lanes_8();

} // namespace demlua::step
