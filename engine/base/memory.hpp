// Memory that is no longer used, back to the system.
#pragma once

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace demlua {

/// What has been freed since the start of the program and is still kept for later. To be called where much has been freed and
/// little will be asked for; takes milliseconds where there is much.
inline void give_back_memory() {
#if defined(__GLIBC__)
    malloc_trim(0);
#endif
}

} // namespace demlua
