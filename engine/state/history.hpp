// Columns for what a law remembers: one per member of its History, none for a law that remembers nothing.
#pragma once

#include "engine/base/struct_columns.hpp"

namespace demlua::state {

template <class History>
using HistoryColumns = StructColumns<History>;

/// For tables that are sized once, and in which most rows remember nothing.
template <class History>
using LazyHistoryColumns = StructColumns<History, ZeroColumn>;

} // namespace demlua::state
