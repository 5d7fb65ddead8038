// Columns for what a law remembers: one per member of its History, none for a law that remembers nothing.
#pragma once

#include "engine/base/struct_columns.hpp"

namespace demlua::state {

template <class History>
using HistoryColumns = StructColumns<History>;

} // namespace demlua::state
