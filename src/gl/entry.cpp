// The calling thread's context, and the search behind GetProcAddress.
#include "gl/entry.h"

#include <algorithm>
#include <cstring>

#include "gl/current.h"

namespace terrazzo::gl {

constinit thread_local CurrentContext current = {&kNoContextTable, nullptr};

void make_current(Context* ctx) {
    current = {ctx ? &kNormalTable : &kNoContextTable, ctx};
}

ProcAddress find_proc_address(const char* name) {
    const NamedAddress* end = kProcAddresses + kProcAddressCount;
    const NamedAddress* found = std::lower_bound(
        kProcAddresses, end, name,
        [](const NamedAddress& entry, const char* wanted) { return std::strcmp(entry.name, wanted) < 0; });
    return found != end && std::strcmp(found->name, name) == 0 ? found->address : nullptr;
}

}  // namespace terrazzo::gl
