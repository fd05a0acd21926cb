// The calling thread's context and its dispatch table, and the search behind GetProcAddress.
#include "gl/entry.h"

#include <algorithm>
#include <cstring>

#include "gl/context.h"
#include "gl/current.h"
#include "gl/debug_log.h"

namespace terrazzo::gl {

constinit thread_local CurrentContext current = {&kNoContextTable, nullptr};

namespace {

// The debug table stays in front of whatever the context's is.
void use_table(const Context& ctx) {
    if (current.context == &ctx && current.table != &kDebugTable) current.table = ctx.dispatch.table;
}

}  // namespace

void make_current(Context* ctx) {
    current = {!ctx ? &kNoContextTable : debug_enabled() ? &kDebugTable : ctx->dispatch.table, ctx};
}

void set_inside_begin_end(Context& ctx, bool inside) {
    DispatchState& dispatch = ctx.dispatch;
    dispatch.execute = inside ? &kInsideBeginEndTable : &kNormalTable;
    if (dispatch.table == &kCompilingTable) return;
    dispatch.table = dispatch.execute;
    use_table(ctx);
}

void set_compiling(Context& ctx, bool compiling) {
    ctx.dispatch.table = compiling ? &kCompilingTable : ctx.dispatch.execute;
    use_table(ctx);
}

ProcAddress find_proc_address(const char* name) {
    const NamedAddress* end = kProcAddresses + kProcAddressCount;
    const NamedAddress* found = std::lower_bound(
        kProcAddresses, end, name,
        [](const NamedAddress& entry, const char* wanted) { return std::strcmp(entry.name, wanted) < 0; });
    return found != end && std::strcmp(found->name, name) == 0 ? found->address : nullptr;
}

}  // namespace terrazzo::gl
