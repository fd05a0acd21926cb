// The calling thread's context and the dispatch table its GL calls go through.
//
// An exported function is one TLS load and one indirect call: `current.table->Foo(current.context, ...)`. The
// table stands for the state the context is in (no context, normal, between Begin and End, compiling a list),
// so commands do not test for it. Invariant: `table` is never null; `context` is null exactly when no context
// is current.
#pragma once

namespace terrazzo::gl {

struct Context;
struct Dispatch;

struct CurrentContext {
    const Dispatch* table;
    Context* context;
};

// initial-exec: one load from the thread pointer, also in a library that was loaded at run time.
extern constinit thread_local CurrentContext current
    __attribute__((tls_model("initial-exec"), visibility("hidden")));

extern const Dispatch kNormalTable;
extern const Dispatch kInsideBeginEndTable;
extern const Dispatch kCompilingTable;  // listable commands are recorded, others go to DispatchState::execute
extern const Dispatch kNoContextTable;
extern const Dispatch kDebugTable;  // notes the command's name and goes on to DispatchState::table

// The part of a context that says which tables its calls go through.
struct DispatchState {
    const Dispatch* execute = &kNormalTable;  // kNormalTable or kInsideBeginEndTable
    const Dispatch* table =
        &kNormalTable;  // kCompilingTable while a list is compiled, else equal to `execute`
};

// Makes `ctx` the calling thread's context; null releases. The front end has made sure that no other thread
// uses it.
void make_current(Context* ctx);

// Called by Begin and End.
void set_inside_begin_end(Context& ctx, bool inside);

// Called by NewList and EndList.
void set_compiling(Context& ctx, bool compiling);

}  // namespace terrazzo::gl
