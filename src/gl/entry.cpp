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

const Dispatch* entry_table(const Context* ctx) {
    if (!ctx) return &kNoContextTable;
    return debug_enabled() ? &kDebugTable : ctx->dispatch.table;
}

}  // namespace

void make_current(Context* ctx) {
    current = {entry_table(ctx), ctx};
}

void set_inside_begin_end(Context& ctx, bool inside) {
    DispatchState& dispatch = ctx.dispatch;
    dispatch.execute = inside ? &kInsideBeginEndTable : &kNormalTable;
    if (dispatch.table == &kCompilingTable) return;
    dispatch.table = dispatch.execute;
    if (current.context == &ctx) current.table = entry_table(&ctx);
}

void set_compiling(Context& ctx, bool compiling) {
    ctx.dispatch.table = compiling ? &kCompilingTable : ctx.dispatch.execute;
    if (current.context == &ctx) current.table = entry_table(&ctx);
}

ProcAddress find_proc_address(const char* name) {
    const NamedAddress* end = kProcAddresses + kProcAddressCount;
    const NamedAddress* found = std::lower_bound(
        kProcAddresses, end, name,
        [](const NamedAddress& entry, const char* wanted) { return std::strcmp(entry.name, wanted) < 0; });
    return found != end && std::strcmp(found->name, name) == 0 ? found->address : nullptr;
}

}  // namespace terrazzo::gl
